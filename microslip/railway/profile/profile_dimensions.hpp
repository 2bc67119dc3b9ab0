#pragma once

#include "microslip/railway/profile/profile.hpp"

#include <optional>
#include <vector>

namespace microslip {

/// Points where a profile's curve passes y = `value` or z = `value`, in order of s [m]. Cost O(pieces).
std::vector<double> crossings(const Profile& profile, double ProfilePoint::*coordinate, double value);

/// s [m] of the smallest value of a coordinate on the part of the curve from `first` to `last` [m]; the first one if
/// it is taken at several. Cost O(pieces).
double lowest(const Profile& profile, double ProfilePoint::*coordinate, double first, double last);
/// s [m] of the largest value.
double highest(const Profile& profile, double ProfilePoint::*coordinate, double first, double last);

/// Dimensions of a wheel's flange as EN 15313 measures them [m]: heights from the tread at the tape line, widths from
/// the flange's back, which is 70 mm from the tape line. What the profile does not reach is empty.
struct WheelDimensions {
  double tape_line = 0;                   ///< its y
  std::optional<double> flange_height;    ///< Sh: from the tape line to the tip
  std::optional<double> flange_thickness; ///< Sd: at 10 mm from the tape line towards the tip
  std::optional<double> flange_gradient;  ///< qR: width from there to the flank 2 mm short of the tip
  std::optional<double> flange_angle;     ///< largest inclination of the flank between tip and tape line [rad]
  std::optional<double> tape_circle;      ///< z of the tread at the tape line
};

/// y of the tape line: 0 if the profile begins about 70 mm on the flange side of its origin, 70 mm if it begins at its
/// origin, else 70 mm from its first point.
double default_tape_line(const Profile& wheel);

WheelDimensions wheel_dimensions(const Profile& wheel, double tape_line);

/// Point where a rail's gauge is measured.
struct GaugePoint {
  ProfilePoint point = {}; ///< furthest to the gauge side, between the top and the height below it
  double s = 0;            ///< [m]
  ProfilePoint top = {};   ///< the highest point; the first one of a plateau
  /// The profile reaches that far down; else the gauge point is its first one, or higher up.
  bool reaches_height = false;
};

/// The gauge point of a rail as it lies, at `height` [m] below its top, > 0. Above it the rail may protrude (worn and
/// undercut heads): the point that protrudes most counts.
GaugePoint gauge_point(const Profile& rail, double height = 0.014);

} // namespace microslip
