#pragma once

#include "io/profile_file.hpp"

#include <filesystem>

namespace microslip::app {

/// Reads and checks a file of slices with the profiles it names, and prints what it holds, as a table or as JSON.
void show_slices(const std::filesystem::path& file, const io::ProfileFileOptions& options, bool json);

} // namespace microslip::app
