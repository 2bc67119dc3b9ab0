#pragma once

#include "microslip/elasticity/layered_body.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace microslip {

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

/// Displacements (U, W) = (u_l/i, u_n), tractions (sigma_ln/i, sigma_nn)/(k G) and lateral stresses (sigma_ll,
/// sigma_tt)/(k G) of the two waves of a layer that decay in one direction. l is the direction along k, t across it, n
/// inwards. The lateral stress, finite for nu = 1/2 as well, is that of the strain: sigma_tt = nu (sigma_ll +
/// sigma_nn).
template <class Number> struct Waves { Matrix2<Number> displacement, traction, lateral; };

/// Waves that decay downwards, at q = k z >= 0, z the depth below where they are of unit size.
template <class Number> Waves<Number> downward(const Number& nu, double q) {
  const Number e = std::exp(-q), none = 0;
  return {{e, -q * e, -e, (3.0 - 4.0 * nu + q) * e},
          {-2.0 * e, (2.0 - 4.0 * nu + 2 * q) * e, 2.0 * e, -(4.0 - 4.0 * nu + 2 * q) * e},
          {-2.0 * e, (2 * q - 4.0 * nu) * e, none, -4.0 * nu * e}};
}

/// Waves that decay upwards, at the height q = k z >= 0 above where they are of unit size.
template <class Number> Waves<Number> upward(const Number& nu, double q) {
  const Number e = std::exp(-q), none = 0;
  return {{e, q * e, e, (3.0 - 4.0 * nu + q) * e},
          {2.0 * e, (2.0 - 4.0 * nu + 2 * q) * e, 2.0 * e, (4.0 - 4.0 * nu + 2 * q) * e},
          {-2.0 * e, (4.0 * nu - 2 * q) * e, none, 4.0 * nu * e}};
}

/// What the bottom of a layer reflects: waves upwards, of the size they have there, by those downwards, of the size
/// they have at its top.
template <class Number> struct Reflection {
  Matrix2<Number> in_plane{};
  Number across{}; ///< of waves across k
};

/// Reflections of all layers of a stack at a wavenumber, found from below upwards, and what its surface adds to the
/// half-space of its material.
template <class Number> struct LayerReflections {
  std::array<Reflection<Number>, LayeredBody::most_layers> of_layer;
  Matrix2<Number> rest{};  ///< displacements (U, W) by tractions, times k
  Number rest_across = {}; ///< k u_t by sigma_tn, with its opposite sign

  LayerReflections(const LayerStack<Number>& stack, double k) {
    Matrix2<Number> below{};
    Number flexibility = 0; ///< k/Z of what is below, for waves across k
    if (stack.substrate) {
      below = half_space(stack.substrate->poisson_ratio) * (Number(1) / stack.substrate->shear_modulus);
      flexibility = Number(1) / stack.substrate->shear_modulus;
    }
    for (std::size_t n = stack.layers.size(); n-- > 0;) {
      const auto& [modulus, nu] = stack.layers[n].material;
      const double q = k * stack.layers[n].thickness;
      const Matrix2<Number> flexible = below * modulus;
      const Waves<Number> down = downward(nu, q), up = upward(nu, 0);
      of_layer[n].in_plane =
          (up.displacement - flexible * up.traction).inverse() * (flexible * down.traction - down.displacement);
      rest = rest_in_plane(stack.layers[n].material, q, of_layer[n].in_plane);
      below = half_space(nu) * (Number(1) / modulus) + rest;
      const Number decay = std::exp(-q), share = (modulus * flexibility - 1.0) / (modulus * flexibility + 1.0);
      of_layer[n].across = decay * share;
      const Number r = decay * decay * share;
      rest_across = 2.0 * r / ((1.0 - r) * modulus);
      flexibility = (1.0 + r) / ((1.0 - r) * modulus);
    }
  }

private:
  /// k times the map from tractions to displacements on a half-space's surface, times G.
  static Matrix2<Number> half_space(const Number& nu) {
    const Waves<Number> waves = downward(nu, 0);
    return waves.displacement * waves.traction.inverse();
  }

  static Matrix2<Number> rest_in_plane(const StackMaterial<Number>& material, double q,
                                       const Matrix2<Number>& reflection) {
    const auto& [modulus, nu] = material;
    const Waves<Number> down = downward(nu, 0), up = upward(nu, q);
    const Matrix2<Number> added = (up.displacement - half_space(nu) * up.traction) * reflection;
    const Matrix2<Number> tractions = down.traction + up.traction * reflection;
    return added * tractions.inverse() * (Number(1) / modulus);
  }
};

} // namespace microslip
