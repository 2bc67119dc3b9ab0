#pragma once

#include <CLI/CLI.hpp>

namespace microslip::app {

/// `microslip table`: inspects, draws and makes creep-force tables.
void add_table_command(CLI::App& program, int& exit_code);

} // namespace microslip::app
