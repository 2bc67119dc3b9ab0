#include "app/pictures.hpp"

#include "app/child_process.hpp"
#include "io/program_files.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

constexpr char between_paths = fs::path::preferred_separator == '/' ? ':' : ';';

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string python() {
  const char* chosen = std::getenv("MICROSLIP_PYTHON");
  return chosen != nullptr && *chosen != '\0' ? chosen : MICROSLIP_PYTHON;
}

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

/// Runs microslip.plot, as run_child does.
int run(const std::vector<std::string>& plot_arguments, std::FILE* output, std::FILE* errors) {
  std::vector<std::string> arguments = {python(), "-m", "microslip.plot"};
  arguments.insert(arguments.end(), plot_arguments.begin(), plot_arguments.end());
  return run_child(std::move(arguments), environment_with_package(), output, errors);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

/// Message of microslip.plot on a file or an option, without its name; else nothing.
std::string said_of_input(int code, const std::vector<std::string>& messages) {
  const std::string name = "microslip.plot: ";
  const bool is_said = code == 2 && !messages.empty() && messages.back().starts_with(name);
  return is_said ? messages.back().substr(name.size()) : "";
}

/// Why Python could not draw a file, in one line.
std::string problem(const std::string& file, int code, const std::vector<std::string>& messages) {
  constexpr int first_signal = 128;
  if (code > first_signal) // HDF5 crashes over some damages
    return file + ": cannot be drawn: " + python() + " crashed over it (signal " + std::to_string(code - first_signal) +
           "); the file is perhaps cut short or damaged: copy it again, or write it again by the command that made it";
  if (auto text = said_of_input(code, messages); !text.empty()) return text;
  const auto who = "pictures are missing: " + python() + " ";
  const std::string remedy = "; install python3-h5py, python3-matplotlib and python3-numpy, or use --no-pictures";
  if (code < 0) return who + "cannot be started: " + std::generic_category().message(-code) + remedy;
  if (messages.empty()) return who + "ended with code " + std::to_string(code);
  if (messages.back().find("No module named 'microslip") != std::string::npos)
    return "pictures are missing: so is the folder of what draws them, " + io::python_folder().string();
  const bool lacks_module = messages.back().find("No module named") != std::string::npos;
  return who + "says \"" + messages.back() + "\"" + (lacks_module ? remedy : "");
}

} // namespace

Pictures draw_pictures(const std::vector<std::string>& arguments) {
  const File output(std::tmpfile()), errors(std::tmpfile());
  if (!output || !errors) return {.problem = "pictures are missing: temporary files cannot be made"};
  const auto code = run(arguments, output.get(), errors.get());
  Pictures pictures = {.files = lines_of(contents(output.get()))};
  if (code != 0) pictures.problem = problem(arguments.front(), code, lines_of(contents(errors.get())));
  return pictures;
}

std::vector<std::string> draw_pictures(const fs::path& result_file, const fs::path& folder) {
  const Pictures pictures = draw_pictures({result_file.string(), "-o", folder.string()});
  if (!pictures.problem.empty()) fmt::print(stderr, "microslip: warning: {}\n", pictures.problem);
  return pictures.files;
}

} // namespace microslip::app
