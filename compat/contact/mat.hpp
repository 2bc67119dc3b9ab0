#pragma once

#include "compat/contact/outcome.hpp"

#include <string>

namespace microslip::contact_program {

/// The fields of a solved case in the layout of CONTACT's .mat files, which are ASCII: pairs of a comment and a line of
/// numbers for the grid, the material and the friction, then a row for each element: number from 1, state (0 exterior,
/// 1 adhesion, 2 slip), H (undeformed distance less approach), MU, PN, PX, PY, UN, UX, UY and the slip, relative or for
/// a shift as a distance. mm and N/mm2, six digits. Digit A = 1 writes the elements in contact, others all.
std::string mat_text(const Case& c, const Outcome& outcome);

} // namespace microslip::contact_program
