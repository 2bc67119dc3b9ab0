#pragma once

#include "microslip/railway/geometry/frame.hpp"
#include "microslip/railway/profile/profile.hpp"

#include <optional>

namespace microslip {

/// A straight or curved track in its nominal position, both rails alike. Track axes: x forward, y to the left, z up,
/// the origin midway between the rails at the tops of both, below the wheelset. Or two rollers: their profiles are
/// added to their radius, the origin is at the nominal radius above their axle, and does not move with the wheelset.
struct Track {
  double gauge = 1.435;        ///< [m], > 0, between the gauge points of both rails
  double gauge_height = 0.014; ///< [m], > 0: how far below the rails' tops it is measured
  /// Absolute placement of the left rail instead of the gauge: the origin of its profile in track axes [m].
  std::optional<ProfilePoint> rail_origin;
  double cant = 0;          ///< [rad], inclination of the rails: > 0 towards the track's centre, usually 1/40 or 1/20
  double roller_radius = 0; ///< nominal one of a roller instead of a rail [m], < 0 of a raceway; 0: a rail
};

/// The left rail's frame: its profile's axes in track axes. The gauge point (profile_dimensions.hpp) is that of the
/// rail as it stands, turned by the cant. Throws Error for values out of range and for a profile that ends on the gauge
/// side more than a hundredth of gauge_height too high. That of a roller is not moved in z. Cost O(points).
Frame<double> place_rail(const Track& track, const Profile& rail);

} // namespace microslip
