#pragma once

#include "validation/report.hpp"
#include "validation/study.hpp"

namespace microslip::validation {

/// Forces, peak pressures and conicity of S1002 on 60E1, and of worn ones, that are measured with errors. Returns false
/// if progress asked to stop.
bool report_measured_profiles(Report& report, const StudyOptions& options);

} // namespace microslip::validation
