#include "compat/contact/wheel_rail/varied_wheel.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::contact_program {
namespace {

/// The frame `inner`, which is given in outer axes, in those of `outer`.
Frame<double> seen_from(const Frame<double>& outer, const Frame<double>& inner) {
  const Rotation<double>& r = outer.axes;
  return {outer.inner(inner.origin), {r.back(inner.axes.ex), r.back(inner.axes.ey), r.back(inner.axes.ez)}};
}

constexpr double reach = 0.2; // rad to either side of the lowest point

} // namespace

std::optional<WheelPoint> wheel_point(const Placement& p, double theta, double v) {
  const auto at = p.wheel_profile.surface->at(theta, v);
  if (!at) return {};
  const double radius = p.radius + at->value.z, s = std::sin(theta + p.pitch), c = std::cos(theta + p.pitch);
  return WheelPoint{{radius * s, at->value.y, radius * c - p.radius},
                    {radius * c + at->du.z * s, at->du.y, -radius * s + at->du.z * c},
                    {at->dv.z * s, at->dv.y, at->dv.z * c}};
}

int lower_side_points(double radius, double dx) {
  const int count = static_cast<int>(std::lround(2 * reach * radius / (4 * dx) + 2));
  return count + (count % 2 == 0);
}

SurfaceMesh varied_lower_side(const Placement& p, double dx) {
  const int count = lower_side_points(p.radius, dx);
  const std::size_t last = p.wheel_profile.surface->last_v();
  std::vector<Vec3<double>> points;
  for (std::size_t v = 0; v <= last; ++v)
    for (int i = 0; i < count; ++i) {
      const double theta = -p.pitch + reach * (2.0 * i / (count - 1) - 1);
      const auto at = wheel_point(p, theta, double(v));
      points.push_back(p.wheel.outer(at ? at->value : Vec3<double>{p.radius * std::sin(theta + p.pitch), 0, -999}));
    }
  return SurfaceMesh(count, static_cast<int>(last + 1), std::move(points));
}

VariedWheelHeights::VariedWheelHeights(const PatchFrame& frame, const Placement& placement)
    : placement_(placement), wheel_(seen_from(frame.grid, placement.wheel)) {}

/// Where the wheel's profile comes nearest to the point of the plane.
std::optional<VariedWheelHeights::Place> VariedWheelHeights::guess(double x, double s) const {
  const Vec3<double> at = wheel_.inner({x, s, 0});
  const double theta = -placement_.pitch + std::atan2(at.x, placement_.radius + at.z);
  const ProfileSurface& surface = *placement_.wheel_profile.surface;
  const SurfaceSlice section = surface.section(theta);
  if (section.points.empty()) return {};
  const auto distance = [&](const ProfilePoint& p) { return std::hypot(p.y - at.y, p.z - at.z); };
  const auto nearest = std::min_element(section.points.begin(), section.points.end(),
                                        [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return Place{theta, double(section.first) + double(nearest - section.points.begin())};
}

std::optional<double> VariedWheelHeights::follow(Place place, double x, double s) {
  const double last_v = double(placement_.wheel_profile.surface->last_v());
  for (int step = 0; step < 30; ++step) {
    const auto point = wheel_point(placement_, place.theta, std::clamp(place.v, 0.0, last_v));
    if (!point) return {};
    const Vec3<double> at = wheel_.outer(point->value), around = wheel_.axes * point->around,
                       across = wheel_.axes * point->across;
    const double det = around.x * across.y - around.y * across.x;
    if (!(std::abs(det) > 1e-9 * placement_.radius)) return {};
    const double fx = x - at.x, fy = s - at.y;
    const double dtheta = (fx * across.y - fy * across.x) / det, dv = (around.x * fy - around.y * fx) / det;
    if (std::abs(fx) + std::abs(fy) < 1e-12 * placement_.radius) {
      if (place.v < 0 || place.v > last_v) return {};
      last_ = place;
      return at.z;
    }
    place.theta += std::clamp(dtheta, -0.05, 0.05);
    place.v = std::clamp(place.v, 0.0, last_v) + std::clamp(dv, -20.0, 20.0);
  }
  return {};
}

std::optional<double> VariedWheelHeights::height(double x, double s) {
  if (last_)
    if (const auto z = follow(*last_, x, s)) return z;
  const auto start = guess(x, s);
  return start ? follow(*start, x, s) : std::nullopt;
}

} // namespace microslip::contact_program
