#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `exact-112`: forces on 31 x 31 elements beside CONTACT's on the same grid for 112 of the 3,220 cases, and
/// extrapolated beside CONTACT's extrapolated ones. Reads exact_theory_112.csv in the folder of published results that
/// the build was configured with; says so where it is not there.
bool run_exact_112(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
