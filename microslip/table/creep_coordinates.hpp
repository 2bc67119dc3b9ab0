#pragma once

#include "microslip/simplified/creepage_coefficients.hpp"

#include <cmath>

namespace microslip {

/// The variables of creep-force tables. With g = G a b/(mu Fn) they are the scaled creepages
///
///   (X, Y, Z) = g (C11 xi, C22 eta, C11 kappa sqrt(a b) phi),   kappa^4 = (b/a)^2 + (a/b)^(3/2),
///
/// in spherical coordinates (X, Y, Z) = r (cos theta cos alpha, cos theta sin alpha, sin theta) with
/// r = r0 t/(1 - t): 0 <= t <= 1 goes from no slip to full sliding.
namespace creep_coordinates {

inline constexpr double half_way = 1.5; ///< r0, where t = 1/2

inline double spin_scale(double a_over_b) {
  return std::sqrt(std::sqrt(1 / (a_over_b * a_over_b) + a_over_b * std::sqrt(a_over_b)));
}

/// What the coefficients of linear theory make of them: (xi, eta, sqrt(a b) phi) = (X/x, Y/y, Z/z)/g, and the forces
/// -q, q = (X, Y + y_z Z, m_y Y + m_z Z) in mu Fn and mu Fn sqrt(a b).
struct LinearTheory {
  double x = 0, y = 0, z = 0, y_z = 0, m_y = 0, m_z = 0;

  LinearTheory() = default;
  LinearTheory(const CreepageCoefficients& c, double spin_scale)
      : x(c.c11), y(c.c22), z(c.c11 * spin_scale), y_z(c.c23 / z), m_y(-c.c23 / y), m_z(c.c33 / z) {}
};

} // namespace creep_coordinates
} // namespace microslip
