#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/progress.hpp"

#include <functional>

namespace microslip {

/// Transient rolling in `steps` of them: `solve` finds the next one, with a progress function that counts within it.
/// `progress` ends it after the last whole step, with status not_converged; where there is none yet it throws Stopped.
/// The result is the last step's, with all in its history.
ContactSolution roll(int steps, const Progress& progress,
                     const std::function<ContactSolution(const Progress& within)>& solve);

/// Solves a step of a sequence; in transient rolling `steps` of them, from zero tractions on, all under the same
/// conditions, as roll() does.
ContactSolution solve_steps(ContactSequence& sequence, ContactStep step, int steps, const Progress& progress);

} // namespace microslip
