#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `spence`. A sphere pressed on a rigid plane with friction (Spence 1975): step by step, extrapolated.
bool run_spence(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
