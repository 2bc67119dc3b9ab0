#pragma once

#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/rolling/solver.hpp"

namespace microslip {

/// A step's solution, found by this sequence, with its derivatives; none where it is not converged or where nothing
/// touches. Throws as ContactSequence::differentiate.
ExactDerivatives with_derivatives(ContactSequence& sequence, ContactStep step, ContactSolution solution,
                                  const Progress& progress);

} // namespace microslip
