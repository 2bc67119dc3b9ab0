#pragma once

#include "microslip/railway/geometry/wheel_state.hpp"
#include "microslip/railway/problem/wheel_rail_types.hpp"

#include <cstdint>
#include <string>

namespace microslip::validation {

/// A state and the vertical force that its wheel bears.
struct LoadedState {
  WheelState<double> state;
  double force = 0; ///< [N]
};

/// State of a wheel forwards or backwards at 20 m/s: y to 20 mm, yaw to 50 mrad, roll to 5 mrad, creepages to 2 %,
/// 1 to 200 kN. The same with every standard library.
LoadedState random_state(std::uint64_t seed);

/// Contradiction between status and numbers of a solution for a vertical force [N], or nothing.
std::string contradiction(const WheelRailSolution& solution, double force);

} // namespace microslip::validation
