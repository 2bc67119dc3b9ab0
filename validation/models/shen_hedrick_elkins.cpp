// Shen, Hedrick & Elkins 1983a, A comparison of alternative creep force models for rail vehicle dynamic analysis.
// Numbers (SHE..) are this file's own.
//
// (SHE1) e = |(Fx, Fy)|/(mu Fn) of Kalker's linear theory, spin among its causes
// (SHE2) Fx, Fy and Mz are those of linear theory times 1 - e/3 + e^2/27 for e <= 3, else times 1/e: the force is
//        mu Fn (1 - (1 - e/3)^3), Vermeulen & Johnson's with e/3 for tau

#include "validation/models/shen_hedrick_elkins.hpp"

#include "validation/models/linear_theory.hpp"

#include <cmath>

namespace microslip::validation {

ContactForces shen_hedrick_elkins(const EllipticContact& contact) {
  const ContactForces linear = linear_theory(contact);
  const double limit = contact.friction.static_coefficient() * contact.normal_force;
  const double e = std::hypot(linear.fx, linear.fy) / limit;      // (SHE1)
  return scaled(linear, e <= 3 ? 1 - e / 3 + e * e / 27 : 1 / e); // (SHE2)
}

} // namespace microslip::validation
