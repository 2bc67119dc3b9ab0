#include "app/validate.hpp"

#include "app/interrupt.hpp"
#include "app/pictures.hpp"
#include "app/progress_bar.hpp"
#include "io/nearest_word.hpp"
#include "microslip/error.hpp"
#include "validation/study.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

namespace microslip {
namespace {

using validation::Study;

struct ValidateArguments {
  std::vector<std::string> names;
  bool list = false;
  std::filesystem::path output = "results";
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool no_pictures = false;
};

void list_studies() {
  for (const Study& study : validation::studies()) fmt::print("{:<18} {}\n", study.name, study.summary);
}

const Study& study_of(const std::string& name) {
  if (const Study* study = validation::find_study(name)) return *study;
  std::vector<std::string_view> known;
  for (const Study& study : validation::studies()) known.push_back(study.name);
  const std::string nearest = suggestion(name, known);
  throw Error("there is no study " + printable(name) + (nearest.empty() ? "; validate --list names them" : nearest));
}

/// The named studies, or all if none is named.
std::vector<const Study*> chosen(const std::vector<std::string>& names) {
  std::vector<const Study*> chosen;
  chosen.reserve(std::max(names.size(), validation::studies().size()));
  for (const std::string& name : names) chosen.push_back(&study_of(name));
  if (names.empty())
    for (const Study& study : validation::studies()) chosen.push_back(&study);
  return chosen;
}

/// A study's result file has the study's name, in letters of file names of this project.
void draw(const Study& study, const std::filesystem::path& folder) {
  std::string name(study.name);
  std::replace(name.begin(), name.end(), '-', '_');
  const std::filesystem::path results = folder / (name + ".h5");
  if (!std::filesystem::exists(results)) return; // a study of numbers only
  const Pictures pictures = draw_pictures(results, folder);
  for (const std::string& picture : pictures.files) fmt::print("  written: {}\n", picture);
  if (!pictures.problem.empty()) fmt::print(stderr, "microslip: warning: {}\n", pictures.problem);
}

bool run(const Study& study, const ValidateArguments& arguments) {
  fmt::print("{}: {}\n", study.name, study.summary);
  std::fflush(stdout);
  bool met = false;
  {
    const InterruptGuard guard;
    ProgressBar bar{std::string(study.name)};
    const auto progress = [&bar](double fraction) {
      bar.update(fraction);
      return !InterruptGuard::interrupted();
    };
    met = study.run({.output = arguments.output, .threads = arguments.threads, .progress = progress}, std::cout);
    std::cout.flush();
    InterruptGuard::throw_if_interrupted();
  }
  if (!arguments.no_pictures) draw(study, arguments.output);
  fmt::print("\n{}: {}\n", study.name, met ? "all figures are met" : "NOT all figures are met");
  return met;
}

int validate(const ValidateArguments& arguments) {
  require_count("--threads", arguments.threads, 1, 1024);
  const std::vector<const Study*> studies = chosen(arguments.names);
  if (arguments.list) {
    list_studies();
    return 0;
  }
  bool all_met = true;
  for (const Study* study : studies) all_met = run(*study, arguments) && all_met;
  return all_met ? 0 : 1;
}

} // namespace

void add_validate_command(CLI::App& program, int& exit_code) {
  auto* command = program.add_subcommand("validate", "Print computed figures beside published ones");
  const auto arguments = std::make_shared<ValidateArguments>();
  command->add_option("NAME", arguments->names, "studies to run; default: all");
  command->add_flag("--list", arguments->list, "print the names of the studies and what they show");
  command->add_option("-o,--output", arguments->output,
                      "folder for the result files and the pictures; default: results");
  command->add_option("--threads", arguments->threads, "threads, 1 to 1024; default: one for each processor");
  command->add_flag("--no-pictures", arguments->no_pictures, "write the result files only");
  command->footer("Exit code: 0 all figures are met, 1 some are not, 2 bad input.\n\n"
                  "Example:\n  microslip validate model-problem -o results");
  command->callback([arguments, &exit_code] { exit_code = validate(*arguments); });
}

} // namespace microslip
