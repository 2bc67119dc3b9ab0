#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `manchester`: the Manchester benchmark's wheelset (S1002 on UIC 60, Shackleton & Iwnicki 2008) in the 42
/// states of its part, left and right, at both levels beside the forces that CONTACT printed. Needs CONTACT's
/// input files, profiles and stored results; without them it says so.
bool run_manchester(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
