#pragma once

#include "microslip/description/input.hpp"

namespace microslip::description {

/// Keys of SurfaceStrength.
Input hardness_input();
Input shear_yield_strength_input();

} // namespace microslip::description
