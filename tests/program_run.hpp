#pragma once

#include "paths.hpp"
#include "tests/temporary_folder.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <sys/wait.h>

namespace microslip {

inline std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

inline void save(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// What a run of the program leaves.
struct Outcome {
  int exit_code;
  std::string output, errors;
};

/// Runs the program in a folder; `before` is what the shell does first. Standard output goes to the file `output`, or
/// else is returned.
inline Outcome run_program(const TemporaryFolder& folder, const std::string& arguments,
                           const std::string& before = "true", std::filesystem::path output = {}) {
  const TemporaryFolder streams;
  const auto errors = streams / "errors";
  const bool is_returned = output.empty();
  if (is_returned) output = streams / "output";
  std::string command = "cd '" + folder.path().string() + "' && " + before + " && exec '" + MICROSLIP_PROGRAM + "' ";
  command += arguments + " >'" + output.string() + "' 2>'" + errors.string() + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, is_returned ? contents(output) : "", contents(errors)};
}

} // namespace microslip
