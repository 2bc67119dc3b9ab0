#pragma once

#include "microslip/railway/profile/profile.hpp"
#include "microslip/railway/profile/profile_kinks.hpp"
#include "microslip/railway/profile/profile_report.hpp"

#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace microslip {

/// Operations on a profile's points before a spline is laid through them. Lengths in m, angles in rad.
struct ProfileTreatment {
  double smallest_spacing = 1e-7; ///< points closer than this to the one before are dropped
  /// Two points in succession at which the polygon turns back by more than this are replaced by their mean.
  double zigzag_angle = 5 * std::numbers::pi / 6;
  /// Points at either end whose y is outside are dropped; those between, an overhanging gauge corner say, stay.
  double y_min = -std::numeric_limits<double>::infinity(), y_max = std::numeric_limits<double>::infinity();
  /// Wavelength L of `smoothed`, 0: none; left out: by the points' noise, where they scatter (`denoised`).
  std::optional<double> smoothing_length = {};
  KinkRule kinks = {};

  friend bool operator==(const ProfileTreatment&, const ProfileTreatment&) = default;
};

/// A profile and how it came about.
struct PreparedProfile {
  Profile profile;
  std::vector<ProfilePoint> points;   ///< that its spline is laid through
  std::vector<ProfilePoint> measured; ///< the same before smoothing
  ProfileReport report;
};

/// Direction of the axes of points, by their shape alone: 1 as the profile's axes, -1 opposite, 0 undecided.
/// z by the flange of a wheel or by the convex head of a rail; y by the side on which a wheel has its flange, or on
/// which the profile of a rail reaches further down by more than 5 mm: rails are measured down to the gauge face.
struct ShapeSense {
  int y = 0, z = 0;
};
ShapeSense sense_of_shape(ProfileRole role, std::span<const ProfilePoint> points);

/// The profile through points in its axes. In this order: points that are not finite are refused, unsorted ones sorted,
/// duplicates and the ends outside [y_min, y_max] dropped, the order turned to run to the field side, zig-zags
/// straightened, kinks found, points smoothed. Each of these that changed something is a step of the report, whose
/// other members (source, steps so far) are kept. What looks wrong (mirrored axes, gaps, noise, a missing flange) is a
/// warning. Throws Error, with the location, for fewer than 4 points, a length outside 5 mm to 500 mm, and a curve that
/// crosses itself.
PreparedProfile prepare_profile(ProfileRole role, std::vector<ProfilePoint> points,
                                const ProfileTreatment& treatment = {}, ProfileReport report = {});

/// "rail" and "wheel".
std::string_view to_string(ProfileRole role);

} // namespace microslip
