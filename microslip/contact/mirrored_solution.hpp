#pragma once

#include "microslip/contact/contact_solution.hpp"

namespace microslip {

/// The same contact seen in a mirror whose plane is x, z: turns one of a left wheel into one of a right wheel and back.
/// y, lateral components, spin and the moment change their sign; rows are reversed, so that y ascends again.
void mirror(ContactSolution& solution);

} // namespace microslip
