#pragma once

#include "validation/study.hpp"

#include <iosfwd>

namespace microslip::validation {

/// The study `second-order`: the order of steady rolling's second-order discretisation on Carter's problem and on the
/// test of the refinement paper; its errors and those of extrapolated forces on the partial-slip ones of the 112 cases,
/// against its own limit and against the published one; and how honest the estimate of the error is.
bool run_second_order(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
