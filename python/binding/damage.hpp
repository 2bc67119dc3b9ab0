#pragma once

#include "binding/value.hpp"
#include "microslip/damage/surface_strength.hpp"

namespace microslip::python {

template <>
inline constexpr auto fields<WearMap> = std::tuple{Field{"slow", &WearMap::slow},
                                                   Field{"medium", &WearMap::medium},
                                                   Field{"fast", &WearMap::fast},
                                                   Field{"seizure", &WearMap::seizure},
                                                   Field{"medium_from", &WearMap::medium_from},
                                                   Field{"medium_to", &WearMap::medium_to},
                                                   Field{"seizure_above", &WearMap::seizure_above}};
template <>
inline constexpr auto fields<SurfaceStrength> =
    std::tuple{Field{"hardness", &SurfaceStrength::hardness},
               Field{"shear_yield_strength", &SurfaceStrength::shear_yield_strength},
               Field{"wear_map", &SurfaceStrength::wear_map}};

} // namespace microslip::python
