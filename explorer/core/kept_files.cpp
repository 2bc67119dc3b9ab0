#include "explorer/core/kept_files.hpp"

#include "io/nearest_word.hpp"
#include "io/output_file.hpp"
#include "microslip/error.hpp"

#include <system_error>

namespace microslip::explorer {

std::filesystem::path KeptFiles::path(const std::string& name) const {
  const bool is_plain = !name.empty() && name.front() != '.' && name.find_first_of("/\\:") == std::string::npos;
  if (!is_plain) throw Error("file " + io::printable(name) + ": must be a name without a folder");
  return folder_ / name;
}

bool KeptFiles::has(const std::string& name) const {
  std::error_code ignored;
  return std::filesystem::exists(path(name), ignored);
}

bool KeptFiles::put(const std::string& name, const std::string& contents) {
  const auto file = path(name);
  const auto kept = contents_.find(name);
  if (kept != contents_.end() && kept->second == contents) return false;
  io::OutputFile out(file);
  out.write(contents);
  out.commit();
  contents_[name] = contents;
  return true;
}

} // namespace microslip::explorer
