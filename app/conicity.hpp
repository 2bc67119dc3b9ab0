#pragma once

#include <CLI/CLI.hpp>

namespace microslip::app {

/// Adds `microslip conicity`, which computes rolling radius difference and equivalent conicity of wheels on rails.
void add_conicity_command(CLI::App& program);

} // namespace microslip::app
