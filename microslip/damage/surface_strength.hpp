#pragma once

#include "microslip/damage/wear.hpp"

#include <optional>

namespace microslip {

/// Resistance of surfaces to wear and yield. Results that need a number which is not given are empty.
struct SurfaceStrength {
  std::optional<double> hardness;             ///< H [Pa] of the surface that wears
  std::optional<double> shear_yield_strength; ///< k [Pa] of the work-hardened surface
  WearMap wear_map = {};
};

} // namespace microslip
