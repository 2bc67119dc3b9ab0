#include "compat/contact/wheel_rail/curved_patch.hpp"

#include "compat/contact/wheel_rail/search_thresholds.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::contact_program {
namespace {

using Vec = Vec3<double>;

/// Out of a body whose profile has this derivative: out of a rail upwards, z being down.
Vec normal_of(const ProfilePoint& tangent) {
  const double length = std::hypot(tangent.y, tangent.z);
  return {0, tangent.z / length, -tangent.y / length};
}

/// Of the first row that chosen ones may start from, and of the last: the overlap with a fifth more on either side, and
/// three rows.
int outermost_row(double s_edge, double s_reference, double s_origin, double ds, int spare) {
  constexpr double more = SearchThresholds::curved_share;
  return static_cast<int>(std::lround((s_edge + more * (s_edge - s_reference) - s_origin) / ds)) + spare;
}

} // namespace

CurvedPatch::CurvedPatch(const PatchFrame& frame, const Placement& placement, const ProfileCurve& rail)
    : placement_(placement), rail_(rail), reference_(frame.reference.origin),
      s_origin_(frame.s_rail - frame.grid.inner(reference_).y), s_rail_(frame.s_rail) {
  const Vec on_wheel = placement.wheel.inner(reference_);
  s_wheel_ = placement.wheel_profile.curve->nearest_s_at_y(on_wheel.y);
  x_wheel_ = on_wheel.x;
}

CurvedPatch::Middle CurvedPatch::middle(double s) const {
  constexpr int most_turns = 2; // of the point where a yawed wheel's profile has the reference's x
  const auto within = [](const ProfileCurve& curve, double at) { return std::clamp(at, curve.start(), curve.end()); };
  const double along = s + s_origin_;
  const CurvePoint on_rail = rail_.at(within(rail_, along));
  const ProfileCurve& profile = *placement_.wheel_profile.curve;
  const CurvePoint on_wheel = profile.at(within(profile, s_wheel_ + along - s_rail_));
  const double radius = placement_.radius + on_wheel.value.z;
  double x = x_wheel_;
  Vec wheel;
  for (int turn = 0; turn <= most_turns; ++turn) {
    const double square = std::max(radius * radius - x * x, 0.0);
    wheel = placement_.wheel.outer({x, on_wheel.value.y, std::sqrt(square) - placement_.radius});
    x += reference_.x - wheel.x;
  }
  const Vec of_wheel = placement_.wheel.axes * normal_of(on_wheel.first), of_rail = normal_of(on_rail.first);
  const Vec normal = 0.5 * (of_rail + of_wheel);
  Middle m;
  m.row.point = {reference_.x, (on_rail.value.y + wheel.y) / 2, (on_rail.value.z + wheel.z) / 2};
  m.row.angle = std::atan2(normal.y, -normal.z);
  m.faces = std::sqrt(dot(normal, normal)) > SearchThresholds::facing;
  return m;
}

void CurvedPatch::choose_rows(PatchFrame& frame) const {
  constexpr int spare = SearchThresholds::curved_spare, beyond = SearchThresholds::curved_beyond;
  const double ends[] = {rail_.nearest_s_at_y(frame.y0), rail_.nearest_s_at_y(frame.y1)};
  const int first = outermost_row(std::min({ends[0], ends[1], s_rail_}), s_rail_, s_origin_, frame.ds, -spare);
  const int last = outermost_row(std::max({ends[0], ends[1], s_rail_}), s_rail_, s_origin_, frame.ds, spare);
  const int at_reference = static_cast<int>(std::lround((s_rail_ - s_origin_) / frame.ds));
  int low = at_reference - 1, high = at_reference + 1;
  for (int k = first; k <= last; ++k) {
    const auto [row, faces] = middle(k * frame.ds);
    if (!faces || row.point.y < frame.y0 || row.point.y > frame.y1) continue;
    low = std::min(low, k);
    high = std::max(high, k);
  }
  low = std::max(low - beyond, first);
  high = std::min(high + beyond, last);
  frame.s0 = (low - 0.5) * frame.ds;
  frame.my = high - low + 1;
}

void CurvedPatch::bend(PatchFrame& frame) const {
  for (double& separator : frame.separators) { // a line across the track in the frame's plane
    const double y = frame.grid.origin.y + separator * std::cos(frame.angle);
    separator = frame.s0;
    while (separator < frame.s1() && middle(separator).row.point.y < y) separator += frame.ds / 2;
  }
  frame.rows.clear();
  for (int j = 0; j < frame.my; ++j) frame.rows.push_back(middle(frame.row_s(j)).row);
}

} // namespace microslip::contact_program
