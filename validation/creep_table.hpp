#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The creep-force table that microslip has beside the exact theory, FASTSIM2 and Polach's formula, on random cases
/// and on the 3,220 cases; smoothness; times.
bool run_creep_table(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
