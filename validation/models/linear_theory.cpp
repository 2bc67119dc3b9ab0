// Kalker 1967, A strip theory for rolling with slip and spin; the coefficients are those of Kalker 1990, table E.3.
// Numbers (K..) are this file's own; c = sqrt(a b).
//
// (K1) Fx = -G c^2 C11 xi
// (K2) Fy = -G c^2 (C22 eta + c C23 phi)
// (K3) Mz = -G c^3 (-C23 eta + c C33 phi)
// (K4) cut off: all three times mu Fn/|(Fx, Fy)| where that is below 1

#include "validation/models/linear_theory.hpp"

#include "microslip/simplified/creepage_coefficients.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::validation {

ContactForces scaled(ContactForces forces, double factor) {
  forces.fx *= factor, forces.fy *= factor, forces.mz *= factor;
  return forces;
}

ContactForces linear_theory(const EllipticContact& contact) {
  const auto k = creepage_coefficients(contact.a / contact.b, contact.poisson_ratio);
  const double c = std::sqrt(contact.a * contact.b), stiffness = contact.shear_modulus * c * c;
  const auto [xi, eta, phi] = contact.creepage;
  ContactForces forces;
  forces.fx = -stiffness * k.c11 * xi;                           // (K1)
  forces.fy = -stiffness * (k.c22 * eta + c * k.c23 * phi);      // (K2)
  forces.mz = -stiffness * c * (-k.c23 * eta + c * k.c33 * phi); // (K3)
  return forces;
}

ContactForces saturated_linear_theory(const EllipticContact& contact) {
  const ContactForces linear = linear_theory(contact);
  const double limit = contact.friction.static_coefficient() * contact.normal_force;
  const double size = std::hypot(linear.fx, linear.fy);
  return scaled(linear, size > limit ? limit / size : 1); // (K4)
}

} // namespace microslip::validation
