#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `temperature`: a locomotive's wheel that slides and one that has braked (Ertz & Knothe 2002), beside what
/// CONTACT prints for the same grid, and the closed form of Hertz's heat.
bool run_temperature(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
