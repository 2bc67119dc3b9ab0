#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace microslip::explorer {

/// Files that cases name, in a separate folder; in a browser it is in memory.
class KeptFiles {
public:
  /// The folder has to be there; empty: the current one.
  explicit KeptFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Where a file of this name is. Throws Error for a name with a folder or without letters.
  std::filesystem::path path(const std::string& name) const;
  /// Returns whether there is a file of this name. Throws Error as above.
  bool has(const std::string& name) const;
  /// Writes a file unless it has just these contents already. Whether it was written. Throws Error as above.
  bool put(const std::string& name, const std::string& contents);

private:
  std::filesystem::path folder_;
  std::map<std::string, std::string> contents_;
};

} // namespace microslip::explorer
