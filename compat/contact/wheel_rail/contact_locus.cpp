#include "compat/contact/wheel_rail/contact_locus.hpp"

#include "compat/contact/wheel_rail/space_curve.hpp"
#include "microslip/railway/profile_kinks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace microslip::contact_program {
namespace {

constexpr double nowhere = 999, below_nothing = -888;

/// The points of the wheel's profile without the parts that fold back when seen from above, from the one at the middle
/// of its width outwards.
struct PointRange {
  std::size_t first = 0, last = 0;
};

PointRange without_folds(const ProfileCurve& standing) {
  const auto& points = standing.points();
  const double middle = 0.5 * (standing.least_y() + standing.greatest_y());
  const auto tread = std::min_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.y - middle) < std::abs(b.y - middle);
  });
  const auto goes_on = [&](std::size_t from, std::size_t to) {
    const bool ascends = to > from ? points[to].y > points[from].y : points[to].y < points[from].y;
    return ascends && standing.at(standing.s_of(to)).first.y > 0;
  };
  PointRange range;
  range.first = range.last = static_cast<std::size_t>(tread - points.begin());
  while (range.last + 1 < points.size() && goes_on(range.last, range.last + 1)) ++range.last;
  while (range.first > 0 && goes_on(range.first, range.first - 1)) --range.first;
  return range;
}

/// dz/dy, bounded where the profile is vertical.
double slope_at(const ProfileCurve& wheel, double s) {
  const CurvePoint p = wheel.at(s);
  return p.first.z / std::max(1e-6, p.first.y);
}

/// The point of the wheel's circle at a point of its profile that lies lowest over a rail that is the same everywhere.
Vec3<double> lowest_on_circle(const Placement& p, const ProfilePoint& at, double slope) {
  const Rotation<double>& r = p.wheel.axes;
  const double radius = p.radius + at.z;
  double x = (radius * slope * r.ey.x - p.radius * r.ez.x) / r.ex.x;
  x = std::clamp(x, -0.5 * p.radius, 0.5 * p.radius);
  const double square = radius * radius - x * x;
  return {x, at.y, square > 0 ? std::sqrt(square) - p.radius : -nowhere};
}

