#pragma once

#include "compat/contact/case.hpp"

#include <istream>
#include <string>

namespace microslip::contact_program {

/// Reads the file by which CONTACT's interface to Simpack sets a wheel and its rail: the line MODULE with 11, then the
/// records of module 1 but for positions, velocities, deviations and points inside, which the vehicle code gives. What
/// it keeps stays as it is in `before`, a case of module 1, and so do C1, P, T, N, F, S, H and I whatever the file has.
/// Throws Error as InputReader does; profiles are looked for in the folder of `name`.
Case read_pair(std::istream& stream, const std::string& name, const Case& before);

} // namespace microslip::contact_program
