#include "app/python_module.hpp"

#include "app/child_process.hpp"
#include "io/program_files.hpp"
#include "microslip/error.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
#include <utility>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

constexpr char between_paths = fs::path::preferred_separator == '/' ? ':' : ';';

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// Environment of this program, with the package's folder first where Python looks.
std::vector<std::string> environment_with_package() {
  const std::string key = "PYTHONPATH=";
  auto path = key + io::python_folder().string();
  std::vector<std::string> variables = {"PYTHONDONTWRITEBYTECODE=1"};
  for (auto& text : environment_variables())
    if (text.starts_with(key))
      path.append(1, between_paths).append(text, key.size());
    else
      variables.push_back(std::move(text));
  variables.push_back(path);
  return variables;
}

std::string contents(std::FILE* file) {
  std::rewind(file);
  std::string text;
  std::array<char, 4096> buffer{};
  while (const auto count = std::fread(buffer.data(), 1, buffer.size(), file)) text.append(buffer.data(), count);
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

} // namespace

std::string python() {
  const char* chosen = std::getenv("MICROSLIP_PYTHON");
  return chosen != nullptr && *chosen != '\0' ? chosen : MICROSLIP_PYTHON;
}

std::string PythonRun::said_of_input(const std::string& module) const {
  const std::string name = module + ": ";
  const bool is_said = code == 2 && !messages.empty() && messages.back().starts_with(name);
  return is_said ? messages.back().substr(name.size()) : "";
}

PythonRun run_python_module(const std::string& module, const std::vector<std::string>& arguments) {
  const File output(std::tmpfile()), errors(std::tmpfile());
  if (!output || !errors) throw Error("temporary files cannot be made");
  std::vector<std::string> all = {python(), "-m", module};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const int code = run_child(std::move(all), environment_with_package(), output.get(), errors.get());
  return {code, lines_of(contents(output.get())), lines_of(contents(errors.get()))};
}

} // namespace microslip::app
