#pragma once

#include "microslip/table/creep_force_table.hpp"

#include <optional>

namespace microslip::python {

/// The creep-force table that microslip has, for one Poisson's ratio or for all.
CreepForceTable own_creep_table(std::optional<double> poisson_ratio = {});

} // namespace microslip::python
