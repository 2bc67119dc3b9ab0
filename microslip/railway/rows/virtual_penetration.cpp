#include "microslip/railway/rows/virtual_penetration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace microslip {
namespace {

constexpr double longest_spacing = 2.5e-4; // of samples [m]
constexpr int least_intervals = 12;        // across all regions

} // namespace

WheelAbove wheel_above(const WheelLocus<double>& locus, const Profile& wheel, const Vec3<double>& point,
                       double precision, double s) {
  constexpr int most_steps = 20;
  constexpr double longest = 2e-3, least_cosine = 0.02; // [m], [-]
  WheelAbove there{{}, {}, s};
  for (int k = 0; k < most_steps; ++k) {
    there.profile = arc_point(wheel.at(there.s));
    there.locus = locus.at(there.profile);
    const double along = there.locus.speed * there.locus.cosine;
    const double move = (point.y - there.locus.place.y) / (std::abs(along) > least_cosine ? along : least_cosine);
    there.s += std::clamp(move, -longest, longest);
    if (std::abs(move) < precision) break;
  }
  return there;
}

double height_above(const LocusPoint<double>& wheel, const Vec3<double>& point) {
  return wheel.place.z + (point.y - wheel.place.y) * wheel.sine / wheel.cosine - point.z;
}

std::size_t VirtualPenetration::most_samples(const Profile& rail, std::size_t most_regions) {
  return static_cast<std::size_t>(rail.length() / longest_spacing) + least_intervals + 3 * most_regions;
}

VirtualPenetration::VirtualPenetration(const Profile& rail, const Profile& wheel, std::size_t most_regions)
    : rail_(&rail), wheel_(&wheel), overlaps_(static_cast<std::size_t>(rail.length() / longest_spacing) + 1) {
  samples_.reserve(most_samples(rail, most_regions));
}

/// Above the rail's s, from the wheel's parameter on.
VirtualPenetration::Overlap VirtualPenetration::find(const WheelPlacement<double>& placement,
                                                     const WheelLocus<double>& locus, double s, double wheel_s) const {
  constexpr double precision = 1e-9; // [m]
  const CurvePoint r = rail_->at(s);
  const Vec3<double> point = placement.rail.frame.outer({0, r.value.y, r.value.z});
  const Vec3<double> along = placement.rail.frame.axes * Vec3<double>{0, r.first.y, r.first.z};
  const double size = std::sqrt(along.y * along.y + along.z * along.z);
  const WheelAbove wheel = wheel_above(locus, *wheel_, point, precision, wheel_s);
  return {.wheel_s = wheel.s,
          .overlap = -height_above(wheel.locus, point),
          .level = along.y / size,
          .lean = (along.y * wheel.locus.sine - along.z * wheel.locus.cosine) / size,
          .height = placement.wheel.frame.origin.z,
          .search = search_};
}

/// Finds the overlap at a multiple of the longest spacing, once: other heights change it by as much.
VirtualPenetration::Overlap VirtualPenetration::find_kept(const WheelPlacement<double>& placement,
                                                          const WheelLocus<double>& locus, std::size_t multiple,
                                                          double wheel_s) {
  constexpr double same_part = 1e-3; // of the wheel, which may be above a point more than once [m]
  Overlap& kept = overlaps_[multiple];
  if (kept.search != search_ || !(std::abs(kept.wheel_s - wheel_s) < same_part))
    kept = find(placement, locus, static_cast<double>(multiple) * longest_spacing, wheel_s);
  Overlap there = kept;
  there.overlap += kept.height - placement.wheel.frame.origin.z;
  return there;
}

/// Adds a sample; returns the sine of the angle by which the wheel's surface leans against the rail's.
double VirtualPenetration::add(double s, const Overlap& there) {
  samples_.push_back({.s = s,
                      .wheel_s = there.wheel_s,
                      .overlap = std::isfinite(there.overlap) ? std::max(there.overlap, 0.0) : 0.0,
                      .level = there.level});
  return there.lean;
}

