#pragma once

#include <CLI/CLI.hpp>

namespace microslip::app {

/// Adds `microslip validate`, which sets `exit_code` to 1 if a published figure is not met.
void add_validate_command(CLI::App& program, int& exit_code);

} // namespace microslip::app
