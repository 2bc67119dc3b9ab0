#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `cattaneo-to-carter`: a sphere is shifted and then rolls two diameters under the same force (Kalker 1990,
/// section 5.2.2.5), beside CONTACT's figures, and its end beside steady rolling solved directly.
bool run_cattaneo_to_carter(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
