#pragma once

#include "microslip/simplified/creepage_coefficients.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace microslip {

/// The variables of creep-force tables. With g = G a b/(mu Fn) they are the scaled creepages
///
///   (X, Y, Z) = g (C11 xi, C22 eta, C11 kappa sqrt(a b) phi),   kappa^4 = (b/a)^2 + (a/b)^(3/2),
///
/// whose length r = r0 t/(1 - t), 0 <= t <= 1, goes from no slip to full sliding. Their direction is that of
///
///   (X, Y, Z) ~ (cos theta cos alpha/s, s cos theta sin alpha, sin theta),   s^8 = a/(a + b),
///
/// so that slender ellipses have more nodes around alpha = 0, where their forces change most. Nodes are equidistant in
/// t, alpha and e, pi/2 e = theta - beta/4 sin(4 theta): closer around theta = 45 degrees, where the slip's centre of
/// rotation leaves the contact.
namespace creep_coordinates {

inline constexpr double half_way = 1.5; ///< r0, where t = 1/2
inline constexpr double crowding = 0.3; ///< beta

/// theta of e.
inline double elevation(double e) {
  const double wanted = e * std::numbers::pi / 2;
  double theta = wanted;
  for (int i = 0; i < 20; ++i)
    theta -= (theta - crowding / 4 * std::sin(4 * theta) - wanted) / (1 - crowding * std::cos(4 * theta));
  return theta;
}

/// kappa.
inline double spin_scale(double a_over_b) {
  return std::sqrt(std::sqrt(1 / (a_over_b * a_over_b) + a_over_b * std::sqrt(a_over_b)));
}

/// s.
inline double stretch(double a_over_b) {
  return std::sqrt(std::sqrt(std::sqrt(a_over_b / (1 + a_over_b))));
}

/// (X, Y, Z) of length 1.
inline std::array<double, 3> direction(double a_over_b, double theta, double alpha) {
  const double s = stretch(a_over_b);
  const double x = std::cos(theta) * std::cos(alpha) / s, y = std::cos(theta) * std::sin(alpha) * s,
               z = std::sin(theta), length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

/// Creepages by the coefficients of linear theory: (xi, eta, sqrt(a b) phi) = (X/x, Y/y, Z/z)/g, and the forces
/// -q, q = (X, Y + y_z Z, m_y Y + m_z Z) in mu Fn and mu Fn sqrt(a b).
struct LinearTheory {
  double x = 0, y = 0, z = 0, y_z = 0, m_y = 0, m_z = 0;

  LinearTheory() = default;
  LinearTheory(const CreepageCoefficients& c, double spin_scale)
      : x(c.c11), y(c.c22), z(c.c11 * spin_scale), y_z(c.c23 / z), m_y(-c.c23 / y), m_z(c.c33 / z) {}
};

} // namespace creep_coordinates
} // namespace microslip
