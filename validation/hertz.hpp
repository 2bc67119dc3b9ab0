#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `hertz`: load and peak pressure with the approach given, approach with the load given, against the closed
/// form, and the order of convergence; the products that it takes.
bool run_hertz(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
