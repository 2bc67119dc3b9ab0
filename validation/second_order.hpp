#pragma once

#include "validation/exact_cases.hpp"
#include "validation/study.hpp"

#include <iosfwd>
#include <span>
#include <vector>

namespace microslip::validation {

/// Solves contacts at second order on n x n elements across the ellipse to a residual of 1e-6, on options.threads
/// threads. Contacts of the same ellipse should follow each other. Empty if options.progress asks to stop.
std::vector<ExactCase> solve_at_second_order(std::span<const EllipticContact> contacts, int n,
                                             const StudyOptions& options);

/// The study `second-order`: the order of steady rolling's second-order discretisation on Carter's problem and on the
/// test of the refinement paper; its errors and those of extrapolated forces on the partial-slip ones of the 112 cases,
/// against its own limit and against the published one.
bool run_second_order(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
