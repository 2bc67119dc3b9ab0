#pragma once

#include "validation/study.hpp"

namespace microslip::validation {

/// The study `subsurface`: displacements and stresses inside the bodies. CONTACT's example of a loaded square; Hertz's
/// contacts against closed forms, how near to the surface that holds; cost; von Mises' stress in wheel and rail.
bool run_subsurface(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
