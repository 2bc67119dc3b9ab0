#pragma once

#include "io/json.hpp"
#include "microslip/contact/quantities.hpp"

#include <span>
#include <string_view>

namespace microslip::explorer {

/// Puts fields of a solution by their names into an object, and their units into another one.
void add_fields(const ContactSolution& solution, std::span<const std::string_view> names, io::Json& to,
                io::Json& units);

/// The states of the elements: 0 outside, 1 in adhesion, 2 in slip.
io::Json states_of(const ContactSolution& solution);

} // namespace microslip::explorer
