#pragma once

#include "compat/contact/case.hpp"
#include "compat/contact/wheel_rail/gap_regions.hpp"
#include "compat/contact/wheel_rail/placement.hpp"

#include <memory>
#include <vector>

namespace microslip::contact_program {

struct Outcome;

/// A force [N], and a moment [N m] about the origin of its axes.
struct Wrench {
  Vec3<double> force, moment;
};

/// Position of a patch [m].
struct PatchLocation {
  Vec3<double> track, rail, wheel; ///< XCP YCP ZCP in the axes of the track, the rail's and the wheel's profile
  double angle = 0;                ///< DELTCP in the track's axes [rad]
  double angle_on_rail = 0, angle_on_wheel = 0;
};

/// A contact patch of a wheel.
struct WheelPatch {
  PatchLocation location;
  Case contact;                      ///< it as a case of module 3
  std::shared_ptr<Outcome> solution; ///< and what became of it
  Wrench track, wheelset;            ///< its part of the wheel's
  Frame<double> reference, grid;     ///< PatchFrame's
  double s_rail = 0, s_wheel = 0;    ///< of the reference along the profiles, the wheel's from the field side [m]
  std::vector<int> previous = {};    ///< numbers, from 1, of the patches of the case before that it goes on from
};

/// Counts of the solution.
struct WheelEffort {
  int geometry = 0, normal = 0, tangential = 0; ///< analyses of the geometry, and solved problems of either kind
};

/// A wheel on its rail: forces and moments act on the rail.
struct WheelOutcome {
  double z = 0;                    ///< Z_WS [m]
  double vpitch = 0;               ///< VPITCH_WS [rad/s]
  double dy_rail = 0, dz_rail = 0; ///< deflection of the rail, with F = 3 [m]
  Wrench track;                    ///< in the track's axes, moment about the rail's marker
  Wrench wheelset;                 ///< in the wheelset's axes, moment about the wheel's marker
  std::vector<WheelPatch> patches;
  std::vector<NearMiss> near_misses; ///< within G_MISS, in the track's axes
  WheelEffort effort;
  Placement placement;
};

} // namespace microslip::contact_program
