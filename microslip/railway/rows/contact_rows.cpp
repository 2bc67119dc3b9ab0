#include "microslip/railway/rows/contact_rows.hpp"

#include "microslip/railway/geometry/equivalent_rail.hpp"
#include "microslip/railway/geometry/wheel_locus.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

using Sample = VirtualPenetration::Sample;

constexpr double rows_of_a_parabola = 15; // across the overlap, before they thin out towards its ends: 13 then
constexpr double least_density = 2.5;     // of the scale, over the overlap's length
// Of the scale across a parabola, sqrt(1/b^2 + (2.5/(2 b))^2) 2 b.
constexpr double scale_of_a_parabola = 3.2;
constexpr double nowhere = 1; // gap beside the wheel [m]

/// Share of the rows' density for an overlap over the greatest one: none where regions end, so that the count of rows
/// is smooth while they come, part and merge.
double fading(double overlap) {
  constexpr double half = 0.1;
  return overlap / (overlap + half);
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

} // namespace

ContactRows::ContactRows(const Profile& rail, const Profile& wheel, std::size_t most_rows,
                         const EquivalentRail* equivalent)
    : rail_(&rail), wheel_(&wheel), equivalent_(equivalent), most_(most_rows) {
  rows_.reserve(most_rows), last_.reserve(most_rows);
  count_.reserve(VirtualPenetration::most_samples(rail, most_rows));
}

bool ContactRows::place(const WheelPlacement<double>& placement, std::span<const ContactRegion> regions,
                        const VirtualPenetration& penetration) {
  std::swap(rows_, last_);
  rows_.clear();
  if (regions.size() >= most_) return false;
  count_rows(penetration);
  // An edge lies where the rows' count has its mean, with the squared overlap as weight. A mean over points, as the
  // deepest ones, would jump where two of them are equally deep.
  double sum = 0, moment = 0;
  penetration.for_each_interval([&](std::size_t k, const Sample& a, const Sample& b) {
    const double weight = std::pow(a.overlap + b.overlap, 2) * (count_[k + 1] - count_[k]);
    sum += weight, moment += weight * (count_[k] + count_[k + 1]) / 2;
  });
  const double phase = sum > 0 ? moment / sum : 0;
  const WheelLocus<double> locus(placement.wheel.frame, placement.radius);
  const std::span<const Sample> samples = penetration.samples();
  for (std::size_t first = 0, next = 0, region = 0; first < samples.size(); first = next, ++region) {
    while (!samples[next++].last) {
    }
    if (!cut(placement.rail.frame, locus, samples.subspan(first, next - first), static_cast<int>(region),
             &count_[first], phase))
      return false;
  }
  find_before();
  return true;
}

/// A number stands twice where a row is parted between two regions.
void ContactRows::find_before() {
  std::size_t old = 0;
  for (ContactRow& row : rows_) {
    while (old < last_.size() && last_[old].number < row.number) ++old;
    if (old < last_.size() && last_[old].number == row.number) row.normal.before = old++;
  }
}

/// Counts rows through all regions: the integral of their density up to each sample.
void ContactRows::count_rows(const VirtualPenetration& penetration) {
  const double depth = penetration.depth();
  const auto share = [depth](const Sample& a, const Sample& b) {
    return fading((a.overlap + b.overlap) / (2 * depth));
  };
  double overlap = 0, faded = 0;
  penetration.for_each_interval([&](std::size_t, const Sample& a, const Sample& b) {
    overlap += (b.s - a.s) * (a.overlap + b.overlap) / 2, faded += (b.s - a.s) * share(a, b);
  });
  // Of a parabola the overlap's area is 2/3 of length times depth; slopes of rough profiles may have less.
  const double least = least_density / std::max(1.5 * overlap / depth, 0.3 * faded);
  count_.assign(penetration.samples().size(), 0.0);
  double count = 0;
  int regions = 0;
  penetration.for_each_interval([&](std::size_t k, const Sample& a, const Sample& b) {
    const double along_normal = depth * std::max((a.level + b.level) / 2, 0.05);
    const double density = std::sqrt(a.curvature / (2 * along_normal) + least * least);
    count_[k] = count;
    count_[k + 1] = count += rows_of_a_parabola / scale_of_a_parabola * density * (b.s - a.s) * share(a, b);
    regions += b.last;
  });
  // Where curvatures change as quickly as on rough profiles all rows are wider. A region's ends cut one more off.
  const double most = static_cast<double>(most_) - regions - 1;
  if (!(count > most)) return;
  for (double& rows : count_) rows *= most / count;
}

bool ContactRows::cut(const Frame<double>& rail, const WheelLocus<double>& locus, std::span<const Sample> region,
                      int index, const double* count, double phase) {
  const std::size_t first_row = rows_.size();
  double edge = region.front().s;
  int number = static_cast<int>(std::floor(*count - phase));
  std::size_t at = 0;
  const auto add_until = [&](double next) {
    if (!(next > edge)) return true;
    if (rows_.size() == most_) return false;
    const double middle = (edge + next) / 2;
    while (at + 2 < region.size() && region[at + 1].s < middle) ++at;
    const Sample &a = region[at], &b = region[at + 1];
    ContactRow& row = add(rail, locus, edge, next, a.wheel_s + (middle - a.s) / (b.s - a.s) * (b.wheel_s - a.wheel_s));
    row.region = index, row.number = number, row.joined = true;
    edge = next;
    return true;
  };
  for (std::size_t k = 1; k < region.size(); ++k) {
    const double from = count[k - 1], to = count[k], low = region[k - 1].s;
    double mark = std::floor(from - phase) + 1 + phase;
    while (mark < to) {
      if (!add_until(low + (mark - from) / (to - from) * (region[k].s - low))) return false;
      ++mark, ++number;
    }
  }
  if (!add_until(region.back().s)) return false;
  if (rows_.size() > first_row) rows_[first_row].joined = false;
  return true;
}

ContactRow& ContactRows::add(const Frame<double>& rail, const WheelLocus<double>& locus, double low, double high,
                             double wheel_s) {
  constexpr double precision = 1e-12; // [m]
  ContactRow& row = rows_.emplace_back();
  row.at.s = row.at.rail_s = (low + high) / 2;
  const CurvePoint r = rail_->at(row.at.s);
  const Vec3<double> point = rail.outer({0, r.value.y, r.value.z});
  const Vec3<double> slope = rail.axes * Vec3<double>{0, r.first.y, r.first.z};
  row.at.point = {0, point.y, point.z};
  row.at.angle = std::atan2(slope.z, slope.y);

  const WheelAbove there = wheel_above(locus, *wheel_, point, precision, wheel_s);
  row.at.wheel_s = there.s;
  const double size = std::sqrt(slope.y * slope.y + slope.z * slope.z);
  const double along_normal = (slope.y + slope.z * there.locus.sine / there.locus.cosine) / size;
  row.normal.place = {there.locus.place.x, point.y, point.z};
  row.normal.s = row.at.s;
  row.normal.angle = row.at.angle;
  row.normal.width = (high - low) * size;
  const bool on_wheel = there.s >= 0 && there.s <= wheel_->length();
  const double gap = height_above(there.locus, point) / along_normal;
  row.normal.gap = on_wheel && std::isfinite(gap) ? gap : nowhere;
  row.normal.curvature = curvature_along_track(locus, there.profile) / 2;
  if (!equivalent_) return row;
  const EquivalentRail::Along along = equivalent_->at(row.at.s);
  row.normal.place.x = along.x, row.normal.curvature = along.curvature / 2;
  row.at.slope = along.slope;
  return row;
}

} // namespace microslip
