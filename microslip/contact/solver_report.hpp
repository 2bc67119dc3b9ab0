#pragma once

#include "microslip/status.hpp"

#include <optional>
#include <string>

namespace microslip {

/// Status and cost of a calculation.
struct SolverReport {
  Status status = Status::ok;
  std::string reason = {}; ///< why the status is not ok; empty if it is
  double residual = 0;     ///< relative, of the equations of friction
  int newton_steps = 0;    ///< of all problems that were solved
  long products = 0;       ///< with the matrix of influence coefficients
  /// Errors of the forces, in mu Fn, and of the moment, in mu Fn sqrt(a b), where an accuracy was asked for.
  std::optional<double> estimated_error = {};
};

/// Fills in the reason of a status that is not ok and has none yet.
void add_reason(SolverReport& report);

} // namespace microslip
