#pragma once

#include <filesystem>
#include <fstream>

namespace microslip::io {

/// Opens a file to be read as bytes. Throws Error with the path and the reason: it is a folder, or the system's.
std::ifstream open_input(const std::filesystem::path& path);

} // namespace microslip::io
