#pragma once

#include <CLI/CLI.hpp>

namespace microslip {

/// Adds `microslip init`.
void add_init_command(CLI::App& program);

} // namespace microslip
