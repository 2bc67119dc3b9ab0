#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// Rolling radius difference and equivalent conicity beside closed forms and the tables of EN 15302.
bool run_conicity(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
