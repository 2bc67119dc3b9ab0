#pragma once

#include "validation/report.hpp"
#include "validation/study.hpp"

namespace microslip::validation {

/// Fits of the measured curve of the Eurosprinter, where it is there, and of 100 synthetic creep curves each of which
/// say nothing of a parameter: whether it is named. Thoroughly, in ten minutes more, how often the 95 % intervals hold
/// the truth, 300 curves of each of three models. Returns false if progress asked to stop.
bool report_creep_curve_fits(Report& report, const StudyOptions& options);

} // namespace microslip::validation
