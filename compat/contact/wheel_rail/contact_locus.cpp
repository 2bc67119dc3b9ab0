#include "compat/contact/wheel_rail/contact_locus.hpp"

#include "compat/contact/wheel_rail/search_size.hpp"
#include "compat/contact/wheel_rail/search_thresholds.hpp"
#include "compat/contact/wheel_rail/space_curve.hpp"
#include "compat/contact/wheel_rail/varied_profile.hpp"
#include "microslip/numerics/bracketed_root.hpp"
#include "microslip/railway/profile/profile_kinks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace microslip::contact_program {
namespace {

constexpr double nowhere = 0.999, below_nothing = -0.888;

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

/// A point of the wheel's circle at a point of its profile.
Vec3<double> on_circle(const Placement& p, const ProfilePoint& at, double x) {
  const double radius = p.radius + at.z, square = radius * radius - x * x;
  return {x, at.y, square > 0 ? std::sqrt(square) - p.radius : -nowhere};
}

/// The point of the circle that lies lowest over a rail that is the same everywhere.
Vec3<double> lowest_on_circle(const Placement& p, const ProfilePoint& at, double slope) {
  const Rotation<double>& r = p.wheel.axes;
  const double x = ((p.radius + at.z) * slope * r.ey.x - p.radius * r.ez.x) / r.ex.x;
  return on_circle(p, at, std::clamp(x, -0.5 * p.radius, 0.5 * p.radius));
}

/// Where the locus jumps: its polygon over y, with x shortened to a tenth, turns by 18 degrees or has a long side; and
/// at the `ends` of sides that are known to be jumps.
std::vector<std::size_t> jumps(const std::vector<Vec3<double>>& locus, const std::vector<double>& s,
                               const std::vector<std::size_t>& ends) {
  using Limit = SearchThresholds;
  std::vector<ProfilePoint> flat;
  flat.reserve(locus.size());
  for (const auto& p : locus) flat.push_back({p.y, Limit::jump_x * p.x});
  auto cuts = find_kinks(flat, {Limit::jump_turn, Limit::jump_turn, Limit::jump_window});
  for (std::size_t k = 1; k + 1 < s.size(); ++k)
    if (s[k + 1] - s[k] > Limit::jump_length || s[k] - s[k - 1] > Limit::jump_length) cuts.push_back(k);
  for (const std::size_t k : ends)
    if (k > 0 && k + 1 < s.size()) cuts.push_back(k);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

/// The wheel's points next to the rail, and what lies below them.
struct Locus {
  SpaceCurve wheel;
  /// The surface of a roller or of a rail made of slices, which is not the same along the track; pieces that are parted
  /// where the rail is interrupted.
  std::vector<SpaceCurve> below = {};
};

SpaceCurve joined(std::vector<double> s, std::vector<Vec3<double>> points, const std::vector<std::size_t>& ends = {}) {
  const auto cuts = jumps(points, s, ends);
  return SpaceCurve(std::move(s), std::move(points), cuts);
}

/// The same over the length of the polygon through the points.
SpaceCurve joined(std::vector<Vec3<double>> points, const std::vector<std::size_t>& ends = {}) {
  std::vector<double> s = {0};
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vec3<double> step = points[k] - points[k - 1];
    s.push_back(s.back() + std::sqrt(dot(step, step)));
  }
  return joined(std::move(s), std::move(points), ends);
}

/// The height of a roller over a point of the track, its profile being lower by its fall from the axle's plane on.
double roller_height(const Placement& p, const ProfileCurve& rail, double x, double y, double& slope) {
  const double sign = p.roller_radius < 0 ? -1 : 1;
  const double radius = sign * (p.roller_radius - rail.at(rail.nearest_s_at_y(y)).value.z);
  slope = sign * x / radius;
  const double square = radius * radius - x * x;
  return square > 0 ? p.roller_radius - sign * std::sqrt(square) : 0.888;
}

/// Three steps of a fixed-point iteration for the points that lie next to a roller.
Locus locus_on_roller(const Placement& p, const ProfileCurve& rail, const PointRange& range) {
  const ProfileCurve& wheel = *p.wheel_profile.curve;
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
  return {joined(s, std::move(on_wheel)), {joined(std::move(on_roller))}};
}

/// A circle of the wheel over a rail made of slices.
class CircleOverSlices {
public:
  CircleOverSlices(const Placement& p, const ProfilePoint& at, double slope)
      : p_(p), at_(at), radius_(p.radius + at.z), slope_(slope) {}

  /// A point of the circle with the rail's below it, in the track's axes.
  struct Place {
    double x = 0; ///< on the circle
    Vec3<double> on_wheel, on_rail;
    double slope = 0; ///< of the gap along the track, times the height of the wheel's normal

