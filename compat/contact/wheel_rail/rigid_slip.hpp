#pragma once

#include "compat/contact/wheel_rail/patch_frame.hpp"

namespace microslip::contact_program {

/// How the bodies move over each other at a patch: in rolling creepages, in a shift the increments [mm], [rad].
struct PatchMotion {
  double velocity = 1; ///< V [mm/s], the mean of both surfaces'; 1 in a shift
  bool backward = false;
  double xi = 0, eta = 0, phi = 0; ///< CKSI, CETA [-], CPHI [rad/mm]
};

/// At the patch's reference, on the rail's surface and, `approach` deeper, on the wheel's.
PatchMotion patch_motion(const WheelRailData& right, const Placement& placement, const PatchFrame& frame,
                         double approach, bool is_shift);

} // namespace microslip::contact_program
