#pragma once

#include "microslip/damage/wear.hpp"

#include <optional>

namespace microslip {

/// What surfaces bear before they wear or yield. What needs a number that is not given is not given either.
struct SurfaceStrength {
  std::optional<double> hardness;             ///< H [Pa] of the surface that wears
  std::optional<double> shear_yield_strength; ///< k [Pa] of the work-hardened surface
  WearMap wear_map = {};
};

} // namespace microslip
