#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// Runs CONTACT's input files of module 3 on the same elements, and puts every quantity that CONTACT printed beside
/// ours. What is not supported is named and not judged. Needs the folders of published results; without them it says
/// so.
bool run_contact_cases(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
