#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// microslip explore: opens the explorer's page in a browser.
void add_explore_command(Command& program);

} // namespace microslip::app
