#pragma once

#include "compat/contact/input.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"

#include <vector>

namespace microslip::contact_program {

/// Whether the tractions of a case are those of the simplified theory: M = 2, 3 FASTSIM, M = 5 to 7 FaStrip.
bool is_simplified(const Case& c);

/// What a case of FASTSIM leaves to the next one: the displacements of the springs [m] on a grid; empty: none.
struct SpringState {
  ElementGrid grid = {};
  std::vector<double> x = {}, y = {};
};

/// Solves such a case as CONTACT does: the normal problem as `steps` solves it, or the pressure given; then FASTSIM
/// from element to element of the potential contact's rows, each step of the element's length, with the friction of the
/// creepage's velocity V sqrt(xi^2 + eta^2); then strip theory for FaStrip. In transient rolling each element goes on
/// by itself from the springs that its particles had before, P = 0, or from none. Forces given are found to the step's
/// tolerance, relative to what friction bears; a force beyond that gives Status::no_solution, one that no creepage was
/// found for Status::not_converged. The displacements are those of the springs; elastic energies are those of the
/// normal problem alone, 0 for a pressure that is given. `step` is the case's own, `springs` are those of the case
/// before and then its own. Throws Error for parameters out of range.
ContactStepSolution solve_simplified(const Case& c, const ContactStep& step, ContactSequence& steps,
                                     SpringState& springs);

} // namespace microslip::contact_program
