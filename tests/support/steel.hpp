#pragma once

#include "microslip/contact/elliptic_contact.hpp"
#include "microslip/elasticity/material.hpp"

namespace microslip {

/// What wheels and rails are made of.
inline constexpr Material steel_body{82e9, 0.28};

/// Two bodies of it.
inline constexpr CombinedMaterial steel{82e9, 0.28, 0};

/// An ellipse between them with mu = 0.3.
inline EllipticContact steel_contact(double a, double b, double normal_force, const Creepage& creepage = {}) {
  EllipticContact contact;
  contact.a = a, contact.b = b;
  contact.shear_modulus = steel.shear_modulus, contact.poisson_ratio = steel.poisson_ratio;
  contact.normal_force = normal_force;
  contact.friction = FrictionLaw::coulomb(0.3);
  contact.creepage = creepage;
  return contact;
}

} // namespace microslip
