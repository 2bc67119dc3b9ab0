#pragma once

#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/normal/normal_problem.hpp"
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

/// By which slip is a velocity: V [m/s], or 1 for a shift.
double speed_of(const TangentialInput& input);

/// Fills in what follows from a solution and from the elements, the bound, the displacements and the creepage in `out`:
/// tractions, slip, states, totals with the power (E22), report. Totals that are not finite give Status::invalid_input.
void finish(const TangentialInput& input, FrictionSolution solution, ContactSolution& out);

/// Adds pressure, gap and approach, those of `normal` times `load` for a normal problem that was solved for 1 N.
void add_normal(ContactSolution& solution, const NormalSolution& normal, double load = 1);

/// Gives steady rolling the frictional power on the slip at the elements' centres, (E23a), which converges better than
/// that on the slip of the equations.
void find_centred_power(const TangentialInput& input, ContactSolution& solution);

} // namespace microslip
