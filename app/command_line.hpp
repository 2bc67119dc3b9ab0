#pragma once

#include <string>

namespace microslip::app {

/// How this program was called, as a shell would take it: for results that can be traced.
std::string command_line();

} // namespace microslip::app
