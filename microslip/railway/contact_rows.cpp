#include "microslip/railway/contact_rows.hpp"

#include "microslip/railway/equivalent_rail.hpp"
#include "microslip/railway/wheel_locus.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace microslip {
namespace {

constexpr double rows_of_a_parabola = 14; // across the overlap
constexpr double least_density = 2.5;     // of the scale, over the overlap's length
// Of the scale across a parabola, sqrt(1/b^2 + (2.5/(2 b))^2) 2 b.
constexpr double scale_of_a_parabola = 3.2;
constexpr double nowhere = 1; // gap beside the wheel [m]

/// How the rail's surface and the wheel's profile in its position are inclined.
struct Slopes {
  double relative = 0; ///< sine of the angle by which the wheel's leans against the rail's
  double level = 1;    ///< cosine of the rail's inclination
};
Slopes slopes(const WheelPlacement<double>& placement, const CurvePoint& rail, const CurvePoint& wheel) {
  const Vec3<double> r = placement.rail.frame.axes * Vec3<double>{0, rail.first.y, rail.first.z};
  const Vec3<double> w = placement.wheel.frame.axes * Vec3<double>{0, wheel.first.y, wheel.first.z};
  const double length = std::sqrt(r.y * r.y + r.z * r.z);
  return {(r.y * w.z - r.z * w.y) / (length * std::sqrt(w.y * w.y + w.z * w.z)), r.y / length};
}

/// Curvature [1/m] of the wheel's surface along the track's x, by Euler's theorem from that around the axle and that of
/// the profile: with chi the angle between x and the circumference, sin(chi) = e_x/cos(alpha), e the axle.
double curvature_along_track(const WheelLocus<double>& locus, const ArcPoint& p) {
  constexpr double steepest = 0.02, least = 1e-3; // cosine; [1/m]
  const double cosine = std::max(std::abs(p.cosine), steepest),
               turned = std::min(locus.lean() / (cosine * cosine), 1.0);
  const double around = cosine / (locus.radius() - p.place.z), profile = p.turn / p.speed;
  return std::max(around * (1 - turned) + profile * turned, least);
}

/// By how much a minimum of the gap lies below the lowest pass to a deeper one, or to the end of the overlap [m]: where
/// two minima are about to become one, that of the higher one vanishes.
double prominence(std::span<const ContactPoint> points, std::size_t which, double lowering) {
  const double gap = points[which].gap;
  const auto rise = [&](auto begin, auto end) {
    double highest = gap;
    for (auto p = begin; p != end; ++p) {
      if (p->gap < gap) return highest - gap;
      highest = std::max(highest, p->gap);
    }
    return lowering - gap;
  };
  const auto here = points.begin() + static_cast<std::ptrdiff_t>(which);
  return std::min(rise(here + 1, points.end()), rise(std::make_reverse_iterator(here), points.rend()));
}

} // namespace

ContactRows::ContactRows(const Profile& rail, const Profile& wheel, std::size_t most_rows,
                         const EquivalentRail* equivalent)
    : rail_(&rail), wheel_(&wheel), equivalent_(equivalent), most_(most_rows) {
  rows_.reserve(most_rows);
  samples_.reserve(most_rows);
}

bool ContactRows::place(const WheelPlacement<double>& placement, std::span<const ContactRegion> regions,
                        std::span<const ContactPoint> points, double lowering, double depth) {
  rows_.clear(), samples_.clear();
  double overlap = 0, length = 0; // [m^2], [m]
  for (const ContactRegion& region : regions) {
    overlap += sample(placement, region);
    length += region.outer.s_rail - region.inner.s_rail;
  }
  // Of a parabola the overlap's area is 2/3 of length times depth; slopes of rough profiles may have less.
  measure(std::max(1.5 * overlap / depth, 0.3 * length), depth);
  const double phase = find_phase(regions, points, lowering);
  for (std::size_t k = 0; k < regions.size(); ++k)
    if (!cut(placement, regions[k], static_cast<int>(k), phase)) return false;
  return true;
}

/// Slopes at equal distances along a region; returns the integral of the overlap along it [m^2], which grows from both
/// ends as the slopes have it.
double ContactRows::sample(const WheelPlacement<double>& placement, const ContactRegion& region) {
  Samples& samples = samples_.emplace_back();
  samples.low = region.inner.s_rail;
  samples.step = (region.outer.s_rail - samples.low) / intervals;
  const double wheel_step = (region.outer.s_wheel - region.inner.s_wheel) / intervals;
  double sum = 0, depth = 0;
  for (int k = 0; k <= intervals; ++k) {
    const auto [slope, level] =
        slopes(placement, rail_->at(samples.low + k * samples.step), wheel_->at(region.inner.s_wheel + k * wheel_step));
    samples.slope[k] = slope, samples.level[k] = level;
    if (k == 0) continue;
    const double before = depth;
    depth -= samples.step * (slope + samples.slope[k - 1]) / 2;
    sum += samples.step * std::max(depth + before, 0.0) / 2;
  }
  return sum;
}

