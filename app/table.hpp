#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// `microslip table`: inspects, draws and makes creep-force tables.
void add_table_command(Command& program, int& exit_code);

} // namespace microslip::app
