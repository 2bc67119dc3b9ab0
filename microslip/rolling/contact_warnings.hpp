#pragma once

#include "microslip/contact/elliptic_contact.hpp"
#include "microslip/contact/warnings.hpp"
#include "microslip/elasticity/hertz.hpp"

#include <string>
#include <vector>

namespace microslip {

/// Doubts about a contact of two bodies.
struct ContactWarnings {
  Warnings all;
  std::vector<std::string> texts; ///< with its numbers, and which inputs to check; one for each that is found
  std::vector<Warning> kinds;     ///< of each of the texts

  bool empty() const { return texts.empty(); }
};

/// Warnings of a Hertzian contact, by the table: pressures relative to the combined Young's modulus, that modulus, the
/// ellipse and the approach beside the radii, and the radii. Lengths in mm or moduli in MPa make such contacts.
ContactWarnings contact_warnings(const HertzContact& contact, const PrincipalRadii& radii,
                                 const CombinedMaterial& material);

/// A roller in a nip.
struct RollerShape {
  const char* name;
  double radius; ///< [m]
  double cover;  ///< thickness of its cover [m]; 0: none
  double strain; ///< of the cover [-]
};

/// Warnings of a nip of two rollers: strains beyond small ones, covers and the nip beside the radii. `half_width` is
/// half the nip's width [m].
ContactWarnings roller_warnings(const RollerShape& roller1, const RollerShape& roller2, double half_width);

/// Warnings of a valid contact of which only ellipse, load and material are known. Cost some nanoseconds where there
/// is nothing to warn of.
ContactWarnings contact_warnings(const EllipticContact& contact);

} // namespace microslip
