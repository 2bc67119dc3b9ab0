#pragma once

#include "microslip/exact/normal/normal_problem.hpp"

#include <span>

namespace microslip {

/// Fills in what follows from pressure, displacement and approach: gap, normal force, elastic energy, peak, elements in
/// contact and the borders that they reach. `undeformed` is h [m]. Totals that are not finite give
/// Status::invalid_input.
void find_totals(const ElementGrid& grid, std::span<const double> undeformed, NormalSolution& solution);

} // namespace microslip
