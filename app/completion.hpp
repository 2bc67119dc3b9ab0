#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// Adds `microslip completion`, which prints a script that completes the program's commands and options in a shell.
void add_completion_command(Command& program);

} // namespace microslip::app
