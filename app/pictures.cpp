#include "app/pictures.hpp"

#include "app/python_module.hpp"
#include "io/program_files.hpp"
#include "microslip/error.hpp"

#include <cstdio>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* plot_module = "microslip.plot";

/// Why Python could not draw a file, in one line.
std::string problem(const std::string& file, const PythonRun& run) {
  const auto& [code, output, messages] = run;
  constexpr int first_signal = 128;
  if (code > first_signal) // HDF5 crashes over some damages
    return file + ": cannot be drawn: " + python() + " crashed over it (signal " + std::to_string(code - first_signal) +
           "); the file is perhaps cut short or damaged: copy it again, or write it again by the command that made it";
  if (auto text = run.said_of_input(plot_module); !text.empty()) return text;
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
  PythonRun run;
  try {
    run = run_python_module(plot_module, arguments);
  } catch (const Error& error) {
    return {.problem = std::string("pictures are missing: ") + error.what()};
  }
  Pictures pictures = {.files = std::move(run.output)};
  if (run.code != 0) pictures.problem = problem(arguments.front(), run);
  return pictures;
}

std::vector<std::string> draw_pictures(const fs::path& result_file, const fs::path& folder) {
  const Pictures pictures = draw_pictures({result_file.string(), "-o", folder.string()});
  if (!pictures.problem.empty()) fmt::print(stderr, "microslip: warning: {}\n", pictures.problem);
  return pictures.files;
}

} // namespace microslip::app
