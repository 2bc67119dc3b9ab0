#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `edge-constants`: beta(omega) of the leading element that is fitted to the edge of contact, from the
/// half-line in closed form up to quadratures; beside it the limit of finite systems, and edge_inset() of the library.
/// Prints the coefficients of edge_inset().
bool run_edge_constants(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
