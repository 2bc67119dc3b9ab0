#include "io/file_beside.hpp"

#include <algorithm>

namespace microslip::io {

std::filesystem::path file_beside(const std::filesystem::path& folder, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return folder / name;
}

} // namespace microslip::io
