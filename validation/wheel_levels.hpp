#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `wheel-levels`: forces of a wheel by the fast theories and on coarse elements beside the exact theory on
/// fine ones, in random states of new and worn profiles; and the largest jump of each, found by bisection.
bool run_wheel_levels(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
