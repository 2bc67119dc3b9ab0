#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `wheel-rail`: a wheel on a rail in sweeps through contact jumps, in 100,000 random states, its derivatives
/// beside differences, and the energy that it loses, on profiles of the examples and, where they are there, measured
/// and worn ones beside CONTACT's cases.
bool run_wheel_rail(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
