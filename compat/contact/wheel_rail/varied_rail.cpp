#include "compat/contact/wheel_rail/varied_rail.hpp"

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

} // namespace microslip::contact_program
