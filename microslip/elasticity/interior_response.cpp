#include "microslip/elasticity/interior_response.hpp"

#include "microslip/elasticity/layer_waves.hpp"

#include <algorithm>
#include <complex>

namespace microslip {
namespace {

/// Sizes of waves: those downwards at a layer's top, those upwards at its bottom. Columns are tractions.
template <class Number> struct Amplitudes {
  Matrix2<Number> down, up{};
  Number down_across, up_across{};
};

/// Tractions (sigma_ln/i, sigma_nn) of p_l = i and p_n = 1, and sigma_tn of p_t = 1.
template <class Number> struct Load {
  Matrix2<Number> in_plane{-1, 0, 0, -1};
  Number across = -1;
};

template <class Number>
Amplitudes<Number> in_layer(const StackMaterial<Number>& material, double q, const Reflection<Number>& reflection,
                            const Load<Number>& load) {
  const auto& [modulus, nu] = material;
  const Matrix2<Number> tractions = downward(nu, 0).traction + upward(nu, q).traction * reflection.in_plane;
  Amplitudes<Number> a;
  a.down = tractions.inverse() * load.in_plane * (Number(1) / modulus);
  a.up = reflection.in_plane * a.down;
  a.down_across = -load.across / (modulus * (1.0 - std::exp(-q) * reflection.across));
  a.up_across = reflection.across * a.down_across;
  return a;
}

template <class Number>
Amplitudes<Number> in_substrate(const StackMaterial<Number>& material, const Load<Number>& load) {
  const auto& [modulus, nu] = material;
  Amplitudes<Number> a;
  a.down = downward(nu, 0).traction.inverse() * load.in_plane * (Number(1) / modulus);
  a.down_across = -load.across / modulus;
  return a;
}

/// Takes those of the half-space away that has the same load: what is left is as small as what goes up.
template <class Number> void take_half_space(const StackMaterial<Number>& material, double q, Amplitudes<Number>& a) {
  const auto& [modulus, nu] = material;
  a.down = downward(nu, 0).traction.inverse() * upward(nu, q).traction * a.up * Number(-1);
  a.down_across = std::exp(-q) * a.up_across;
}

/// The load of what is below a layer.
template <class Number>
Load<Number> load_below(const StackMaterial<Number>& material, double q, const Amplitudes<Number>& a) {
  const auto& [modulus, nu] = material;
  return {(downward(nu, q).traction * a.down + upward(nu, 0).traction * a.up) * modulus,
          (a.up_across - std::exp(-q) * a.down_across) * modulus};
}

/// State at q = k z below the top of a layer and `above_bottom` k times its height above the bottom.
template <class Number>
InteriorResponse<Number> state(const StackMaterial<Number>& material, double q, double above_bottom,
                               const Amplitudes<Number>& a) {
  const auto& [modulus, nu] = material;
  const Waves<Number> down = downward(nu, q), up = upward(nu, above_bottom);
  const Matrix2<Number> u = down.displacement * a.down + up.displacement * a.up;
  const Matrix2<Number> p = (down.traction * a.down + up.traction * a.up) * modulus;
  const Matrix2<Number> s = (down.lateral * a.down + up.lateral * a.up) * modulus;
  const Number down_across = std::exp(-q) * a.down_across, up_across = std::exp(-above_bottom) * a.up_across;
  const Number t = down_across + up_across;
  return {{u.b, u.d, p.b, p.d, s.b, s.d},
          {u.a, u.c, p.a, p.c, s.a, s.c},
          t,
          (up_across - down_across) * modulus,
          t * modulus};
}

} // namespace

std::array<double, LayeredBody::most_layers> bottoms_of(const LayeredBody& body) {
  std::array<double, LayeredBody::most_layers> bottoms{};
  double depth = 0;
  for (std::size_t n = 0; n < body.layers.size(); ++n) bottoms[n] = depth += body.layers[n].thickness;
  return bottoms;
}

LayerDepth layer_at(const LayeredBody& body, double depth) {
  constexpr double rounding = 1e-12;
  const auto bottoms = bottoms_of(body);
  for (std::size_t n = 0; n < body.layers.size(); ++n)
    if (depth <= bottoms[n] * (1 + rounding)) {
      const double thickness = body.layers[n].thickness;
      return {n, std::clamp(depth - (n == 0 ? 0 : bottoms[n - 1]), 0.0, thickness)};
    }
  return {body.layers.size(), body.layers.empty() ? depth : depth - bottoms[body.layers.size() - 1]};
}

template <class Number>
InteriorResponse<Number> interior_response(const LayerStack<Number>& stack, const LayerDepth& at, double k) {
  const LayerReflections<Number> reflections(stack, k);
  const double q = k * at.below_top;
  Load<Number> load;
  for (std::size_t n = 0; n < stack.layers.size(); ++n) {
    const auto& [thickness, material] = stack.layers[n];
    Amplitudes<Number> a = in_layer(material, k * thickness, reflections.of_layer[n], load);
    if (n == at.layer) {
      if (n == 0) take_half_space(material, k * thickness, a);
      return state(material, q, k * (thickness - at.below_top), a);
    }
    load = load_below(material, k * thickness, a);
  }
  return state(*stack.substrate, q, 0, in_substrate(*stack.substrate, load));
}

template InteriorResponse<double> interior_response(const LayerStack<double>&, const LayerDepth&, double);
template InteriorResponse<std::complex<double>> interior_response(const LayerStack<std::complex<double>>&,
                                                                  const LayerDepth&, double);

} // namespace microslip
