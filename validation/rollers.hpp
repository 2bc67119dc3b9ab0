#pragma once

#include "validation/report.hpp"

namespace microslip::validation {

/// Figures of rollers with covers in line contact: thin layers, speed ratios, rolling resistance.
void report_rollers(Report& report);

} // namespace microslip::validation
