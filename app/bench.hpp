#pragma once

#include <CLI/CLI.hpp>

namespace microslip::app {

/// Adds `microslip bench`, which prints what a contact costs on this machine.
void add_bench_command(CLI::App& program);

} // namespace microslip::app
