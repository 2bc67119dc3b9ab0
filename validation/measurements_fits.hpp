#pragma once

#include "validation/report.hpp"

namespace microslip::validation {

/// Fits of the measured curve of the Eurosprinter, where it is there, and of synthetic creep curves: how often the 95 %
/// intervals hold the truth, 300 curves of each of three models, and whether a parameter without information is named,
/// 100 curves.
void report_creep_curve_fits(Report& report);

} // namespace microslip::validation
