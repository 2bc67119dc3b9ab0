#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `wheel-surfaces`: forces of the exact level on planes, on the true surfaces, as conformal patches and as
/// it chooses by itself, beside those on the true surfaces with 48 elements across each contact, for random states of
/// wheels on new, hollow and worn profiles; what the warning of flat patches says there.
bool run_wheel_surfaces(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
