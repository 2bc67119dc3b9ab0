#pragma once

#include "io/json.hpp"

#include <filesystem>

namespace microslip::app {

/// The document that `microslip bench --json` wrote to a file. Throws Error that names the file if it has no lines with
/// names and positive times.
io::Json read_bench(const std::filesystem::path& path);

/// Adds to each line of a document what the same one took in an older one [s], `before`, and its time over that,
/// `new_over_old`; lines that the older one lacks get neither.
void add_comparison(io::Json& document, const io::Json& older);

/// Prints times then and now and their ratios, the median of these, and which lines only one of both has.
void print_comparison(const io::Json& compared, const io::Json& older);

} // namespace microslip::app
