#pragma once

#include "binding/value.hpp"
#include "microslip/damage/surface_strength.hpp"

namespace microslip::python {

template <>
inline constexpr auto fields<WearMap> = members<&WearMap::slow, &WearMap::medium, &WearMap::fast, &WearMap::seizure,
                                                &WearMap::medium_from, &WearMap::medium_to, &WearMap::seizure_above>;
template <>
inline constexpr auto fields<SurfaceStrength> =
    members<&SurfaceStrength::hardness, &SurfaceStrength::shear_yield_strength, &SurfaceStrength::wear_map>;

} // namespace microslip::python
