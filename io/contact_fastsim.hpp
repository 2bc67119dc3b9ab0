#pragma once

#include "io/contact_input.hpp"
#include "microslip/exact/contact_sequence.hpp"

namespace microslip {

/// Whether the tractions of a case are those of the simplified theory: M = 2, 3 FASTSIM, M = 5 to 7 FaStrip.
bool is_simplified(const ContactCase& c);

/// Solves such a case as CONTACT does: the normal problem as `steps` solves it, or the pressure given; then FASTSIM
/// from element to element of the potential contact's rows, each step of the element's length, with the friction of the
/// creepage's velocity V sqrt(xi^2 + eta^2); then strip theory for FaStrip. The displacements are those of the springs;
/// elastic energies are those of the normal problem alone, 0 for a pressure that is given. `step` is the case's own.
/// Throws Error for parameters out of range.
ContactStepSolution solve_simplified(const ContactCase& c, const ContactStep& step, ContactSequence& steps);

} // namespace microslip
