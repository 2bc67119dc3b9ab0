#pragma once

#include "compat/contact/case.hpp"

#include <string>
#include <vector>

namespace microslip::contact_program {

/// Requests of a case of module 1 that cannot be solved, each by digit and meaning. This is the one list by which it
/// is refused for what it asks of wheel and rail; what it asks of each patch is refused as for module 3 (unsupported).
std::vector<std::string> unsupported_of_wheel(const Case& c);

/// Requests that are left out or done differently.
std::vector<std::string> left_out_of_wheel(const Case& c);

} // namespace microslip::contact_program
