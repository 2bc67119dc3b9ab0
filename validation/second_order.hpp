#pragma once

#include "validation/study.hpp"

#include <iosfwd>

namespace microslip::validation {

/// The study `second-order`: the order of the second-order discretisation on Carter's problem, on the test of the
/// refinement paper and in other rolling; its errors and those of extrapolated forces on the partial-slip ones of the
/// 112 cases, against its limit and against the published one; and how honest the estimate of the error is.
bool run_second_order(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
