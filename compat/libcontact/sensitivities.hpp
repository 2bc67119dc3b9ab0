#pragma once

#include "compat/contact/case_solver.hpp"

#include <array>

namespace microslip::libcontact {

using contact_program::Case;

/// d(FN, FX/(FSTAT FN), FY/(FSTAT FN), MZ)/d(approach, xi, eta, phi) in CONTACT's units: [output][input]; 0 where it is
/// not to be had.
using Sensitivities = std::array<std::array<double, 4>, 4>;

/// Which are wanted, and with which step.
struct SensitivityChoice {
  int of = 0;                  ///< S2: up to 1 none, 2 of the normal problem, 3 of both
  double relative_step = 1e-4; ///< EPSSENS
};

/// Of a contact that has been solved, by central differences: the case is solved again with one input moved to either
/// side, by the relative step of itself or of what makes the contact slide, whichever is more. Cost two solutions for
/// S2 = 2, eight for 3. `solver` is the one that has solved the case; it is used where tractions depend on the ones
/// before, and solves the case itself once more at the end.
Sensitivities find_sensitivities(const Case& c, const contact_program::Outcome& outcome,
                                 const SensitivityChoice& choice, contact_program::CaseSolver& solver);

} // namespace microslip::libcontact
