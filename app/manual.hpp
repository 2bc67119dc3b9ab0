#pragma once

#include <CLI/CLI.hpp>

namespace microslip::app {

/// Adds `microslip manual`, which prints the man page of the program, made from its commands and options.
void add_manual_command(CLI::App& program);

} // namespace microslip::app
