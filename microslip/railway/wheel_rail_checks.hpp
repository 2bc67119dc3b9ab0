#pragma once

#include "microslip/railway/problem/wheel_rail_types.hpp"

namespace microslip {

/// Throws Error for bodies and methods out of range or that do not go together.
void require_valid(const WheelRailBodies& bodies, const WheelRailMethod& method);

} // namespace microslip
