#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `kalker-coefficients`: creepage coefficients by the series of linear theory and by the solver without
/// slip, beside Kalker's table, and the computed table of the library, which it writes anew.
bool run_kalker_coefficients(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
