#pragma once

#include <string>

namespace microslip::app {

/// Command line of this program, as a shell would take it: for results that can be traced.
std::string command_line();

} // namespace microslip::app
