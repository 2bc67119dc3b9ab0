#include "compat/contact/wheel_rail/varied_wheel.hpp"

#include "compat/contact/wheel_rail/search_thresholds.hpp"

#include <cmath>

namespace microslip::contact_program {

std::optional<WheelPoint> wheel_point(const Placement& p, double theta, double v) {
  const auto at = p.wheel_profile.surface->at(theta, v);
  if (!at) return {};
  const double radius = p.radius + at->value.z, s = std::sin(theta + p.pitch), c = std::cos(theta + p.pitch);
  return WheelPoint{{radius * s, at->value.y, radius * c - p.radius},
                    {radius * c + at->du.z * s, at->du.y, -radius * s + at->du.z * c},
                    {at->dv.z * s, at->dv.y, at->dv.z * c}};
}

SurfaceMesh varied_lower_side(const Placement& p, double dx) {
  constexpr double reach = SearchThresholds::reach_varied;
  int count = static_cast<int>(std::lround(2 * reach * p.radius / (SearchThresholds::step_along_varied * dx) + 2));
  count += count % 2 == 0;
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
