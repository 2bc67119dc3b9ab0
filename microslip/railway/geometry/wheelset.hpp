#pragma once

#include "microslip/railway/profile/profile.hpp"

#include <optional>

namespace microslip {

/// A wheelset, both wheels alike.
struct Wheelset {
  double flange_back_distance = 1.36;  ///< [m], > 0, between the backs of both flanges
  double flange_back_position = -0.07; ///< [m], y of the flange's back in the wheel's profile
  double nominal_radius = 0.46;        ///< [m], > 0, at the height z = 0 of the profile or on the tape circle
  /// y [m] in the wheel's profile where the radius is the nominal one, if that is not at z = 0.
  std::optional<double> tape_circle;
};

/// The left wheel on its axle.
struct WheelPlace {
  double lateral = 0; ///< y [m] of the profile's origin in the wheelset's axes
  double radius = 0;  ///< [m] at z = 0 of the profile; at height z it is radius - z
};

/// Throws Error for values out of range, a tape circle outside the profile or not unique, and a wheel whose radius is
/// not positive everywhere.
WheelPlace place_wheel(const Wheelset& wheelset, const Profile& wheel);

} // namespace microslip
