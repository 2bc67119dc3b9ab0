#pragma once

#include "microslip/contact/contact_forces.hpp"
#include "microslip/contact/creepage.hpp"
#include "microslip/friction/friction_law.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace microslip {

/// A Hertzian contact: an ellipse with load, material, friction and creepages.
struct EllipticContact {
  double a = 0;             ///< semi-axis along the rolling direction [m], > 0
  double b = 0;             ///< lateral semi-axis [m], > 0
  double shear_modulus = 0; ///< combined G [Pa], > 0
  double poisson_ratio = 0; ///< combined nu [-], in [0, 0.5]
  double normal_force = 0;  ///< Fn [N], > 0
  FrictionLaw friction;     ///< of the slip velocity
  Creepage creepage;
  /// V [m/s], > 0; matters for friction laws other than Coulomb's and for the frictional power.
  double rolling_speed = 1;
  /// Combined K [-], which couples pressure and tractions of dissimilar materials, in
  /// [-0.5, 0.5]. The simplified theory has no such coupling and refuses it.
  double dissimilarity = 0;
};

/// |K| of any two bodies: K/G = ((1 - 2 nu1)/G1 - (1 - 2 nu2)/G2)/4 is largest with one of them rigid and nu = 0 [-].
inline constexpr double largest_dissimilarity = 0.5;

/// Returns whether everything is in range, and what is not: field, value, unit and range.
bool is_valid(const EllipticContact& contact) noexcept;
void check(const EllipticContact& contact); ///< throws Error
/// Returns true for a contact of the simplified theory and of creep-force tables, which have no dissimilarity: numbers
/// that are > 0 lie in [1e-30, 1e30] for them, creepages in [-1e30, 1e30].
bool is_valid_simplified(const EllipticContact& contact) noexcept;
void check_simplified(const EllipticContact& contact);

} // namespace microslip
