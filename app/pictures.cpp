#include "app/pictures.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string python() {
  const char* chosen = std::getenv("MICROSLIP_PYTHON");
  return chosen != nullptr && *chosen != '\0' ? chosen : MICROSLIP_PYTHON;
}

/// The folder that holds the Python package, beside the one of this program.
fs::path package_folder() {
  std::error_code error;
  const auto program = fs::read_symlink("/proc/self/exe", error);
  return program.parent_path().parent_path() / "share/microslip/python";
}

/// This program's environment, with the package's folder first where Python looks.
std::vector<std::string> environment_with_package() {
  const std::string key = "PYTHONPATH=";
  auto path = key + package_folder().string();
  std::vector<std::string> variables = {"PYTHONDONTWRITEBYTECODE=1"};
  for (auto** variable = environ; *variable != nullptr; ++variable) {
    const std::string text = *variable;
    if (text.starts_with(key))
      path.append(":").append(text, key.size());
    else
      variables.push_back(text);
  }
  variables.push_back(path);
  return variables;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (auto& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

std::string contents(std::FILE* file) {
  std::rewind(file);
  std::string text;
  std::array<char, 4096> buffer{};
  while (const auto count = std::fread(buffer.data(), 1, buffer.size(), file)) text.append(buffer.data(), count);
  return text;
}

/// Runs microslip.plot with its output and errors in files. Returns its exit code, or the negative error number if it
/// cannot be started.
int run(const std::vector<std::string>& plot_arguments, std::FILE* output, std::FILE* errors) {
  std::vector<std::string> arguments = {python(), "-m", "microslip.plot"};
  arguments.insert(arguments.end(), plot_arguments.begin(), plot_arguments.end());
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(output), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(errors), STDERR_FILENO);
  auto environment = environment_with_package();
  pid_t child = 0;
  const int error = posix_spawnp(&child, arguments[0].c_str(), &actions, nullptr, pointers(arguments).data(),
                                 pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return -error;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

/// Why Python could not draw, in one line.
std::string problem(int code, const std::vector<std::string>& messages) {
  const auto who = "pictures are missing: " + python() + " ";
  const std::string remedy = "; install python3-h5py, python3-matplotlib and python3-numpy, or use --no-pictures";
  if (code < 0) return who + "cannot be started: " + std::generic_category().message(-code) + remedy;
  if (messages.empty()) return who + "ended with code " + std::to_string(code);
  const bool lacks_module = messages.back().find("No module named") != std::string::npos;
  return who + "says \"" + messages.back() + "\"" + (lacks_module ? remedy : "");
}

} // namespace

Pictures draw_pictures(const std::vector<std::string>& arguments) {
  const File output(std::tmpfile()), errors(std::tmpfile());
  if (!output || !errors) return {.problem = "pictures are missing: temporary files cannot be made"};
  const auto code = run(arguments, output.get(), errors.get());
  Pictures pictures = {.files = lines_of(contents(output.get()))};
  if (code != 0) pictures.problem = problem(code, lines_of(contents(errors.get())));
  return pictures;
}

Pictures draw_pictures(const fs::path& result_file, const fs::path& folder) {
  return draw_pictures({result_file.string(), "-o", folder.string()});
}

} // namespace microslip
