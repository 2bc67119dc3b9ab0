#pragma once

#include "microslip/railway/contact_search.hpp"
#include "microslip/railway/patch_surface.hpp"

namespace microslip {

/// Where a patch is and how far the undeformed bodies overlap: the contact lies within.
struct PatchOutline {
  PatchFrame frame;
  double x_low = 0, x_high = 0; ///< from the frame's origin [m]
  double s_low = 0, s_high = 0; ///< [m]
  double wheel_s = 0;           ///< of the wheel's profile at the origin [m]
  double turn = 0;              ///< by how much the rail's surface turns from end to end [rad]
};

/// The frame is that of the region's weighted centre: x, y and the inclination of the rail's surface are means along
/// the locus with the weight c^2.5 dy, c the overlap, which is the integral of its square along the track: so patches
/// move smoothly with the wheel. The placement is that of the wheel in its height.
PatchOutline find_outline(const WheelPlacement<double>& placement, const Profile& rail, const Profile& wheel,
                          const ContactRegion& region);

} // namespace microslip