    double gap() const { return on_rail.z - on_wheel.z; }
  };

  /// The point that is next to the rail, where its slope along the track is the rail's or where the rail ends, as far
  /// along the track as wheels reach from where it lies lowest. Nothing if no rail lies below.
  std::optional<Place> nearest() const {
    constexpr int stations = 33;
    const double middle = lowest_on_circle(p_, at_, slope_).x, half = half_of_lower_side(p_);
    std::optional<Place> best, before;
    double x_before = 0;
    const auto take = [&](const std::optional<Place>& place) {
      if (place && (!best || place->gap() < best->gap())) best = place;
    };
    for (int k = 0; k < stations; ++k) {
      const double x = middle + half * (2.0 * k / (stations - 1) - 1);
      const auto here = place(x);
      take(here);
      if (k > 0 && before.has_value() != here.has_value()) {
        const Place end = end_of_rail(here ? *here : *before, here ? x_before : x);
        take(end);
        take(here ? least_between(end, *here) : least_between(*before, end));
      } else if (before && here) {
        take(least_between(*before, *here));
      }
      before = here;
      x_before = x;
    }
    return best;
  }

private:
  std::optional<Place> place(double x) const {
    if (std::abs(x) >= radius_) return {};
    const Vec3<double> point = on_circle(p_, at_, x), on_wheel = p_.wheel.outer(point);
    const auto rail = rail_point(p_, on_wheel);
    if (!rail) return {};
    const Vec3<double> normal = p_.wheel.axes * Vec3<double>{x, -radius_ * slope_, p_.radius + point.z};
    return Place{x, on_wheel, rail->place, normal.x + normal.z * rail->along};
  }

  /// Where the gap is least between two places, if that is not one of them.
  std::optional<Place> least_between(const Place& low, const Place& high) const {
    if (!(low.slope < 0 && high.slope > 0)) return {};
    constexpr double tolerance = 1e-13; // [m]
    const auto slope = [this](double x) {
      const auto there = place(x);
      return there ? there->slope : std::numeric_limits<double>::quiet_NaN();
    };
    return place(find_bracketed_root({low.x, low.slope}, {high.x, high.slope}, 0, tolerance, slope).side.at);
  }

  /// As far towards `off` as there is rail, less a margin, so that rail lies below what is interpolated, too.
  Place end_of_rail(Place on, double off) const {
    constexpr double tolerance = 1e-10, margin = 1e-9; // [m]
    while (std::abs(off - on.x) > tolerance) {
      const double middle = 0.5 * (on.x + off);
      if (const auto there = place(middle))
        on = *there;
      else
        off = middle;
    }
    return place(on.x - std::copysign(margin, off - on.x)).value_or(on);
  }

  const Placement& p_;
  ProfilePoint at_;
  double radius_, slope_;
};

/// Points of the locus, in which the sides that are jumps are known.
struct Trace {
  std::vector<Vec3<double>> points;
  std::vector<std::size_t> ends; ///< of the jumps

  void add(const Vec3<double>& point, bool jumps) {
    if (jumps && !points.empty()) ends.insert(ends.end(), {points.size() - 1, points.size()});
    points.push_back(point);
  }
};

/// The contact locus over a rail made of slices, circle by circle.
class LocusOnSlices {
public:
  /// Where it jumps from one part of the rail to another, and where the rail begins or ends across the track, it has
  /// steps of `step` [m] over the wheel's profile, and is straight, so that it stays within the wheel.
  LocusOnSlices(const Placement& p, const PointRange& range, double step) : p_(p), step_(step) {
    for (std::size_t k = range.first; k <= range.last; ++k) {
      const double s = p.wheel_profile.curve->s_of(k);
      go_on_to(s, next_to_rail(s));
    }
    end_piece();
  }
  Locus locus() { return {joined(std::move(s_), std::move(wheel_.points), wheel_.ends), std::move(below_)}; }

private:
  struct Point {
    Vec3<double> on_wheel;
    std::optional<Vec3<double>> on_rail;
  };

  Point next_to_rail(double s) const {
    const ProfileCurve& wheel = *p_.wheel_profile.curve;
    const ProfilePoint at = wheel.at(s).value;
    const double slope = slope_at(wheel, s);
    const auto nearest = CircleOverSlices(p_, at, slope).nearest();
    if (!nearest) return {p_.wheel.outer(lowest_on_circle(p_, at, slope)), {}};
    return {nearest->on_wheel, nearest->on_rail};
  }

