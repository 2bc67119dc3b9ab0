#pragma once

#include "microslip/description/input.hpp"

#include <string>

namespace microslip::app {

/// The keys of a kind of case as text, section by section: unit, bounds, default and what each is.
std::string input_list(const description::InputTable& table);

} // namespace microslip::app
