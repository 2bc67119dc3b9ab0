#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// Body of `main`: adds the commands and runs the one that is asked for, which sets `exit_code`.
/// Returns the program's exit code; failures are reported on standard error.
int run_program(int count, char** arguments, void (*add_commands)(Command& program, int& exit_code));

} // namespace microslip::app
