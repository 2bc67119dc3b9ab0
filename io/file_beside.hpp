#pragma once

#include <filesystem>
#include <string>

namespace microslip::io {

/// The path of a file that another one names, from that one's folder on. Backslashes are separators on every system, as
/// in files that were written on Windows.
std::filesystem::path file_beside(const std::filesystem::path& folder, std::string name);

} // namespace microslip::io
