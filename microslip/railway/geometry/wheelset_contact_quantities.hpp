#pragma once

#include "microslip/railway/geometry/wheelset_contact.hpp"

#include <span>
#include <string>

namespace microslip {

/// A number of a wheelset's contact, or of the point where one of its wheels touches, with "left_" or "right_" before
/// its name. Python and C read it from here.
struct WheelsetContactQuantity {
  using OfWheelset = double (*)(const WheelsetContact& contact);
  /// `side` is 1 on the left and -1 on the right, whose point is that of a mirror image.
  using OfWheel = double (*)(const ContactPoint& point, const WheelsetSearch::Side& of, double side);

  std::string name, unit, description;
  OfWheelset of_wheelset = nullptr;
  OfWheel of_left = nullptr, of_right = nullptr; ///< or one of these

  double value(const WheelsetContact& contact, const WheelsetSearch::Side& left,
               const WheelsetSearch::Side& right) const;
};

/// Quantities in the order of rows of arrays, whose indices and lengths programs keep: a new one stands at the end.
std::span<const WheelsetContactQuantity> wheelset_contact_quantities();

} // namespace microslip
