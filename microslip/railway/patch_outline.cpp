#include "microslip/railway/patch_outline.hpp"

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

double inclination(const WheelPlacement<double>& placement, const Profile& rail, double rail_s) {
  const ProfilePoint slope = rail.at(rail_s).first;
  const Vec3<double> d = placement.rail.frame.axes * Vec3<double>{0, slope.y, slope.z};
  return std::atan2(d.z, d.y);
}

} // namespace

PatchOutline find_outline(const OverlapSearch& search, const WheelPlacement<double>& placement, const Profile& rail,
                          const Profile& wheel, const Overlap& overlap) {
  PatchOutline out;
  const double middle = (overlap.wheel_low + overlap.wheel_high) / 2;
  const double half = (overlap.wheel_high - overlap.wheel_low) / 2;
  double sum = 0, x = 0, angle = 0, rail_s = 0, wheel_s = 0;
  double x_low = std::numeric_limits<double>::infinity(), x_high = -x_low;
  LocusPoint near = search.locus_near(placement, middle);
  for (std::size_t k = 0; k < 2 * nodes.size(); ++k) {
    const double t = k % 2 == 0 ? nodes[k / 2] : -nodes[k / 2];
    const double s = middle + half * t;
    const LocusPoint point = search.locus(placement, s, near.rail_s + half * t);
    const double depth = std::max(-point.gap, 0.0);
    if (!point.valid) continue;
    const CurvePoint p = wheel.at(s);
    const double reach = std::sqrt(2 * (placement.radius - p.value.z) * depth);
    x_low = std::min(x_low, point.place.x - reach), x_high = std::max(x_high, point.place.x + reach);
    const double weight = weights[k / 2] * depth * depth * std::sqrt(depth) * p.first.y;
    sum += weight;
    x += weight * point.place.x, angle += weight * inclination(placement, rail, point.rail_s);
    rail_s += weight * point.rail_s, wheel_s += weight * s;
  }
  if (!(sum > 0)) { // touches in a point
    sum = 1, x = near.place.x, angle = inclination(placement, rail, near.rail_s);
    rail_s = near.rail_s, wheel_s = middle, x_low = x_high = x;
  }
  out.frame = {rail_point(placement, rail, rail_s / sum), angle / sum, rail_s / sum};
  out.frame.origin.x = x / sum;
  out.wheel_s = wheel_s / sum;
  out.x_low = x_low - out.frame.origin.x, out.x_high = x_high - out.frame.origin.x;

  const LocusPoint low = search.locus(placement, overlap.wheel_low, near.rail_s - half);
  const LocusPoint high = search.locus(placement, overlap.wheel_high, near.rail_s + half);
  const Vec3<double> along{0, std::cos(out.frame.angle), std::sin(out.frame.angle)};
  out.s_low = dot(along, low.place - out.frame.origin);
  out.s_high = dot(along, high.place - out.frame.origin);
  out.turn = std::abs(inclination(placement, rail, high.rail_s) - inclination(placement, rail, low.rail_s));
  return out;
}

} // namespace microslip
