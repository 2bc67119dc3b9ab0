#pragma once

#include <CLI/CLI.hpp>

namespace microslip {

/// `microslip table`: inspects, draws and makes creep-force tables.
void add_table_command(CLI::App& program, int& exit_code);

} // namespace microslip
