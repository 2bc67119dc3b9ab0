#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/normal/normal_problem.hpp"
#include "microslip/progress.hpp"

#include <vector>

namespace microslip {

/// Joint solution of a normal and a tangential problem on one grid. Pressure, gap and approach are those of
/// `normal` times `load`, for a normal problem that was solved for 1 N; `motion` is what the tangential problem was
/// given. The frictional power of steady rolling is that on the slip at the elements' centres, (E23a), which converges
/// better than that on the slip of the equations.
ContactSolution contact_solution(const ElementGrid& grid, TangentialSolution tangential, const NormalSolution& normal,
                                 double load, const TangentialInput& motion);

/// Entry of the history for a step of transient rolling.
SolutionStep solution_step(const ContactSolution& step);

/// Returns whether transient rolling was ended before its last step, and nothing else was wrong.
bool is_cut_short(const std::vector<SolutionStep>& history, int steps, Status status);

/// Progress of the step that follows those of `history`; it counts only as a whole.
Progress within_step(int steps, const std::vector<SolutionStep>& history, const Progress& progress);

/// Solves a step of a sequence; in transient rolling `steps` of them, from zero tractions on, all under the same
/// conditions. `progress` ends transient rolling after the last whole step, with status not_converged; where there is
/// none yet it throws Stopped.
ContactSolution solve_steps(ContactSequence& sequence, ContactStep step, int steps, const Progress& progress);

} // namespace microslip
