#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// Adds `microslip convert`, which writes the cases of an input file of the program CONTACT as case files and sets
/// `exit_code` to 1 unless all of them can be.
void add_convert_command(Command& program, int& exit_code);

} // namespace microslip::app
