#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `fastsim2-table1`: forces of FASTSIM2 on 640 x 640 cells against those of exact theory for the 3,220
/// cases, beside Table 1 of the FASTSIM2 paper. Writes fastsim2_table1.h5, from which figure 3 is drawn.
bool run_fastsim2_table1(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
