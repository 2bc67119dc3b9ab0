#pragma once

#include "microslip/progress.hpp"
#include "validation/report.hpp"
#include "validation/study.hpp"

namespace microslip::validation {

/// Random ellipses of all combinations of motion, bodies, layer, friction, heat and forces given, on grids of up to
/// 24 x 24 elements, whether they have a solution or not: reports how they end, and that each does so in time, with a
/// status that agrees with its numbers, and with forces that friction bears. False if the progress ended them.
bool report_combinations(Report& report, const StudyOptions& options, const Progress& progress);

} // namespace microslip::validation
