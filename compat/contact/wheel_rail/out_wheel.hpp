#pragma once

#include "compat/contact/outcome.hpp"

#include <string>

namespace microslip::contact_program {

/// Text of CONTACT's output file about a wheel on a rail, as far as digit O asks for it. With O = 4 it has the moments,
/// but not the profiles.
std::string out_wheel(const Case& c, const Outcome& outcome);

} // namespace microslip::contact_program
