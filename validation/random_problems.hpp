#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `random-problems`: 20,000 seeded random contacts of all kinds (steady and transient rolling, shifts,
/// forces given, bodies of different materials, viscoelastic ones, layers that yield, friction that falls or heats),
/// each of which has a solution: with creepages given because the traction bound is a continuous function of tractions
/// within it (Brouwer), with forces given because they are those of a problem solved before. Counts those that are not
/// solved and names the first of each kind with its number, which seeds it.
bool run_random_problems(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