/// Counts rows through all regions: their density at each point, `length` [m] that of the overlap if it were a
/// parabola.
void ContactRows::measure(double length, double depth) {
  const double least = least_density / length;
  double before = 0;
  for (Samples& s : samples_) {
    s.measure.fill(before);
    if (!(s.step > 0)) continue; // the overlap is a point
    for (int k = 1; k <= intervals; ++k) {
      const double curvature = std::abs(s.slope[k] - s.slope[k - 1]) / s.step;
      const double along_normal = depth * std::max((s.level[k] + s.level[k - 1]) / 2, 0.05);
      const double density = std::sqrt(curvature / (2 * along_normal) + least * least);
      s.measure[k] = s.measure[k - 1] + rows_of_a_parabola / scale_of_a_parabola * density * s.step;
    }
    before = s.measure[intervals];
  }
  // Where curvatures change as quickly as on rough profiles all rows are wider. A region's ends cut one more off.
  const double most = static_cast<double>(most_) - static_cast<double>(samples_.size()) - 1;
  if (!(before > most) || !(most > 0)) return;
  for (Samples& s : samples_)
    for (double& rows : s.measure) rows *= most / before;
}

/// Where the edges lie in the count of rows, in [-1/2, 1/2]: at the deepest point, or where there are more of them at
/// the mean over the circle of where they would have them, each with its prominence squared.
double ContactRows::find_phase(std::span<const ContactRegion> regions, std::span<const ContactPoint> points,
                               double lowering) const {
  double cosine = 0, sine = 0;
  for (std::size_t k = 0; k < regions.size(); ++k) {
    const std::span<const ContactPoint> within = points.subspan(regions[k].first, regions[k].count);
    for (std::size_t i = 0; i < within.size(); ++i) {
      if (!within[i].minimum) continue;
      const double weight = std::pow(prominence(within, i, lowering), 2);
      const double turn = 2 * std::numbers::pi * samples_[k].measure_at(within[i].s_rail);
      cosine += weight * std::cos(turn), sine += weight * std::sin(turn);
    }
  }
  return std::atan2(sine, cosine) / (2 * std::numbers::pi);
}

double ContactRows::Samples::measure_at(double s) const {
  if (!(step > 0)) return measure[0];
  const double place = std::clamp((s - low) / step, 0.0, static_cast<double>(intervals));
  const int k = std::min(static_cast<int>(place), intervals - 1);
  return measure[k] + (place - k) * (measure[k + 1] - measure[k]);
}

bool ContactRows::cut(const WheelPlacement<double>& placement, const ContactRegion& region, int index, double phase) {
  const Samples& samples = samples_[static_cast<std::size_t>(index)];
  const double length = samples.step * intervals;
  if (!(length > 0)) return true;
  const double wheel_rate = (region.outer.s_wheel - region.inner.s_wheel) / length;
  double edge = samples.low;
  const std::size_t first = rows_.size();
  const auto add_until = [&](double next) {
    if (!(next > edge)) return true;
    if (rows_.size() == most_) return false;
    add(placement, edge, next, region.inner.s_wheel + ((edge + next) / 2 - samples.low) * wheel_rate, index);
    edge = next;
    return true;
  };
  for (int k = 1; k <= intervals; ++k) {
    const double from = samples.measure[k - 1], to = samples.measure[k];
    for (double mark = std::floor(from - phase) + 1 + phase; mark < to; ++mark)
      if (!add_until(samples.low + (k - 1 + (mark - from) / (to - from)) * samples.step)) return false;
  }
  if (!add_until(samples.low + length)) return false;
  if (rows_.size() > first) rows_[first].joined = false;
  return true;
}

/// Newton's method for the wheel's circle whose lowest line is above the rail's point.
void ContactRows::add(const WheelPlacement<double>& placement, double low, double high, double wheel_s, int region) {
  constexpr int most_steps = 20;
  constexpr double exact = 1e-13, longest = 2e-3; // [m]
  ContactRow& row = rows_.emplace_back();
  row.region = region, row.joined = true;
  row.at.s = row.at.rail_s = (low + high) / 2;
  const Frame<double>& rail = placement.rail.frame;
  const CurvePoint r = rail_->at(row.at.s);
  const Vec3<double> point = rail.outer({0, r.value.y, r.value.z});
  const Vec3<double> slope = rail.axes * Vec3<double>{0, r.first.y, r.first.z};
  row.at.point = {0, point.y, point.z};
  row.at.angle = std::atan2(slope.z, slope.y);

  const WheelLocus<double> locus(placement.wheel.frame, placement.radius);
  LocusPoint<double> there;
  for (int k = 0; k < most_steps; ++k) {
    there = locus.at(arc_point(wheel_->at(wheel_s)));
    const double along = there.speed * there.cosine;
    const double move = (point.y - there.place.y) / (std::abs(along) > 0.02 ? along : 0.02);
    wheel_s += std::clamp(move, -longest, longest);
    if (std::abs(move) < 1e3 * exact) break;
  }
  // The remaining distance along the tangent.
  const double rise = (point.y - there.place.y) * there.sine / there.cosine;
  const double above = there.place.z + rise - point.z;
  row.at.wheel_s = wheel_s;
  const double cosine = std::cos(row.at.angle), sine = std::sin(row.at.angle);
  const double along_normal = cosine + sine * there.sine / there.cosine;
  row.normal.place = {there.place.x, point.y, point.z};
  row.normal.s = row.at.s;
  row.normal.angle = row.at.angle;
  row.normal.width = (high - low) * std::hypot(slope.y, slope.z);
  const bool on_wheel = wheel_s >= 0 && wheel_s <= wheel_->length();
  const double gap = above / along_normal;
  row.normal.gap = on_wheel && std::isfinite(gap) ? gap : nowhere;
  row.normal.curvature = curvature_along_track(locus, arc_point(wheel_->at(wheel_s))) / 2;
  if (!equivalent_) return;
  const EquivalentRail::Along along = equivalent_->at(row.at.s);
  row.normal.place.x = along.x, row.normal.curvature = along.curvature / 2;
  row.at.slope = along.slope;
}

} // namespace microslip
