#pragma once

#include "validation/report.hpp"
#include "validation/study.hpp"

namespace microslip::validation {

/// Samples and their statistics: Sobol's indices of Ishigami's function and of a creep force, quantiles under a load of
/// 10 % spread. Returns false if progress asked to stop.
bool report_sampling(Report& report, const StudyOptions& options);

} // namespace microslip::validation
