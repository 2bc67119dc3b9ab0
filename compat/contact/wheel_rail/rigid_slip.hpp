#pragma once

#include "compat/contact/wheel_rail/undeformed_distance.hpp"

#include <vector>

namespace microslip::contact_program {

/// Relative motion of the bodies at a patch: in rolling creepages, in a shift the increments [m], [rad].
struct PatchMotion {
  double velocity = mm; ///< V [m/s], the mean of both surfaces'; a mm/s in a shift
  bool backward = false;
  double xi = 0, eta = 0, phi = 0; ///< CKSI, CETA [-], CPHI [rad/m]
  std::vector<double> extra;       ///< what the elements slip besides, x and y in turn; empty: nothing
};

/// At the patch's reference, on the rail's surface and, `approach` deeper, on the wheel's.
PatchMotion patch_motion(const WheelRailData& right, const Placement& placement, const PatchFrame& frame,
                         double approach, bool is_shift);

/// Slip of the true surfaces at each element, across which `rail_share` of the slip on the rail displaces particles:
/// the velocity relative to the mean particles' path along the track, in the row's plane. The creepages are those that
/// fit best where the bodies overlap, and V is the wheelset's speed.
PatchMotion surface_motion(const WheelRailData& right, const Placement& placement, const PatchFrame& frame,
                           const UndeformedDistance& distance, double rail_share, double facphi, bool is_shift);

} // namespace microslip::contact_program
