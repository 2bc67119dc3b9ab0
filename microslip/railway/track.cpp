#include "microslip/railway/track.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/cubic_roots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace microslip {
namespace {

std::vector<ProfilePiece> turned(const Profile& profile, double angle) {
  std::vector<ProfilePiece> pieces(profile.pieces().begin(), profile.pieces().end());
  const double c = std::cos(angle), s = std::sin(angle);
  for (ProfilePiece& piece : pieces)
    for (ProfilePoint& p : piece.c) p = {c * p.y - s * p.z, s * p.y + c * p.z};
  return pieces;
}

/// The zeros of a coordinate's derivative inside the piece.
CubicRoots extrema(const ProfilePiece& piece, double ProfilePoint::*coordinate) {
  const auto c = [&](std::size_t k) { return piece.c[k].*coordinate; };
  return cubic_roots({c(1), 2 * c(2), 3 * c(3), 0}, 0, piece.length);
}

CurvePoint highest_point(const std::vector<ProfilePiece>& pieces, double& s_top) {
  CurvePoint top = pieces.front().at(0);
  s_top = 0;
  const auto consider = [&](const ProfilePiece& piece, double t) {
    const CurvePoint p = piece.at(piece.start + t);
    if (p.value.z > top.value.z) top = p, s_top = piece.start + t;
  };
  for (const ProfilePiece& piece : pieces) {
    for (const double t : extrema(piece, &ProfilePoint::z)) consider(piece, t);
    consider(piece, piece.length);
  }
  return top;
}

} // namespace

GaugePoint gauge_point(const Profile& rail, double cant, double gauge_height) {
  const std::vector<ProfilePiece> pieces = turned(rail, cant);
  double s_top = 0;
  const double top = highest_point(pieces, s_top).value.z, level = top - gauge_height;
  if (s_top == 0) throw Error("rail profile: its first point is the highest one: it has no gauge side");
  const double missing = pieces.front().c[0].z - level;
  if (missing > 0.01 * gauge_height)
    throw Error("gauge_height", gauge_height, "m",
                "at most the rail's depth on the gauge side below its top, " + std::to_string(gauge_height - missing) +
                    " m");
  GaugePoint gauge{s_top, {std::numeric_limits<double>::infinity(), top}, top};
  const auto consider = [&](const ProfilePiece& piece, double t) {
    const ProfilePoint p = piece.at(piece.start + t).value;
    if (piece.start + t <= s_top && p.y < gauge.place.y) gauge = {piece.start + t, p, top};
  };
  for (const ProfilePiece& piece : pieces) {
    for (const double t :
         cubic_roots({piece.c[0].z - level, piece.c[1].z, piece.c[2].z, piece.c[3].z}, 0, piece.length))
      consider(piece, t);
    for (const double t : extrema(piece, &ProfilePoint::y))
      if (piece.at(piece.start + t).value.z >= level) consider(piece, t);
    for (const double t : {0.0, piece.length})
      if (piece.at(piece.start + t).value.z >= level) consider(piece, t);
  }
  return gauge;
}

Frame<double> place_rail(const Track& track, const Profile& rail) {
  require_between("cant", track.cant, "rad", -0.5, 0.5);
  const Rotation<double> axes = rotation_about_x(track.cant);
  if (track.rail_origin) {
    require_finite("rail_origin y", track.rail_origin->y, "m");
    require_finite("rail_origin z", track.rail_origin->z, "m");
    return {{0, track.rail_origin->y, track.rail_origin->z}, axes};
  }
  require_positive("gauge", track.gauge, "m");
  require_positive("gauge_height", track.gauge_height, "m");
  const GaugePoint point = gauge_point(rail, track.cant, track.gauge_height);
  return {{0, track.gauge / 2 - point.place.y, -point.top}, axes};
}

} // namespace microslip
