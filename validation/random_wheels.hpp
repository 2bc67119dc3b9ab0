#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `random-wheels`: 100,000 random states of wheels on new, hollow, worn and measured profiles at all levels
/// of theory, up to flange climbing and derailment: what their statuses are, whether these and the numbers agree,
/// whether an unsolved state has a height that would bear its load, and how long the slowest take.
bool run_random_wheels(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
