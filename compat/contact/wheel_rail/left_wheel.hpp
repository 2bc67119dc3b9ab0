#pragma once

#include "compat/contact/case_solver.hpp"
#include "compat/contact/outcome.hpp"

namespace microslip::contact_program {

/// Result for a left wheel, from that for the right one that is its mirror image: y changes its sign, and
/// with it FY, moments about x and z, the angle, CETA and CPHI; rows of elements are reversed.
void mirror_back(WheelOutcome& wheel);
/// The same of what a patch has gone on from.
void mirror_back(CarriedTractions& carried);

} // namespace microslip::contact_program
