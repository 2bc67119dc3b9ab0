#pragma once

#include "microslip/rolling/solver.hpp"
#include "validation/study.hpp"

#include <span>
#include <vector>

namespace microslip::validation {

/// A contact solved by exact theory, and what that took.
struct ExactCase {
  ContactForces forces;
  double residual = 0;
  int newton_steps = 0;
  long products = 0;
};

/// Start of the solver.
enum class Start {
  fastsim2,     ///< from FASTSIM2's tractions, as Solver does
  no_tractions, ///< from nothing
};

/// Method for the contacts.
struct ExactMethod {
  int n; ///< elements across the ellipse in each direction
  Discretisation discretisation = Discretisation::classical;
  Start start = Start::fastsim2; ///< second order: this one only
};

/// Solves contacts to a residual of 1e-6, on options.threads threads. Contacts of the same ellipse should follow each
/// other. Empty if options.progress asks to stop.
std::vector<ExactCase> solve_exactly(std::span<const EllipticContact> contacts, const ExactMethod& method,
                                     const StudyOptions& options);

} // namespace microslip::validation
