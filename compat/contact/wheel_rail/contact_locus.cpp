#include "compat/contact/wheel_rail/contact_locus.hpp"

#include "compat/contact/wheel_rail/search_thresholds.hpp"
#include "compat/contact/wheel_rail/space_curve.hpp"
#include "compat/contact/wheel_rail/varied_rail.hpp"
#include "microslip/railway/profile/profile_kinks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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
  using Limit = SearchThresholds;
  std::vector<ProfilePoint> flat;
  for (const auto& p : locus) flat.push_back({p.y, Limit::jump_x * p.x});
  auto cuts = find_kinks(flat, {Limit::jump_turn, Limit::jump_turn, Limit::jump_window});
  for (std::size_t k = 1; k + 1 < s.size(); ++k)
    if (s[k + 1] - s[k] > Limit::jump_length || s[k] - s[k - 1] > Limit::jump_length) cuts.push_back(k);
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

SpaceCurve joined(std::vector<double> s, std::vector<Vec3<double>> points) {
  const auto cuts = jumps(points, s);
  return SpaceCurve(std::move(s), std::move(points), cuts);
}

/// The same over the length of the polygon through the points.
SpaceCurve joined(std::vector<Vec3<double>> points) {
  std::vector<double> s = {0};
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vec3<double> step = points[k] - points[k - 1];
    s.push_back(s.back() + std::sqrt(dot(step, step)));
  }
  return joined(std::move(s), std::move(points));
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

  /// The point of the circle next to the rail, with the rail's below it: where the wheel's slope along the track is the
  /// rail's, or where the rail ends; of several the one with the least gap. Nothing if no rail lies below.
  struct Contact {
    Vec3<double> on_wheel, on_rail;
  };
  std::optional<Contact> nearest() const {
    constexpr int stations = 33;
    const double half = 0.5 * p_.radius;
    std::optional<Contact> best;
    const auto take = [&](double x) {
      const auto found = contact(x);
      if (!found) return;
      if (!best || gap(*found) < gap(*best)) best = found;
    };
    double before = -half;
    std::optional<double> slope_before;
    for (int k = 0; k < stations; ++k) {
      const double x = half * (2.0 * k / (stations - 1) - 1);
      const auto slope = slope_difference(x);
      if (slope_before && slope && *slope_before <= 0 && *slope > 0)
        take(root(before, *slope_before, x, *slope));
      else if (!slope_before && slope && *slope > 0 && k > 0)
        take(end_of_rail(x, before));
      else if (slope_before && !slope && *slope_before < 0)
        take(end_of_rail(before, x));
      before = x;
      slope_before = slope;
    }
    return best;
  }

private:
  Vec3<double> on_wheel(double x) const { return {x, at_.y, std::sqrt(radius_ * radius_ - x * x) - p_.radius}; }
  static double gap(const Contact& c) { return c.on_rail.z - c.on_wheel.z; }

  std::optional<Contact> contact(double x) const {
    const Vec3<double> point = p_.wheel.outer(on_wheel(x));
    const auto rail = rail_point(p_, point);
    if (!rail) return {};
    return Contact{point, rail->place};
  }

  /// Of the rail's and the wheel's surface along the track, times the height of the wheel's normal: < 0 where the gap
  /// becomes smaller with x.
  std::optional<double> slope_difference(double x) const {
    if (std::abs(x) >= radius_) return {};
    const Vec3<double> point = on_wheel(x);
    const auto rail = rail_point(p_, p_.wheel.outer(point));
    if (!rail) return {};
    const Vec3<double> normal = p_.wheel.axes * Vec3<double>{x, -radius_ * slope_, p_.radius + point.z};
    return normal.x + normal.z * rail->along;
  }

  /// By straight lines through the ends of the bracket, the staying one's value halved.
  double root(double low, double at_low, double high, double at_high) const {
    constexpr double tolerance = 1e-10; // mm
    double x = low;
    for (int k = 0; k < 80 && high - low > tolerance; ++k) {
      const double next = low - at_low * (high - low) / (at_high - at_low);
      if (std::abs(next - x) < tolerance) return next;
      x = next;
      const auto value = slope_difference(x);
      if (!value) return x;
      if (*value <= 0)
        low = x, at_low = *value, at_high *= 0.5;
      else
        high = x, at_high = *value, at_low *= 0.5;
    }
    return x;
  }

  double end_of_rail(double on, double off) const {
    for (int k = 0; k < 50; ++k) {
      const double middle = 0.5 * (on + off);
      (slope_difference(middle) ? on : off) = middle;
    }
    return on;
  }

  const Placement& p_;
  ProfilePoint at_;
  double radius_, slope_;
};

Locus locus_on_slices(const Placement& p, const PointRange& range) {
  const ProfileCurve& wheel = *p.wheel_profile.curve;
  Locus locus{SpaceCurve({0}, {{}}, {}), {}};
  std::vector<double> s;
  std::vector<Vec3<double>> on_wheel, piece;
  const auto end_piece = [&] {
    if (piece.size() > 1) locus.below.push_back(joined(piece));
    piece.clear();
  };
  for (std::size_t k = range.first; k <= range.last; ++k) {
    const ProfilePoint& at = wheel.points()[k];
    s.push_back(wheel.s_of(k));
    const double slope = slope_at(wheel, s.back());
    const auto contact = CircleOverSlices(p, at, slope).nearest();
    on_wheel.push_back(contact ? contact->on_wheel : p.wheel.outer(lowest_on_circle(p, at, slope)));
    if (!contact) {
      end_piece();
      continue;
    }
    piece.push_back(contact->on_rail);
  }
  end_piece();
  locus.wheel = joined(std::move(s), std::move(on_wheel));
  return locus;
}

Locus contact_locus(const Placement& p, const ProfileCurve& rail) {
  const ProfileCurve& wheel = *p.wheel_profile.curve;
  const double roll = std::atan2(p.wheel.axes.ey.z, p.wheel.axes.ez.z);
  const PointRange range = without_folds(wheel.moved(roll, 0, 0));
  if (p.on_roller()) return locus_on_roller(p, rail, range);
  if (p.rail_profile.varies()) return locus_on_slices(p, range);
  std::vector<double> s;
  std::vector<Vec3<double>> points;
  for (std::size_t k = range.first; k <= range.last; ++k) {
    s.push_back(wheel.s_of(k));
    points.push_back(p.wheel.outer(lowest_on_circle(p, wheel.points()[k], slope_at(wheel, s.back()))));
  }
  return {joined(std::move(s), std::move(points)), {}};
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
    if (line.gap[k] < 777) line.gap[k] -= depth;
  }
  return line;
}

GapLine find_gap_line(const Placement& p, const ProfileCurve& rail, double ds) {
  const Locus locus = contact_locus(p, rail);
  GapLine line;
  const double dy = SearchThresholds::locus_step * ds;
  const auto [least_y, greatest_y] =
      p.rail_profile.varies() ? whole_extent(p, rail) : std::pair(rail.least_y(), rail.greatest_y());
  const auto count = static_cast<std::size_t>(std::floor((greatest_y - least_y) / dy + 1e-9)) + 1;
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
