#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `refinement`: the test of the refinement paper (Vollebregt 2009, sections 3 to 5), its figures 1 to 8 and
/// the times of its Table 1.
bool run_refinement(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
