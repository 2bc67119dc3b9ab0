#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `model-problem`: the paper's three cases of (F20). Transition points beside the printed ones, errors and
/// orders of all strategies; writes model_problem.h5.
bool run_model_problem(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
