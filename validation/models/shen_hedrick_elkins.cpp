#include "validation/models/shen_hedrick_elkins.hpp"

#include "validation/models/linear_theory.hpp"

#include <cmath>

namespace microslip::validation {

ContactForces shen_hedrick_elkins(const EllipticContact& contact) {
  const ContactForces linear = linear_theory(contact);
  const double limit = contact.friction.static_coefficient() * contact.normal_force;
  const double e = std::hypot(linear.fx, linear.fy) / limit;
  return scaled(linear, e <= 3 ? 1 - e / 3 + e * e / 27 : 1 / e);
}

} // namespace microslip::validation