  void go_on_to(double s, const Point& point) {
    constexpr double far = 1e-3; // [m]
    const bool begins = point.on_rail && piece_.points.empty(), ends = !point.on_rail && !piece_.points.empty();
    const bool jumps = !s_.empty() && (begins || ends || std::abs(point.on_wheel.x - wheel_.points.back().x) > far);
    if (jumps && s - s_.back() > step_) {
      const double middle = 0.5 * (s_.back() + s);
      go_on_to(middle, next_to_rail(middle));
      return go_on_to(s, point);
    }
    s_.push_back(s);
    wheel_.add(point.on_wheel, jumps);
    if (point.on_rail)
      piece_.add(*point.on_rail, jumps);
    else
      end_piece();
  }

  void end_piece() {
    if (piece_.points.size() > 1) below_.push_back(joined(std::move(piece_.points), piece_.ends));
    piece_ = {};
  }

  const Placement& p_;
  double step_;
  std::vector<double> s_;
  Trace wheel_, piece_;
  std::vector<SpaceCurve> below_;
};

Locus contact_locus(const Placement& p, const ProfileCurve& rail, double step) {
  const ProfileCurve& wheel = *p.wheel_profile.curve;
  const double roll = std::atan2(p.wheel.axes.ey.z, p.wheel.axes.ez.z);
  const PointRange range = without_folds(wheel.moved(roll, 0, 0));
  if (p.on_roller()) return locus_on_roller(p, rail, range);
  if (p.rail_profile.varies()) return LocusOnSlices(p, range, step).locus();
  std::vector<double> s;
  std::vector<Vec3<double>> points;
  for (std::size_t k = range.first; k <= range.last; ++k) {
    s.push_back(wheel.s_of(k));
    points.push_back(p.wheel.outer(lowest_on_circle(p, wheel.points()[k], slope_at(wheel, s.back()))));
  }
  return {joined(std::move(s), std::move(points))};
}

/// The rail's height, and its inclination across the track.
struct RailAt {
  double z, angle;
};

std::optional<double> height_below(const Locus& locus, double y) {
  std::optional<double> top;
  for (const SpaceCurve& piece : locus.below)
    if (const auto point = piece.at_y(y); point && (!top || point->z < *top)) top = point->z;
  return top;
}

/// None beyond the rail.
std::optional<RailAt> rail_at(const Placement& p, const ProfileCurve& rail, const Locus& locus, double y,
                              const std::optional<Vec3<double>>& on_wheel) {
  if (p.rail_profile.varies()) {
    const auto z = height_below(locus, y);
    if (!z || !on_wheel) return {};
    const auto point = rail_point(p, {on_wheel->x, y, *z});
    return point ? std::optional(RailAt{*z, point->inclination}) : std::nullopt;
  }
  const auto s = rail.s_at_y(y);
  if (!s) return {};
  const CurvePoint point = rail.at(*s);
  const double angle = std::atan2(point.first.z, point.first.y);
  if (!p.on_roller()) return RailAt{point.value.z, angle};
  const auto z = height_below(locus, y);
  return z ? std::optional(RailAt{*z, angle}) : std::nullopt;
}

} // namespace

GapLine GapLine::lowered(double depth) const {
  GapLine line = *this;
  for (std::size_t k = 0; k < size(); ++k) {
    if (line.z_wheel[k] != below_nothing) line.z_wheel[k] += depth;
    if (line.gap[k] < no_gap) line.gap[k] -= depth;
  }
  return line;
}

GapLine find_gap_line(const Placement& p, const ProfileCurve& rail, const PatchRules& sizes) {
  const double dy = SearchThresholds::locus_step * sizes.ds;
  const auto [least_y, greatest_y] =
      p.rail_profile.varies() ? whole_extent(p, rail) : std::pair(rail.least_y(), rail.greatest_y());
  const double points = std::floor((greatest_y - least_y) / dy + 1e-9) + 1;
  require_few_points(points, sizes);
  const Locus locus = contact_locus(p, rail, dy);
  GapLine line;
  const auto count = static_cast<std::size_t>(points);
  line.overlaps = false;
  for (std::size_t k = 0; k < count; ++k) {
    const double y = least_y + double(k) * dy;
    const auto on_wheel = locus.wheel.at_y(y);
    const auto on_rail = rail_at(p, rail, locus, y, on_wheel);
    line.y.push_back(y);
    line.x.push_back(on_wheel ? on_wheel->x : 0);
    line.z_wheel.push_back(on_wheel ? on_wheel->z : below_nothing);
    line.z_rail.push_back(on_rail ? on_rail->z : nowhere);
    line.angle.push_back(on_rail ? on_rail->angle : 0);
    line.gap.push_back(on_rail ? line.z_rail.back() - line.z_wheel.back() : nowhere);
    line.overlaps |= on_rail && on_wheel;
  }
  return line;
}

} // namespace microslip::contact_program
