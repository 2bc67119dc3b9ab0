#include "microslip/elasticity/layered_response.hpp"

#include <cmath>
#include <complex>

namespace microslip {
namespace {

/// Rows are components, columns the two waves or the two tractions.
template <class Number> struct Matrix2 {
  Number a, b, c, d;

  Matrix2 operator+(const Matrix2& o) const { return {a + o.a, b + o.b, c + o.c, d + o.d}; }
  Matrix2 operator-(const Matrix2& o) const { return {a - o.a, b - o.b, c - o.c, d - o.d}; }
  Matrix2 operator*(const Matrix2& o) const {
    return {a * o.a + b * o.c, a * o.b + b * o.d, c * o.a + d * o.c, c * o.b + d * o.d};
  }
  Matrix2 operator*(const Number& f) const { return {a * f, b * f, c * f, d * f}; }
  Matrix2 inverse() const {
    const Number f = Number(1) / (a * d - b * c);
    return {d * f, -b * f, -c * f, a * f};
  }
};

/// Displacements (U, W) = (u_l/i, u_n) and tractions (sigma_ln/(i G), sigma_nn/G)/k of two waves.
template <class Number> struct Waves { Matrix2<Number> displacement, traction; };

/// Waves that decay downwards, at q = k z >= 0, z the depth below where they are of unit size.
template <class Number> Waves<Number> downward(const Number& nu, double q) {
  const Number e = std::exp(-q);
  return {{e, -q * e, -e, (3.0 - 4.0 * nu + q) * e},
          {-2.0 * e, (2.0 - 4.0 * nu + 2 * q) * e, 2.0 * e, -(4.0 - 4.0 * nu + 2 * q) * e}};
}

/// Waves that decay upwards, at the height q = k z >= 0 above where they are of unit size.
template <class Number> Waves<Number> upward(const Number& nu, double q) {
  const Number e = std::exp(-q);
  return {{e, q * e, e, (3.0 - 4.0 * nu + q) * e},
          {2.0 * e, (2.0 - 4.0 * nu + 2 * q) * e, 2.0 * e, (4.0 - 4.0 * nu + 2 * q) * e}};
}

/// k times the map from tractions to displacements on a half-space's surface, times G.
template <class Number> Matrix2<Number> half_space(const Number& nu) {
  const Waves<Number> waves = downward(nu, 0);
  return waves.displacement * waves.traction.inverse();
}

/// What a layer's surface adds to the half-space of its material, times k, with `below` the map of what is below.
template <class Number>
Matrix2<Number> rest_in_plane(const StackMaterial<Number>& material, double q, const Matrix2<Number>& below) {
  const auto& [modulus, nu] = material;
  const Matrix2<Number> flexible = below * modulus;
  const Waves<Number> down = downward(nu, q), up = upward(nu, 0);
  const Matrix2<Number> reflection =
      (up.displacement - flexible * up.traction).inverse() * (flexible * down.traction - down.displacement);
  const Waves<Number> down_at_top = downward(nu, 0), up_at_top = upward(nu, q);
  const Matrix2<Number> added = (up_at_top.displacement - half_space(nu) * up_at_top.traction) * reflection;
  const Matrix2<Number> tractions = down_at_top.traction + up_at_top.traction * reflection;
  return added * tractions.inverse() * (Number(1) / modulus);
}

/// Reflection of shear waves across k, with the flexibility k/Z of what is below.
template <class Number> Number reflection_across(const Number& modulus, double q, const Number& flexibility) {
  return std::exp(-2 * q) * (modulus * flexibility - 1.0) / (modulus * flexibility + 1.0);
}

} // namespace

template <class Number> SurfaceResponse<Number> rest_of_response(const LayerStack<Number>& stack, double k) {
  Matrix2<Number> below{}, rest{};
  Number flexibility = 0, rest_across = 0;
  if (stack.substrate) {
    below = half_space(stack.substrate->poisson_ratio) * (Number(1) / stack.substrate->shear_modulus);
    flexibility = Number(1) / stack.substrate->shear_modulus;
  }
  for (auto layer = stack.layers.rbegin(); layer != stack.layers.rend(); ++layer) {
    const auto& [modulus, nu] = layer->material;
    const double q = k * layer->thickness;
    rest = rest_in_plane(layer->material, q, below);
    below = half_space(nu) * (Number(1) / modulus) + rest;
    const Number r = reflection_across(modulus, q, flexibility);
    rest_across = 2.0 * r / ((1.0 - r) * modulus);
    flexibility = (1.0 + r) / ((1.0 - r) * modulus);
  }
  return {-rest.d, -rest.a, rest_across, -rest.b};
}

template SurfaceResponse<double> rest_of_response(const LayerStack<double>&, double);
template SurfaceResponse<std::complex<double>> rest_of_response(const LayerStack<std::complex<double>>&, double);

} // namespace microslip
