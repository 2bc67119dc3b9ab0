#include "compat/contact/wheel_rail/profile_shape.hpp"

namespace microslip::contact_program {

std::optional<ProfileCurve> cross_section(const ProfileSurface& surface, ProfileRole role, double u) {
  const SurfaceSlice section = surface.section(u);
  if (section.points.size() < 2) return {};
  std::vector<std::size_t> kinks;
  for (const std::size_t v : surface.kinks())
    if (v > section.first && v < section.last()) kinks.push_back(v - section.first);
  return ProfileCurve(role, section.points, kinks);
}

} // namespace microslip::contact_program
