#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// Adds `microslip batch`, which sets `exit_code` to 1 if a contact could not be solved.
void add_batch_command(Command& program, int& exit_code);

} // namespace microslip::app
