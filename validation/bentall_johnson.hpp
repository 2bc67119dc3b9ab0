#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `bentall-johnson`. Cylinders of different materials in steady rolling: the examples of Bentall and Johnson
/// as CONTACT's guide has them.
bool run_bentall_johnson(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
