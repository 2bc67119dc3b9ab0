#pragma once

#include "microslip/exact/classical/contact_sequence.hpp"

namespace microslip {

/// What a step from no tractions leads to when the bodies roll on.
inline ContactStepSolution rolled(ContactStep step, int steps) {
  ContactSequence sequence;
  step.motion.motion = ContactMotion::transient;
  ContactStepSolution solution;
  for (int n = 0; n < steps; ++n) {
    solution = sequence.solve(step);
    step.start = StepStart::previous;
  }
  return solution;
}

} // namespace microslip
