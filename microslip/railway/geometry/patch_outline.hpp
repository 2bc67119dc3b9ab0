#pragma once

#include "microslip/railway/geometry/contact_search.hpp"
#include "microslip/railway/geometry/patch_surface.hpp"

#include <span>

namespace microslip {

/// Extent of a patch and overlap of the undeformed bodies: the contact lies within.
struct PatchOutline {
  PatchFrame frame;
  double x_low = 0, x_high = 0;    ///< from the frame's origin [m]
  double s_low = 0, s_high = 0;    ///< of its rows (PatchRow::s) [m]
  double wheel_s = 0;              ///< of the wheel's profile at the origin [m]
  double turn = 0;                 ///< by how much the rail's surface turns from end to end [rad]
  ContactRegion::End inner, outer; ///< of the region
  double weight = 0;               ///< of the means that its frame is: the integral of c^2.5 dy, c the overlap [m^3.5]
};

/// The frame is that of the region's weighted centre: x, y and the inclination of the rail's surface are means along
/// the locus with the weight c^2.5 dy, c the overlap, which is the integral of its square along the track: so patches
/// move smoothly with the wheel. The placement is that of the wheel in its height. With the equivalent rail whose
/// profiles these are x is where the true surfaces are nearest, and the patch reaches as far as they overlap. `surface`
/// is that of the rows, along which s is measured.
PatchOutline find_outline(const WheelPlacement<double>& placement, const Profile& rail, const Profile& wheel,
                          const ContactRegion& region, PatchShape surface, const EquivalentRail* equivalent = nullptr);

/// The greatest distance [m] of wheel and rail between two patches, the second one further to the left, at some points
/// of the wheel's locus: by so much the wheel must be lowered for their regions to become one.
double clearance_between(const WheelPlacement<double>& placement, const Profile& rail, const Profile& wheel,
                         const PatchOutline& low, const PatchOutline& high);

/// Several outlines as one: its frame is the mean of theirs by their weights times `shares`, so that it is that of a
/// single region where regions touch. It covers those whose share is 1.
PatchOutline joined(const WheelPlacement<double>& placement, const Profile& rail,
                    std::span<const PatchOutline> outlines, std::span<const double> shares, PatchShape surface);

} // namespace microslip
