#pragma once

#include "tests/support/temporary_folder.hpp"

#include <cstdio>
#include <string>

namespace microslip {

/// Text that a command prints, run in a temporary folder, where its log goes; empty if it fails.
inline std::string command_output(const std::string& command) {
  const TemporaryFolder folder;
  std::FILE* const pipe = popen(("cd '" + folder.path().string() + "' && " + command).c_str(), "r");
  std::string text;
  for (int letter; pipe && (letter = std::fgetc(pipe)) != EOF;) text += static_cast<char>(letter);
  return pipe && pclose(pipe) == 0 ? text : "";
}

} // namespace microslip
