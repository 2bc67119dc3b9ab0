#pragma once

#include "compat/contact/outcome.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/simplified/grid_fastsim.hpp"

#include <vector>

namespace microslip::contact_program {

/// The springs of a grid's elements: their displacements [m] in place of tractions.
using Springs = ContactSequence::State;

/// State that a case of FASTSIM leaves to the next one: the springs that it began with, and those of its end.
struct CarriedSprings {
  Springs before = {}, after = {};
};

/// Solves a case of the simplified theory (Digits::is_simplified) as CONTACT does: the normal problem as `steps` solves
/// it, or the pressure given; then FASTSIM on the rows of the potential contact (GridFastsim), or FaStrip, with the
/// friction of the creepage's velocity V sqrt(xi^2 + eta^2). Prescribed forces are found to the step's tolerance,
/// relative to what friction bears; a force beyond that gives Status::no_solution, one that no creepage was found for
/// Status::not_converged. The displacements are those of the springs; elastic energies are those of the normal problem
/// alone, 0 for a pressure of B = 2, 3, 4, and with that of the springs for B = 5, 6. `step` is that of the case,
/// `carried` is that of the case before and then of this one. Throws Error for parameters out of range.
ContactStepSolution solve_simplified(const Case& c, const ContactStep& step, ContactSequence& steps,
                                     CarriedSprings& carried);

/// The flexibilities of a solved case and the factor of their slope, at its creepages.
PrintedSprings printed_springs(const Case& c, const ContactStep& step, const ContactStepSolution& solution);

} // namespace microslip::contact_program
