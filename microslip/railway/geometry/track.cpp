#include "microslip/railway/geometry/track.hpp"

#include "microslip/error.hpp"
#include "microslip/railway/profile/profile_dimensions.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace microslip {
namespace {

/// The spline of turned points is the turned spline.
Profile turned(const Profile& profile, double angle) {
  std::vector<ProfilePoint> points;
  const double c = std::cos(angle), s = std::sin(angle);
  const auto add = [&](const ProfilePoint& p) { points.push_back({c * p.y - s * p.z, s * p.y + c * p.z}); };
  for (const ProfilePiece& piece : profile.pieces()) add(piece.c[0]);
  add(profile.at(profile.length()).value);
  return Profile(profile.role(), points, profile.kinks());
}

GaugePoint gauge_point_of(const Profile& standing, double gauge_height) {
  const GaugePoint gauge = gauge_point(standing, gauge_height);
  const double depth = gauge.top.z - standing.at(0).value.z;
  if (!gauge.reaches_height && !(depth >= 0.99 * gauge_height))
    throw Error("gauge_height", gauge_height, "m",
                "at most the rail's depth on the gauge side below its top, " + std::to_string(depth) + " m");
  return gauge;
}

} // namespace

Frame<double> place_rail(const Track& track, const Profile& rail) {
  require_between("cant", track.cant, "rad", -0.5, 0.5);
  if (track.roller_radius != 0) require_between("roller_radius", std::abs(track.roller_radius), "m", 0.01, 100);
  const Rotation<double> axes = rotation_about_x(track.cant);
  if (track.rail_origin) {
    require_finite("rail_origin y", track.rail_origin->y, "m");
    require_finite("rail_origin z", track.rail_origin->z, "m");
    return {{0, track.rail_origin->y, track.rail_origin->z}, axes};
  }
  require_positive("gauge", track.gauge, "m");
  require_positive("gauge_height", track.gauge_height, "m");
  const GaugePoint gauge = gauge_point_of(turned(rail, track.cant), track.gauge_height);
  return {{0, track.gauge / 2 - gauge.point.y, track.roller_radius != 0 ? 0 : -gauge.top.z}, axes};
}

} // namespace microslip
