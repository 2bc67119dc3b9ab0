#pragma once

#include <CLI/CLI.hpp>

namespace microslip::app {

/// Adds `microslip batch`, which sets `exit_code` to 1 if a contact could not be solved.
void add_batch_command(CLI::App& program, int& exit_code);

} // namespace microslip::app
