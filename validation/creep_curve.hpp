#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `creep-curve`: longitudinal forces of a locomotive's wheel (Polach 2005) beside CONTACT's on the same
/// grid, and their limit.
bool run_creep_curve(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
