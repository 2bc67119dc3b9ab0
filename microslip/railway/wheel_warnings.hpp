#pragma once

#include "microslip/contact/warnings.hpp"
#include "microslip/railway/problem/wheel_rail_types.hpp"

namespace microslip {

/// Turn [rad] of the rail's surface across a flat patch from which on distances along it differ by 3 % from those in
/// its plane: cos = 1/1.03.
inline constexpr double largest_flat_turn = 0.2419;

/// Warnings of all results of a wheel on a rail: of the material, and of profiles that look like those of the other
/// body. Cost O(points).
Warnings warnings_of(const WheelRailBodies& bodies);

/// The wheel's y [m] where the flank has passed its steepest part towards the flange's tip and leans by 45 degrees:
/// what stands there or behind it has derailed. Empty without a flange.
std::optional<double> flange_nose(const Profile& wheel);

/// Warnings of a result that its patches, forces and dimensions tell; the others are found where what they need is
/// known. Cost some nanoseconds.
Warnings warnings_of(const WheelRailBodies& bodies, const WheelRailSolution& solution,
                     const std::optional<double>& nose);

} // namespace microslip
