#pragma once

#include "compat/contact/outcome.hpp"

#include <cstddef>
#include <string>

namespace microslip::contact_program {

/// The fields of a solved case as CONTACT's .mat files of format 2410 have them, which its loadcase.m reads: ASCII, all
/// lines with as many numbers (11, and 3 for a layer that yields, 2 for temperatures), missing ones 0. Three lines say
/// where wheel, rail and patch lie, three have grid, material and friction (the first set), each below a comment with
/// names; then a row for each element: number from 1, state (0 exterior, 1 adhesion, 2 slip, 3 plastic), H, MU, PN, PX,
/// PY, UN, UX, UY and the slip, relative or for a shift as a distance. mm and N/mm2, six digits. Digit A = 1 writes the
/// elements in contact, others all. UPLSX, UPLSY of a layer are those of plastic_deformation, or else of its length
/// along the traction.
std::string mat_text(const Case& c, const Outcome& outcome);
/// The same for a patch of a wheel, `patch` from 0.
std::string mat_text(const Case& c, const WheelOutcome& wheel, std::size_t patch);
/// What CONTACT adds to the case's number in the names of such a patch's files: a, b, ....
inline std::string patch_letter(std::size_t patch) {
  return std::string(1, static_cast<char>('a' + patch));
}

} // namespace microslip::contact_program
