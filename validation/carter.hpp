#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `carter`: steady rolling of cylinders against Carter's closed form, by the kernel of line contact, along
/// +x and -x, and on the grid of CONTACT's example.
bool run_carter(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
