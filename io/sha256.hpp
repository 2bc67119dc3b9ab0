#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace microslip::io {

/// SHA-256 (FIPS 180-4) in 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

/// That of a file's contents. Throws Error if it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

} // namespace microslip::io
