#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// Adds `microslip solve`, which sets `exit_code` to 1 if the result is not one.
void add_solve_command(Command& program, int& exit_code);

} // namespace microslip::app
