#pragma once

#include "app/tables.hpp"
#include "campaign/sweep_file.hpp"

#include <filesystem>

namespace microslip::app {

/// Solves the cases of a sweep on all threads, with its checkpoint beside `output`, and calls `use` with its result
/// file, which is not kept. Throws Error as Sweep, Interrupted.
campaign::SweepCount run_sweep(const std::filesystem::path& spec, const std::filesystem::path& output,
                               const UseOfFile& use);

} // namespace microslip::app
