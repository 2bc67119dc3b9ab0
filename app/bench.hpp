#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// Adds `microslip bench`, which prints what a contact costs on this machine.
void add_bench_command(Command& program);

} // namespace microslip::app
