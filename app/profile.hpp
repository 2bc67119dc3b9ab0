#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// Adds `microslip profile`, which reads, checks, draws and converts the profile of a wheel or rail.
void add_profile_command(Command& program);

} // namespace microslip::app
