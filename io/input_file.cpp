#include "io/input_file.hpp"

#include "microslip/error.hpp"

#include <cerrno>
#include <system_error>

namespace microslip::io {

std::ifstream open_input(const std::filesystem::path& path) {
  const auto fail = [&](const std::string& reason) { throw Error(path.string() + ": cannot be read: " + reason); };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) fail("it is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(std::generic_category().message(errno));
  return file;
}

} // namespace microslip::io
