#include "microslip/railway/virtual_penetration.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

constexpr double longest_spacing = 2.5e-4; // of samples [m]
constexpr int least_intervals = 12;        // across all regions

} // namespace

LocusPoint<double> wheel_above(const WheelLocus<double>& locus, const Profile& wheel, const Vec3<double>& point,
                               double precision, double& wheel_s) {
  constexpr int most_steps = 20;
  constexpr double longest = 2e-3, least_cosine = 0.02; // [m], [-]
  LocusPoint<double> there;
  for (int k = 0; k < most_steps; ++k) {
    there = locus.at(arc_point(wheel.at(wheel_s)));
    const double along = there.speed * there.cosine;
    const double move = (point.y - there.place.y) / (std::abs(along) > least_cosine ? along : least_cosine);
    wheel_s += std::clamp(move, -longest, longest);
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
    : rail_(&rail), wheel_(&wheel) {
  samples_.reserve(most_samples(rail, most_regions));
}

/// A sample above the rail's s, from the wheel's parameter on. Returns the sine of the angle by which the wheel's
/// surface leans against the rail's.
double VirtualPenetration::add(const WheelPlacement<double>& placement, const WheelLocus<double>& locus, double s,
                               double wheel_s) {
  constexpr double precision = 1e-7; // [m]
  const CurvePoint r = rail_->at(s);
  const Vec3<double> point = placement.rail.frame.outer({0, r.value.y, r.value.z});
  const Vec3<double> along = placement.rail.frame.axes * Vec3<double>{0, r.first.y, r.first.z};
  const double size = std::sqrt(along.y * along.y + along.z * along.z);
  const LocusPoint<double> wheel = wheel_above(locus, *wheel_, point, precision, wheel_s);
  const double overlap = -height_above(wheel, point);
  samples_.push_back({.s = s,
                      .wheel_s = wheel_s,
                      .overlap = std::isfinite(overlap) ? std::max(overlap, 0.0) : 0.0,
                      .level = along.y / size});
  return (along.y * wheel.sine - along.z * wheel.cosine) / size;
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
    const double rate = region_length > 0 ? (outer.s_wheel - inner.s_wheel) / region_length : 1;
    double slope = add(placement, locus, inner.s_rail, inner.s_wheel);
    const auto continue_to = [&](double s) {
      const Sample before = samples_.back();
      const double next = add(placement, locus, s, before.wheel_s + (s - before.s) * rate), step = s - before.s;
      samples_[samples_.size() - 2].curvature = step > 0 ? std::abs(next - slope) / step : 0;
      slope = next;
    };
    if (spacing > 0)
      for (double k = std::floor(inner.s_rail / spacing) + 1; k * spacing < outer.s_rail; ++k) continue_to(k * spacing);
    continue_to(outer.s_rail);
    samples_.back().last = true;
  }
}

} // namespace microslip
