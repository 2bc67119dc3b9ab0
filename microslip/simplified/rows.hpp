#pragma once

#include "microslip/contact/elliptic_contact.hpp"
#include "microslip/simplified/flexibility.hpp"

#include <span>

namespace microslip {

/// A patch of any outline: rows of mx cells each, equally long within a row, and the normal part of the traction bound.
struct PatchRows {
  int mx;                           ///< cells per row
  double row_width;                 ///< delta y [m], > 0
  std::span<const double> y;        ///< centre of each row [m]
  std::span<const double> leading;  ///< x of each row's leading edge [m]
  std::span<const double> trailing; ///< x of each row's trailing edge [m]
  /// p_n [Pa] at the cell centres in the order of Elements: row after row, in each x ascending; >= 0.
  std::span<const double> pressure;
};

/// Motion and friction of a patch of any outline.
struct PatchMotion {
  Flexibilities flexibilities; ///< [m/Pa], > 0, e.g. of the equivalent ellipse
  FrictionLaw friction;
  Creepage creepage;
  double rolling_speed = 1; ///< V [m/s]
};

} // namespace microslip
