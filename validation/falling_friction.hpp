#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `falling-friction`. Friction that falls with the slip: a cylinder with two branches of solutions, and
/// creep curves of a locomotive's wheel.
bool run_falling_friction(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