/// Where the locus jumps: its polygon over y, with x shortened to a tenth, turns by 18 degrees or has a long side.
std::vector<std::size_t> jumps(const std::vector<Vec3<double>>& locus, const std::vector<double>& s) {
  constexpr double longest = 100, shortened = 0.1;
  std::vector<ProfilePoint> flat;
  for (const auto& p : locus) flat.push_back({p.y, shortened * p.x});
  constexpr double turn = std::numbers::pi / 10;
  auto cuts = find_kinks(flat, {turn, turn, 0.01});
  for (std::size_t k = 1; k + 1 < s.size(); ++k)
    if (s[k + 1] - s[k] > longest || s[k] - s[k - 1] > longest) cuts.push_back(k);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

/// The wheel's points next to the rail, and what lies below them.
struct Locus {
  SpaceCurve wheel;
  std::optional<SpaceCurve> roller; ///< the surface of a roller, which is not the same along the track
};

SpaceCurve joined(std::vector<double> s, std::vector<Vec3<double>> points) {
  const auto cuts = jumps(points, s);
  return SpaceCurve(std::move(s), std::move(points), cuts);
}

/// The height of a roller over a point of the track, its profile being lower by its fall from the axle's plane on.
double roller_height(const Placement& p, const ProfileCurve& rail, double x, double y, double& slope) {
  const double sign = p.roller_radius < 0 ? -1 : 1;
  const double radius = sign * (p.roller_radius - rail.at(rail.nearest_s_at_y(y)).value.z);
  slope = sign * x / radius;
  const double square = radius * radius - x * x;
  return square > 0 ? p.roller_radius - sign * std::sqrt(square) : 888;
}

/// Three steps of a fixed-point iteration for the points that lie next to a roller.
Locus locus_on_roller(const Placement& p, const ProfileCurve& rail, const PointRange& range) {
  const ProfileCurve& wheel = *p.wheel_profile;
  const Rotation<double>& r = p.wheel.axes;
  std::vector<double> s;
  std::vector<Vec3<double>> on_wheel, on_roller;
  for (std::size_t k = range.first; k <= range.last; ++k) {
    const ProfilePoint& at = wheel.points()[k];
    s.push_back(wheel.s_of(k));
    const double radius = p.radius + at.z, slope = radius * slope_at(wheel, s.back());
    Vec3<double> point{0, at.y, at.z}, below;
    for (int step = 0; step < 3; ++step) {
      below = p.wheel.outer(point);
      double roller_slope = 0;
      below.z = roller_height(p, rail, below.x, below.y, roller_slope);
      const double square = radius * radius - point.x * point.x;
      point.z = square > 0 ? std::sqrt(square) - p.radius : -nowhere;
      const double height = p.radius + point.z;
      const double down = point.x * r.ex.z - slope * r.ey.z + height * r.ez.z;
      const double x = (down * (point.x / p.roller_radius - roller_slope) + slope * r.ey.x - height * r.ez.x) /
                       (r.ex.x + down / p.roller_radius);
      point.x = std::clamp(x, -0.5 * p.radius, 0.5 * p.radius);
    }
    on_wheel.push_back(p.wheel.outer(point));
    on_roller.push_back(below);
  }
  return {joined(s, std::move(on_wheel)), joined(s, std::move(on_roller))};
}

Locus contact_locus(const Placement& p, const ProfileCurve& rail) {
  const ProfileCurve& wheel = *p.wheel_profile;
  const double roll = std::atan2(p.wheel.axes.ey.z, p.wheel.axes.ez.z);
  const PointRange range = without_folds(wheel.moved(roll, 0, 0));
  if (p.on_roller()) return locus_on_roller(p, rail, range);
  std::vector<double> s;
  std::vector<Vec3<double>> points;
  for (std::size_t k = range.first; k <= range.last; ++k) {
    s.push_back(wheel.s_of(k));
    points.push_back(p.wheel.outer(lowest_on_circle(p, wheel.points()[k], slope_at(wheel, s.back()))));
  }
  return {joined(std::move(s), std::move(points)), {}};
}

/// The rail's height, and its inclination across the track; none beyond it.
std::optional<CurvePoint> rail_at(const ProfileCurve& rail, const Locus& locus, double y) {
  const auto s = rail.s_at_y(y);
  if (!s) return {};
  CurvePoint point = rail.at(*s);
  if (!locus.roller) return point;
  const auto on_roller = locus.roller->at_y(y);
  if (!on_roller) return {};
  point.value.z = on_roller->z;
  return point;
}

} // namespace

GapLine GapLine::lowered(double depth) const {
  GapLine line = *this;
  for (std::size_t k = 0; k < size(); ++k) {
    if (line.z_wheel[k] != below_nothing) line.z_wheel[k] += depth;
    if (line.gap[k] < 777) line.gap[k] -= depth;
  }
  return line;
}

GapLine find_gap_line(const Placement& p, const ProfileCurve& rail, double ds) {
  constexpr double share_of_ds = 0.3;
  const Locus locus = contact_locus(p, rail);
  GapLine line;
  const double dy = share_of_ds * ds;
  const auto count = static_cast<std::size_t>(std::floor((rail.greatest_y() - rail.least_y()) / dy + 1e-9)) + 1;
  line.overlaps = false;
  for (std::size_t k = 0; k < count; ++k) {
    const double y = rail.least_y() + double(k) * dy;
    const auto on_rail = rail_at(rail, locus, y);
    const auto on_wheel = locus.wheel.at_y(y);
    line.y.push_back(y);
    line.x.push_back(on_wheel ? on_wheel->x : 0);
    line.z_wheel.push_back(on_wheel ? on_wheel->z : below_nothing);
    line.z_rail.push_back(on_rail ? on_rail->value.z : nowhere);
    line.angle.push_back(on_rail ? std::atan2(on_rail->first.z, on_rail->first.y) : 0);
    line.gap.push_back(on_rail ? line.z_rail.back() - line.z_wheel.back() : nowhere);
    line.overlaps |= on_rail && on_wheel;
  }
  return line;
}

} // namespace microslip::contact_program
