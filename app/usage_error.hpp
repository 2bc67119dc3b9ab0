#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
} // namespace CLI

namespace microslip::app {

/// Error of the command line, with the nearest known word for an unknown command or option.
std::string usage_error(const CLI::App& program, const CLI::ParseError& error);

} // namespace microslip::app
