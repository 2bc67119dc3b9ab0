#pragma once

#include "validation/report.hpp"

namespace microslip::validation {

/// Adds what steady rolling with layers costs to a report: products beside those of half-spaces on the same elements,
/// and the time of sweeps over load and creepage.
void report_layered_cost(Report& report);

} // namespace microslip::validation
