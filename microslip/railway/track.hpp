#pragma once

#include "microslip/railway/frame.hpp"
#include "microslip/railway/profile.hpp"

#include <optional>

namespace microslip {

/// A straight or curved track in its nominal place, both rails alike. Track axes: x forward, y to the left, z up, the
/// origin midway between the rails at the tops of both, below the wheelset.
struct Track {
  double gauge = 1.435;        ///< [m], > 0, between the gauge points of both rails
  double gauge_height = 0.014; ///< [m], > 0: gauge points lie at most so far below the rails' tops
  /// Absolute placement of the left rail in place of the gauge: the origin of its profile in track axes [m].
  std::optional<ProfilePoint> rail_origin;
  double cant = 0; ///< [rad], inclination of the rails: > 0 towards the track's centre, usually 1/40 or 1/20
};

/// The point of the left rail's surface that determines the gauge: the innermost one on the gauge side of the rail's
/// highest point and at most gauge_height below it, after turning by the cant.
struct GaugePoint {
  double s = 0;       ///< parameter of the profile [m]
  ProfilePoint place; ///< [m], in the axes of the profile turned by the cant
  double top = 0;     ///< [m], height of the highest point in the same axes
};

/// The point comes from the spline, not from its points. A profile may end up to a hundredth of gauge_height above the
/// gauge height; its first point counts as gauge point then. Throws Error if it ends higher up or the highest point is
/// the first one. Cost O(pieces).
GaugePoint gauge_point(const Profile& rail, double cant, double gauge_height);

/// The left rail's frame: its profile's axes in track axes. Throws Error for values out of range and as gauge_point.
Frame<double> place_rail(const Track& track, const Profile& rail);

} // namespace microslip
