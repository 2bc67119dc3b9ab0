#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// Forces that the creep-force table gives patches between wheel and rail, at given creepages and spin, beside the
/// exact theory on the same patches; beside them FASTSIM2, the equivalent ellipse and the exact theory on another
/// shape, the simple double-elliptical contact.
bool run_creep_table_patches(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
