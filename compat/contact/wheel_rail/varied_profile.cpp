#include "compat/contact/wheel_rail/varied_profile.hpp"

#include "compat/contact/wheel_rail/search_thresholds.hpp"

#include <cmath>

namespace microslip::contact_program {

std::optional<ProfileCurve> rail_section(const Placement& p, double x) {
  const auto curve = cross_section(*p.rail_profile.surface, ProfileRole::rail, p.place + x);
  if (!curve) return {};
  return curve->moved(roll_of(p.rail.axes), p.rail.origin.y, p.rail.origin.z);
}

std::pair<double, double> whole_extent(const Placement& p, const ProfileCurve& first) {
  const ProfileCurve& profile = *p.rail_profile.curve;
  const ProfileSurface& surface = *p.rail_profile.surface;
  return {first.least_y() + surface.least_y() - profile.least_y(),
          first.greatest_y() + surface.greatest_y() - profile.greatest_y()};
}

std::optional<RailPoint> rail_point(const Placement& p, const Vec3<double>& at) {
  const ProfileSurface& surface = *p.rail_profile.surface;
  const Vec3<double> on_rail = p.rail.inner(at);
  const double u = p.place + at.x;
  std::optional<SurfacePoint> top;
  for (const double v : surface.v_at_y(u, on_rail.y)) {
    const auto point = surface.at(u, v);
    if (point && (!top || point->value.z < top->value.z)) top = point;
  }
  if (!top || top->dv.y == 0) return {};
  return RailPoint{p.rail.outer({on_rail.x, on_rail.y, top->value.z}), top->du.z - top->dv.z * top->du.y / top->dv.y,
                   std::atan2(top->dv.z, top->dv.y) + roll_of(p.rail.axes)};
}

std::optional<WheelPoint> wheel_point(const Placement& p, double theta, double v) {
  const auto at = p.wheel_profile.surface->at(theta, v);
  if (!at) return {};
  const double radius = p.radius + at->value.z, s = std::sin(theta + p.pitch), c = std::cos(theta + p.pitch);
  return WheelPoint{{radius * s, at->value.y, radius * c - p.radius},
                    {radius * c + at->du.z * s, at->du.y, -radius * s + at->du.z * c},
                    {at->dv.z * s, at->dv.y, at->dv.z * c}};
}

SurfaceMesh varied_lower_side(const Placement& p, int count) {
  constexpr double reach = SearchThresholds::reach_varied;
  const std::size_t last = p.wheel_profile.surface->last_v();
  std::vector<Vec3<double>> points;
  for (std::size_t v = 0; v <= last; ++v)
    for (int i = 0; i < count; ++i) {
      const double theta = -p.pitch + reach * (2.0 * i / (count - 1) - 1);
      const auto at = wheel_point(p, theta, double(v));
      points.push_back(p.wheel.outer(at ? at->value : Vec3<double>{p.radius * std::sin(theta + p.pitch), 0, -0.999}));
    }
  return SurfaceMesh(count, static_cast<int>(last + 1), std::move(points));
}

} // namespace microslip::contact_program
