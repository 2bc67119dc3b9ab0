#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `viscoelastic-cylinders`. Viscoelastic cylinders (Wang and Knothe 1993): CONTACT's table, and the limits
/// of slow and quick loads.
bool run_viscoelastic_cylinders(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
