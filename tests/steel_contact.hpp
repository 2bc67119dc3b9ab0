#pragma once

#include "test_cases.hpp"

namespace microslip {

/// Steel under 82 kN with creepages in parts of those of saturation.
inline EllipticContact steel_contact(double a, double b, double longitudinal, double lateral, double spin) {
  EllipticContact contact;
  contact.a = a;
  contact.b = b;
  contact.shear_modulus = 82e9;
  contact.poisson_ratio = 0.28;
  contact.normal_force = 82e3;
  contact.friction = FrictionLaw::coulomb(0.3);
  contact.rolling_speed = 20;
  const Creepage unit = saturating_creepage(contact);
  contact.creepage = {longitudinal * unit.longitudinal, lateral * unit.lateral, spin * unit.spin};
  return contact;
}

} // namespace microslip
