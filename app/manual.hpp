#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// Adds `microslip manual`, which prints the man page of the program, made from its commands and options.
void add_manual_command(Command& program);

} // namespace microslip::app
