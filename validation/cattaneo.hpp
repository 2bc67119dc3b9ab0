#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `cattaneo`: a sphere pressed on a plane and shifted, against the closed form of Cattaneo and Mindlin and
/// CONTACT's figures, and how far that closed form is from the exact solution.
bool run_cattaneo(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
