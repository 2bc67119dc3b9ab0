#pragma once

#include "compat/contact/case_solver.hpp"
#include "compat/contact/outcome.hpp"

namespace microslip::contact_program {

// A left wheel is solved as the right one that is its mirror image in the plane of the track's centre: y changes its
// sign, and with it FY, moments about x and z, angles about these axes, CETA and CPHI; rows of elements are reversed.
// Nothing between asks which wheel it is.

/// The same wheel, or of a left one the mirror image.
Case right_hand(Case c);
/// Result for a left wheel, from that for the right one. The profiles' own y stays as of the right one.
void mirror_back(WheelOutcome& wheel);
/// A patch as the other wheel has it.
Outcome mirrored(Outcome patch);
/// The same of what a patch has gone on from.
void mirror_back(CarriedTractions& carried);

} // namespace microslip::contact_program
