#pragma once

#include "compat/contact/wheel_rail/profile_curve.hpp"
#include "microslip/railway/profile_surface.hpp"

#include <memory>

namespace microslip::contact_program {

/// A profile as a record names it: one curve, or slices that make it vary along the track or around the wheel [mm].
struct ProfileShape {
  std::shared_ptr<const ProfileCurve> curve; ///< the first of the slices, if there are some
  /// Of the slices, u in mm along the track or in rad around the wheel, v from the gauge side on; none without them.
  std::shared_ptr<const ProfileSurface> surface = {};

  bool varies() const { return surface != nullptr; }
};

} // namespace microslip::contact_program
