#pragma once

#include "microslip/railway/geometry/wheel_placement.hpp"

#include <array>
#include <cstddef>

namespace microslip {

/// The first numbers of a state, from the lateral position to the yaw velocity: changes of them bring a wheel into any
/// position and motion against its rail that matter. Its rotation about its axis and its travel along the rail do not.
inline constexpr std::size_t basic_motions = 10;

/// Motion of a left wheel against its rail by each number of a state: as these changes of the basic numbers, with this
/// rotation of rail and wheel together about the wheel's centre. A force F has the derivative sum_k combination[k]
/// dF/dq_k + turn x F (W8), and ahead times the one by the distance along the track; a moment about the wheel's centre
/// likewise.
struct RelativeMotion {
  std::array<double, basic_motions> combination{};
  double ahead = 0;  ///< by how much it moves the wheel along the track besides; that matters where surfaces vary [m]
  Vec3<double> turn; ///< [rad] for each unit of the number
};

/// Returns it for all numbers of a state, in the order of WheelState::numbers(), by dual numbers. That rail and wheel
/// turn together with a small angular velocity is left out: it changes rolling speeds by some 1e-4 of the change of
/// curvature. Cost some 20,000 operations, no memory.
std::array<RelativeMotion, state_numbers> relative_motions(const NominalPlacement& nominal,
                                                           const WheelState<double>& state);

} // namespace microslip
