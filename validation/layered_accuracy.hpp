#pragma once

#include "microslip/progress.hpp"
#include "validation/report.hpp"

namespace microslip::validation {

/// How forces of random layered contacts converge: on one grid, as means over grids that lie differently, and
/// extrapolated, with the estimate of the error beside the true one, which is that to far finer elements. Throws
/// Stopped if `progress` returns false.
void report_layered_accuracy(Report& report, const Progress& progress);

} // namespace microslip::validation
