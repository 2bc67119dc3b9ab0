#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `exact-test-set`: all 3,220 cases by exact theory on two grids, from no tractions and from FASTSIM2's:
/// failures, the distribution of Newton steps and products, and time.
bool run_exact_test_set(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
