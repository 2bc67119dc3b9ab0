#pragma once

#include "microslip/railway/problem/wheel_rail_types.hpp"

namespace microslip {

/// Throws Error for bodies and methods out of range or that cannot be combined.
void require_valid(const WheelRailBodies& bodies, const WheelRailMethod& method);

} // namespace microslip
