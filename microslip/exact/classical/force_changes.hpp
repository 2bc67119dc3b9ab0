#pragma once

#include <array>

namespace microslip {

/// Changes of forces and moment on body 1 per unit of what changes.
struct ForceChange {
  double fx = 0, fy = 0, mz = 0; ///< [N], [N], [N m]
};

/// Derivatives of the forces of a step in steady rolling.
struct ForceChanges {
  std::array<ForceChange, 3> by_creepage; ///< xi [-], eta [-], phi [1/m]
  ForceChange by_load;                    ///< the normal force [N] or the approach [m], whichever is given
  long products = 0;                      ///< that these took
};

} // namespace microslip
