#pragma once

#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/vec2.hpp"

#include <span>

namespace microslip {

/// dq: the distance rolled in a step [m], as given or the elements' length; negative along -x.
double signed_step(const TangentialInput& input, const ElementGrid& grid);

/// Its parts along x and y; they differ from (step, 0) with a heading only.
Vec2 way_of(const TangentialInput& input, double step);

/// Slip without tractions: that of the creepages, at the elements' centres and `spin_offset` of the step [m] ahead of
/// them, and the extra slip. Along -x the step is negative.
void find_rigid_slip(const ElementGrid& grid, const TangentialInput& input, const Creepage& creepage, double step,
                     std::span<double> cx, std::span<double> cy);

/// Fills in what follows from a solution and from the bound, the displacements and the creepage in `out`: tractions,
/// slip, states, forces, energy, power (E22). Totals that are not finite give Status::invalid_input.
void find_totals(const ElementGrid& grid, const TangentialInput& input, FrictionSolution solution,
                 TangentialSolution& out);

} // namespace microslip
