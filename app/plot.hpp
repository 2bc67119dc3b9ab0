#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// Adds `microslip plot`, which draws the pictures of a result file.
void add_plot_command(Command& program, int& exit_code);

} // namespace microslip::app
