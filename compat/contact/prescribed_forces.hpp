#pragma once

#include "compat/contact/outcome.hpp"

#include <string>
#include <vector>

namespace microslip::contact_program {

/// A force that a case prescribes, or that a spring bears, and what was found of it.
struct PrescribedForce {
  std::string name = {};       ///< CONTACT's
  double given = 0, found = 0; ///< [N]
  double tolerance = 0;        ///< [N], >= 0

  double missing() const { return found - given; }
  /// A force that is no number is not reached.
  bool is_reached() const;
};

/// N = 1 of module 1: FZ, within EPS.
PrescribedForce vertical_force(const Case& c, const WheelOutcome& wheel);
/// F = 1 of module 1: FX_WS, within EPS of what friction bears.
PrescribedForce pulling_force(const Case& c, const WheelOutcome& wheel);
/// F = 3: what the rail's springs bear, aside and, with N = 0, below, within EPS.
PrescribedForce side_spring(const Case& c, const WheelOutcome& wheel);
PrescribedForce bottom_spring(const Case& c, const WheelOutcome& wheel);

/// All forces that a case of either module prescribes, as its solution has them. Of module 3, where the pressure is
/// given (B = 2, 3, 4), FN is not among them: its sum over elements is what it is.
std::vector<PrescribedForce> prescribed_forces(const Case& c, const Outcome& outcome);

/// Makes a case whose solution does not bear what it prescribes, with all its patches, `not_converged`, unless they
/// have a worse status already, and notes what is missing: the one function that decides it for both modules.
void check_prescribed_forces(const Case& c, Outcome& outcome);

} // namespace microslip::contact_program
