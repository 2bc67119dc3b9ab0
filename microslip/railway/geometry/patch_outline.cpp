#include "microslip/railway/geometry/patch_outline.hpp"

#include "microslip/railway/geometry/equivalent_rail.hpp"
#include "microslip/railway/geometry/wheel_locus.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace microslip {
namespace {

/// Gauss-Legendre points and weights of order 12 on [-1, 1], the positive half (Abramowitz & Stegun, table 25.4).
constexpr std::array<double, 6> nodes = {0.125233408511468915, 0.367831498998180194, 0.587317954286617447,
                                         0.769902674194304687, 0.904117256370474857, 0.981560634246719251};
constexpr std::array<double, 6> weights = {0.249147045813402785, 0.233492536538354809, 0.203167426723065922,
                                           0.160078328543346226, 0.106939325995318431, 0.047175336386511827};

Vec3<double> rail_point(const WheelPlacement<double>& placement, const Profile& rail, double rail_s) {
  const ProfilePoint p = rail.at(rail_s).value;
  return placement.rail.frame.outer({0, p.y, p.z});
}

/// A point of the wheel's locus, and the rail below or above it.
struct OverRail {
  Vec3<double> place;
  double rail_s = 0, overlap = 0; ///< [m]
};

/// Newton's method on the rail, from near `rail_s`.
OverRail over_rail(const WheelPlacement<double>& placement, const WheelLocus<double>& locus, const CurvePoint& wheel,
                   const Profile& rail, double rail_s) {
  constexpr int steps = 4;
  const LocusPoint<double> point = locus.at(arc_point(wheel));
  OverRail out{point.place, rail_s};
  const Frame<double>& frame = placement.rail.frame;
  for (int k = 0; k < steps; ++k) {
    const CurvePoint p = rail.at(out.rail_s);
    const Vec3<double> place = frame.outer({0, p.value.y, p.value.z});
    const Vec3<double> slope = frame.axes * Vec3<double>{0, p.first.y, p.first.z};
    const double step = (out.place.y - place.y) / std::max(slope.y, 0.02);
    out.overlap = place.z + slope.z * step - out.place.z;
    out.rail_s += std::clamp(step, -2e-3, 2e-3);
    if (std::abs(step) < 1e-9) break; // the error of the next one would be rounding
  }
  return out;
}

double inclination(const WheelPlacement<double>& placement, const Profile& rail, double rail_s) {
  const ProfilePoint slope = rail.at(rail_s).first;
  const Vec3<double> d = placement.rail.frame.axes * Vec3<double>{0, slope.y, slope.z};
  return std::atan2(d.z, d.y);
}

PatchFrame frame_at(const WheelPlacement<double>& placement, const Profile& rail, double x, double angle,
                    double rail_s) {
  PatchFrame frame{rail_point(placement, rail, rail_s), angle, rail_s};
  frame.origin.x = x;
  return frame;
}

/// The coordinate s that rows of a frame have at a point of the rail: along the plane, or along the rail's surface.
double s_of(const WheelPlacement<double>& placement, const Profile& rail, const PatchFrame& frame, PatchShape surface,
            double rail_s) {
  if (surface != PatchShape::flat) return rail_s - frame.rail_s;
  return dot(frame.tangent(), rail_point(placement, rail, rail_s) - frame.origin);
}

/// The least distance of a line across the track, and how far the bodies overlap there along it [m].
struct Alongside {
  double x = 0, low = 0, high = 0;
};
Alongside alongside(const WheelPlacement<double>& placement, const CurvePoint& on_wheel, double wheel_s,
                    const OverRail& point, double depth, const EquivalentRail* equivalent) {
  if (!equivalent) {
    const double x = point.place.x, reach = std::sqrt(2 * (placement.radius - on_wheel.value.z) * depth);
    return {x, x - reach, x + reach};
  }
  const double x = equivalent->at(point.rail_s).x;
  const auto overlap = equivalent->find_overlap(placement, point.rail_s, wheel_s);
  return overlap ? Alongside{x, overlap->low, overlap->high} : Alongside{x, x, x};
}

} // namespace

double clearance_between(const WheelPlacement<double>& placement, const Profile& rail, const Profile& wheel,
                         const PatchOutline& low, const PatchOutline& high) {
  constexpr int intervals = 12;
  const WheelLocus<double> locus(placement.wheel.frame, placement.radius);
  double clearance = 0, rail_s = low.outer.s_rail;
  for (int k = 1; k < intervals; ++k) {
    const double t = static_cast<double>(k) / intervals;
    const CurvePoint on_wheel = wheel.at((1 - t) * low.outer.s_wheel + t * high.inner.s_wheel);
    rail_s += (high.inner.s_rail - low.outer.s_rail) / intervals;
    clearance = std::max(clearance, -over_rail(placement, locus, on_wheel, rail, rail_s).overlap);
  }
  return clearance;
}

