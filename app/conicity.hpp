#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// Adds `microslip conicity`, which computes rolling radius difference and equivalent conicity of wheels on rails.
void add_conicity_command(Command& program);

} // namespace microslip::app