void VirtualPenetration::sample(const WheelPlacement<double>& placement, std::span<const ContactRegion> regions,
                                double depth) {
  const WheelLocus<double> locus(placement.wheel.frame, placement.radius);
  samples_.clear();
  depth_ = depth;
  double length = 0;
  for (const ContactRegion& region : regions) length += region.outer.s_rail - region.inner.s_rail;
  const double spacing = std::min(longest_spacing, length / least_intervals);
  for (const ContactRegion& region : regions) {
    const auto& inner = region.inner;
    const auto& outer = region.outer;
    const double region_length = outer.s_rail - inner.s_rail;
    double rate = region_length > 0 ? (outer.s_wheel - inner.s_wheel) / region_length : 1;
    double change = 0; // of that rate from interval to interval
    double slope = add(inner.s_rail, find(placement, locus, inner.s_rail, inner.s_wheel));
    const auto continue_to = [&](double s, auto&& find_there) {
      const Sample before = samples_.back();
      const double step = s - before.s, next = add(s, find_there(before.wheel_s + step * (rate + change)));
      samples_[samples_.size() - 2].curvature = step > 0 ? std::abs(next - slope) / step : 0;
      slope = next;
      if (!(step > spacing / 2)) return;
      const double last_rate = std::exchange(rate, (samples_.back().wheel_s - before.wheel_s) / step);
      change = rate - last_rate;
    };
    if (spacing > 0)
      for (double k = std::floor(inner.s_rail / spacing) + 1; k * spacing < outer.s_rail; ++k)
        continue_to(k * spacing, [&](double wheel_s) {
          const auto multiple = static_cast<std::size_t>(k);
          return spacing < longest_spacing || !(k >= 0) || multiple >= overlaps_.size()
                     ? find(placement, locus, k * spacing, wheel_s)
                     : find_kept(placement, locus, multiple, wheel_s);
        });
    continue_to(outer.s_rail, [&](double wheel_s) { return find(placement, locus, outer.s_rail, wheel_s); });
    samples_.back().last = true;
  }
}

double VirtualPenetration::depth_for(double vertical_force, double modulus, double radius) const {
  constexpr int rounds = 3, most_steps = 20;
  constexpr double precision = 1e-3; // of the depth
  double factor = modulus / std::numbers::sqrt2, lower = 0;
  for (int round = 0; round < rounds; ++round) {
    for (int step = 0; step < most_steps; ++step) { // the force is a convex function of the depth
      double force = 0, slope = 0;
      for_each_interval([&](std::size_t, const Sample& a, const Sample& b) {
        const double overlap = (a.overlap + b.overlap) / 2 + lower, level = (a.level + b.level) / 2;
        const double weight = overlap > 0 ? (b.s - a.s) * level * level : 0;
        force += weight * overlap, slope += weight;
      });
      if (!(slope > 0)) return depth_;
      const double change = (vertical_force / factor - force) / slope;
      lower += change;
      if (std::abs(change) < precision * depth_) break;
    }
    double area = 0, moment = 0, level_moment = 0; // of the overlap along the normal
    for_each_interval([&](std::size_t, const Sample& a, const Sample& b) {
      const double level = (a.level + b.level) / 2;
      const double overlap = level * std::max((a.overlap + b.overlap) / 2 + lower, 0.0), part = (b.s - a.s) * overlap;
      area += part, moment += part * overlap, level_moment += part * level;
    });
    const double depth = 1.25 * moment / area, across = 16.0 / 9 * depth * depth * depth / (area * area),
                 ratio = std::log(across * 2 * radius * area / level_moment);
    factor = modulus / std::numbers::sqrt2 * std::exp(ratio / 4) * (1 + 0.0225 * ratio * ratio);
  }
  return depth_ + lower;
}

} // namespace microslip