PatchOutline joined(const WheelPlacement<double>& placement, const Profile& rail,
                    std::span<const PatchOutline> outlines, std::span<const double> shares, PatchShape surface) {
  PatchOutline out;
  double x = 0, angle = 0, rail_s = 0, wheel_s = 0;
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    const PatchOutline& one = outlines[k];
    const double weight = one.weight * shares[k];
    out.weight += weight;
    x += weight * one.frame.origin.x, angle += weight * one.frame.angle, rail_s += weight * one.frame.rail_s;
    wheel_s += weight * one.wheel_s;
  }
  out.frame = frame_at(placement, rail, x / out.weight, angle / out.weight, rail_s / out.weight);
  out.wheel_s = wheel_s / out.weight;
  out.x_low = out.s_low = std::numeric_limits<double>::infinity();
  out.x_high = out.s_high = -std::numeric_limits<double>::infinity();
  double least_angle = out.x_low, largest_angle = out.x_high;
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    if (shares[k] < 1) continue;
    const PatchOutline& one = outlines[k];
    const double ahead = one.frame.origin.x - out.frame.origin.x;
    out.x_low = std::min(out.x_low, ahead + one.x_low), out.x_high = std::max(out.x_high, ahead + one.x_high);
    out.s_low = std::min(out.s_low, s_of(placement, rail, out.frame, surface, one.inner.s_rail));
    out.s_high = std::max(out.s_high, s_of(placement, rail, out.frame, surface, one.outer.s_rail));
    least_angle = std::min(least_angle, one.frame.angle - one.turn / 2);
    largest_angle = std::max(largest_angle, one.frame.angle + one.turn / 2);
  }
  out.turn = largest_angle - least_angle;
  return out;
}

PatchOutline find_outline(const WheelPlacement<double>& placement, const Profile& rail, const Profile& wheel,
                          const ContactRegion& region, PatchShape surface, const EquivalentRail* equivalent) {
  PatchOutline out;
  out.inner = region.inner, out.outer = region.outer;
  const WheelLocus<double> locus(placement.wheel.frame, placement.radius);
  const auto between = [](double low, double high, double t) { return (low + high) / 2 + t * (high - low) / 2; };
  double sum = 0, x = 0, angle = 0, rail_s = 0, wheel_s = 0;
  double x_low = std::numeric_limits<double>::infinity(), x_high = -x_low;
  for (std::size_t k = 0; k < 4 * nodes.size(); ++k) {
    const double node = nodes[k / 4], t = (k % 2 == 0 ? node : -node) / 2 + (k % 4 < 2 ? 0.5 : -0.5);
    const double s = between(region.inner.s_wheel, region.outer.s_wheel, t);
    const CurvePoint on_wheel = wheel.at(s);
    const OverRail point =
        over_rail(placement, locus, on_wheel, rail, between(region.inner.s_rail, region.outer.s_rail, t));
    const double depth = std::max(point.overlap, 0.0);
    const Alongside along = alongside(placement, on_wheel, s, point, depth, equivalent);
    x_low = std::min(x_low, along.low), x_high = std::max(x_high, along.high);
    const double weight = weights[k / 4] * depth * depth * std::sqrt(depth) * std::max(on_wheel.first.y, 0.0);
    sum += weight;
    x += weight * along.x, angle += weight * inclination(placement, rail, point.rail_s);
    rail_s += weight * point.rail_s, wheel_s += weight * s;
  }
  if (!(sum > 0)) return out; // touches in a point
  out.frame = frame_at(placement, rail, x / sum, angle / sum, rail_s / sum);
  out.wheel_s = wheel_s / sum;
  out.weight = sum * (region.outer.s_wheel - region.inner.s_wheel) / 4;
  out.x_low = x_low - out.frame.origin.x, out.x_high = x_high - out.frame.origin.x;

  out.s_low = s_of(placement, rail, out.frame, surface, region.inner.s_rail);
  out.s_high = s_of(placement, rail, out.frame, surface, region.outer.s_rail);
  out.turn =
      std::abs(inclination(placement, rail, region.outer.s_rail) - inclination(placement, rail, region.inner.s_rail));
  return out;
}

} // namespace microslip
