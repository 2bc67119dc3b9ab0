#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `fastsim2-table2`: discretisation errors of FASTSIM and FASTSIM2 on the 3,220 cases beside Table 2 of the
/// FASTSIM2 paper, and the order of convergence. Writes fastsim2_table2.h5, from which figures 4 and 5 are drawn.
bool run_fastsim2_table2(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
