#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `solver-growth`: how the cost of ConvexGS grows with the grid on the refinement paper's test, beside its
/// Table 1 and beside FrictionNewton in the same run. Times depend on the machine and are not judged; sweeps, and that
/// both find the same force, are.
bool run_solver_growth(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
