#pragma once

#include "tests/support/files.hpp"
#include "tests/support/temporary_folder.hpp"

#include "paths.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace microslip {

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

/// What a child process does to become the program in a folder, without input and output.
[[noreturn]] inline void become_program(const TemporaryFolder& folder, std::vector<std::string> words) {
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  if (chdir(folder.path().c_str()) != 0) _exit(127);
  std::vector<char*> arguments = {const_cast<char*>("microslip")};
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(MICROSLIP_PROGRAM, arguments.data());
  _exit(127);
}

/// The exit code of a process that has ended, as a shell has it.
inline int exit_code(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

} // namespace microslip
