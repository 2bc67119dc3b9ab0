#pragma once

#include <CLI/CLI.hpp>

namespace microslip::app {

/// Adds `microslip plot`, which draws the pictures of a result file.
void add_plot_command(CLI::App& program, int& exit_code);

} // namespace microslip::app
