#pragma once

#include "compat/contact/wheel_rail/profile_curve.hpp"
#include "microslip/railway/profile/profile_surface.hpp"

#include <memory>
#include <optional>

namespace microslip::contact_program {

/// A profile as a record names it: one curve, or slices that make it vary along the track or around the wheel [m].
struct ProfileShape {
  std::shared_ptr<const ProfileCurve> curve; ///< the first of the slices, if there are some
  /// Surface of the slices, u in m along the track or in rad around the wheel, v from the gauge side on; or none.
  std::shared_ptr<const ProfileSurface> surface = {};

  bool varies() const { return surface != nullptr; }
};

/// The cross-section of a surface at u: the natural spline through its points; nothing where it is interrupted.
std::optional<ProfileCurve> cross_section(const ProfileSurface& surface, ProfileRole role, double u);

} // namespace microslip::contact_program
