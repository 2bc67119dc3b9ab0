#pragma once

#include "microslip.h"
#include "microslip/contact/elliptic_contact.hpp"
#include "tests/support/same_bits.hpp"

#include <limits>

namespace microslip {

/// The C form of a contact; of the friction laws Coulomb's only.
inline microslip_contact c_form(const EllipticContact& contact) {
  microslip_contact c{};
  c.a = contact.a;
  c.b = contact.b;
  c.shear_modulus = contact.shear_modulus;
  c.poisson_ratio = contact.poisson_ratio;
  c.normal_force = contact.normal_force;
  c.rolling_speed = contact.rolling_speed;
  c.creepage_longitudinal = contact.creepage.longitudinal;
  c.creepage_lateral = contact.creepage.lateral;
  c.spin = contact.creepage.spin;
  c.friction = contact.friction.kinetic_coefficient();
  return c;
}

inline bool same_bits(const microslip_forces& a, const ContactForces& b) {
  return same_bits(a.fx, b.fx) && same_bits(a.fy, b.fy) && same_bits(a.mz, b.mz) &&
         same_bits(a.adhesion_area, b.adhesion_area) && same_bits(a.slip_area, b.slip_area) &&
         a.status == static_cast<int>(b.status);
}

/// A wheel on a rail, partly sliding.
inline microslip_contact some_contact() {
  microslip_contact c{};
  c.a = 6e-3;
  c.b = 5e-3;
  c.shear_modulus = 82e9;
  c.poisson_ratio = 0.28;
  c.normal_force = 80e3;
  c.rolling_speed = 30;
  c.creepage_longitudinal = 0.0012;
  c.creepage_lateral = 0.0006;
  c.spin = 0.4;
  c.friction = 0.3;
  return c;
}

/// All errors that one number of a contact may have, with the name of its field.
struct WrongField {
  const char* name;
  double microslip_contact::*field;
  double value;
};
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr WrongField wrong_fields[] = {
    {"a", &microslip_contact::a, 0},
    {"a", &microslip_contact::a, not_a_number},
    {"b", &microslip_contact::b, -1e-3},
    {"b", &microslip_contact::b, infinite},
    {"shear_modulus", &microslip_contact::shear_modulus, 0},
    {"poisson_ratio", &microslip_contact::poisson_ratio, 0.51},
    {"poisson_ratio", &microslip_contact::poisson_ratio, -0.01},
    {"normal_force", &microslip_contact::normal_force, -1},
    {"rolling_speed", &microslip_contact::rolling_speed, 0},
    {"creepage_longitudinal", &microslip_contact::creepage_longitudinal, infinite},
    {"creepage_lateral", &microslip_contact::creepage_lateral, not_a_number},
    {"spin", &microslip_contact::spin, -infinite},
    {"friction", &microslip_contact::friction, -0.1},
    {"friction", &microslip_contact::friction, 10.1},
    {"friction", &microslip_contact::friction, not_a_number},
};

} // namespace microslip
