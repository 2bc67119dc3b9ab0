#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// `microslip sweep SPEC.toml -o OUT.h5`: many cases, on threads and ranks, with a checkpoint.
void add_sweep_command(Command& program, int& exit_code);

} // namespace microslip::app
