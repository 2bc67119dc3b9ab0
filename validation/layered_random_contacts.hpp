#pragma once

#include "microslip/progress.hpp"
#include "validation/report.hpp"

namespace microslip::validation {

/// Adds to a report how many of 2000 random contacts of bodies with layers the solver at the front solves, balls and
/// rollers, and how many it refuses with the reason. Throws Stopped if `progress` returns false.
void report_random_contacts(Report& report, const Progress& progress);

} // namespace microslip::validation
