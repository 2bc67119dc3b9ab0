#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// Adds `microslip run`, which runs the cases of an input file of the program CONTACT and sets `exit_code` to 1 unless
/// all of them are solved.
void add_run_command(Command& program, int& exit_code);

} // namespace microslip::app
