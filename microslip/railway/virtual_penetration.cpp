#include "microslip/railway/virtual_penetration.hpp"

#include "microslip/numerics/bracketed_root.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

constexpr double longest_spacing = 2.5e-4; // of samples [m]
constexpr int least_intervals = 12;        // across all regions

double square(double x) {
  return x * x;
}

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

void VirtualPenetration::add(const WheelPlacement<double>& placement, const WheelLocus<double>& locus, double s,
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
                      .slope = (along.y * wheel.sine - along.z * wheel.cosine) / size,
                      .level = along.y / size});
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
    const ContactRegion::End &inner = region.inner, &outer = region.outer;
    const double rate =
        outer.s_rail > inner.s_rail ? (outer.s_wheel - inner.s_wheel) / (outer.s_rail - inner.s_rail) : 1;
    add(placement, locus, inner.s_rail, inner.s_wheel);
    if (spacing > 0)
      for (double k = std::floor(inner.s_rail / spacing) + 1; k * spacing < outer.s_rail; ++k)
        add(placement, locus, k * spacing, samples_.back().wheel_s + (k * spacing - samples_.back().s) * rate);
    add(placement, locus, outer.s_rail, outer.s_wheel);
    samples_.back().last = true;
  }
  for (std::size_t k = 0; k + 1 < samples_.size(); ++k) {
    const double step = samples_[k + 1].s - samples_[k].s;
    if (!samples_[k].last && step > 0)
      samples_[k].curvature = std::abs(samples_[k + 1].slope - samples_[k].slope) / step;
  }
}

/// Overlaps count from their zeros on, which lie on straight lines between samples.
double VirtualPenetration::force_at(double depth, double modulus, double radius) const {
  double vertical = 0, area = 0, moment = 0; // integrals of the overlap, twice along the normal, and of its square
  for_each_interval([&](std::size_t, const Sample& a, const Sample& b) {
    const double level = std::max((a.level + b.level) / 2, 0.0), rise = depth - depth_;
    const double high = std::max(a.overlap, b.overlap) + rise, low = std::min(a.overlap, b.overlap) + rise;
    if (!(high > 0)) return;
    const double share = low < 0 ? high / (high - low) : 1, least = std::max(low, 0.0);
    const double length = share * (b.s - a.s);
    vertical += level * level * length * (high + least) / 2;
    area += level * length * (high + least) / 2;
    moment += level * level * length * (high * high + high * least + least * least) / 3;
  });
  if (!(area > 0)) return 0;
  // The parabola's depth, and its curvature over the wheel's.
  const double deepest = 1.25 * moment / area, ratio = 16 / 9.0 * deepest * square(deepest / area) * 2 * radius;
  const double log_ratio = std::log(std::clamp(ratio, 1e-4, 1e4));
  return modulus / std::numbers::sqrt2 * std::exp(log_ratio / 4) * (1 + 0.0225 * log_ratio * log_ratio) * vertical;
}

double VirtualPenetration::bearing_depth(const CombinedMaterial& material, double radius, double vertical_force) const {
  constexpr double tolerance = 1e-10, precision = 1e-16; // of the force, relative; [m]
  const auto missing = [&](double depth) {
    return force_at(depth, material.contact_modulus(), radius) / vertical_force - 1;
  };
  const RootSide deepest{depth_, missing(depth_)};
  if (!(deepest.value > 0)) return depth_;
  return find_bracketed_root({0, -1}, deepest, tolerance, precision, missing).side.at;
}

} // namespace microslip
