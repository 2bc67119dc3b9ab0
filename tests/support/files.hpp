#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace microslip {

/// All that is in a file, byte by byte; nothing if there is none.
inline std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

inline void save(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

} // namespace microslip
