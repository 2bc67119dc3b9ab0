#pragma once

#include "compat/contact/case_solver.hpp"

namespace microslip::contact_program {

/// Selection of sensitivities, and their steps.
struct SensitivityChoice {
  int of = 0;                  ///< S2: up to 1 none, 2 of the normal problem, 3 of both
  double relative_step = 1e-4; ///< EPSSENS
};

/// Sensitivities of a contact that has been solved, by central differences: the case is solved again with one input
/// moved to either side, by the relative step of itself or of what makes the contact slide, whichever is more. Cost two
/// solutions for S2 = 2, eight for 3. `start` is what the case has gone on from, CaseSolver::started_from.
Sensitivities find_sensitivities(const Case& c, const Outcome& outcome, const SensitivityChoice& choice,
                                 const CarriedTractions& start);

/// Those that CONTACT's output files have: of a force along x that is given (F = 1, 2) by the creepage along x, and of
/// one along y (F = 2) by that along y, the other creepages staying. Cost two solutions for each; none without forces
/// given.
Sensitivities printed_sensitivities(const Case& c, const Outcome& outcome, const CarriedTractions& start);

} // namespace microslip::contact_program
