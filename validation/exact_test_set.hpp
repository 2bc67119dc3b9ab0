#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `exact-test-set`: all 3,220 cases by exact theory on three grids, at second order and classically, that
/// from FASTSIM2's tractions and from none: failures, the distribution of Newton steps and products, and time.
bool run_exact_test_set(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
