#pragma once

#include <CLI/CLI.hpp>

namespace microslip::app {

/// microslip explore: opens the explorer's page in a browser.
void add_explore_command(CLI::App& program);

} // namespace microslip::app
