#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/material.hpp"
#include "microslip/exact/normal/normal_problem.hpp"

#include <span>

namespace microslip {

/// NORM, Kalker's active set algorithm for the normal problem (Kalker 1990, section 4.3): the equations e = 0 in an
/// assumed contact are solved by conjugate gradients; elements with a negative pressure leave it until there are none,
/// then elements that overlap enter. The plain reference beside NormalProblem: same input, same result and residual,
/// without transforms, O(N^2) operations for a product. `iterations` counts the assumed contacts. Throws Error as
/// NormalProblem does.
NormalSolution solve_norm(const CombinedMaterial& material, const ElementGrid& grid, std::span<const double> gap,
                          const NormalLoad& load, double tolerance = 1e-8);

} // namespace microslip
