#pragma once

#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>

namespace microslip::libcontact {

/// The input file of all cases that flag WRTINP asks for, begun by the first one. Any thread may add.
class CaseFile {
public:
  /// Names the file of the cases from now on.
  void set_path(const std::filesystem::path& path);
  /// Throws Refusal if the file cannot be written.
  void add(const std::string& text);
  /// Ends the file, if there is one.
  void close();

private:
  std::mutex mutex_;
  std::filesystem::path path_;
  std::ofstream file_;
};

} // namespace microslip::libcontact
