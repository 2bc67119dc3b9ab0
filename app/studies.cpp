#include "app/studies.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/pictures.hpp"
#include "app/progress_bar.hpp"
#include "app/validation_report.hpp"
#include "io/nearest_word.hpp"
#include "io/output_file.hpp"
#include "io/program_files.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "validation/study.hpp"
#include "validation/study_inputs.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

using validation::Figure;
using validation::Study;

void list_studies() {
  for (const Study& study : validation::studies()) fmt::print("{:<18} {}\n", study.name, study.summary);
}

const Study& study_of(const std::string& name) {
  if (const Study* study = validation::find_study(name)) return *study;
  std::vector<std::string_view> known;
  for (const Study& study : validation::studies()) known.push_back(study.name);
  const std::string nearest = io::suggestion(name, known);
  throw Error("there is no study " + io::printable(name) +
              (nearest.empty() ? "; validate --list names them" : nearest));
}

/// The named studies, each once, or all if none is named.
std::vector<const Study*> chosen(const std::vector<std::string>& names) {
  std::vector<const Study*> chosen;
  chosen.reserve(std::max(names.size(), validation::studies().size()));
  for (const std::string& name : names)
    if (const Study* study = &study_of(name); std::ranges::find(chosen, study) == chosen.end()) chosen.push_back(study);
  if (names.empty())
    for (const Study& study : validation::studies()) chosen.push_back(&study);
  return chosen;
}

/// Draws the pictures of a study's result file, which has its name in letters of file names of this project. Returns
/// their names.
std::vector<std::string> draw(const Study& study, const std::filesystem::path& folder) {
  std::string name(study.name);
  std::replace(name.begin(), name.end(), '-', '_');
  const std::filesystem::path results = folder / (name + ".h5");
  if (!std::filesystem::exists(results)) return {}; // a study of numbers only
  return draw_pictures(results, folder);
}

/// Returns whether all figures are as stated; they are printed to `out` and added to `figures`.
bool run(const Study& study, const ValidateArguments& arguments, std::ostream& out, std::vector<Figure>& figures) {
  ProgressBar bar{std::string(study.name)};
  const auto progress = [&bar](double fraction) {
    bar.update(fraction);
    return !InterruptGuard::interrupted();
  };
  const bool as_stated = study.run({.output = arguments.output,
                                    .threads = arguments.threads,
                                    .cases = arguments.cases,
                                    .thorough = arguments.thorough,
                                    .progress = progress,
                                    .figures = &figures},
                                   out);
  out.flush();
  InterruptGuard::throw_if_interrupted();
  return as_stated;
}

io::Json to_json(const Figure& figure) {
  io::Json result = {
      {"section", figure.section}, {"name", figure.name}, {"computed", figure.computed}, {"expected", figure.expected}};
  if (figure.met)
    result["met"] = *figure.met;
  else
    result["remark"] = figure.remark;
  if (figure.is_known) result["known_limit"] = figure.remark;
  return result;
}

bool run_for_people(const Study& study, const ValidateArguments& arguments) {
  fmt::print("{}: {}\n", study.name, study.summary);
  std::fflush(stdout);
  std::vector<Figure> figures;
  const bool as_stated = run(study, arguments, std::cout, figures);
  if (!arguments.no_pictures)
    for (const auto& picture : draw(study, arguments.output)) fmt::print("  written: {}\n", picture);
  fmt::print("\n{}: {}\n", study.name, outcome(as_stated, figures));
  return as_stated;
}

/// Prints it as well, at its end.
StudyRecord run_for_report(const Study& study, const ValidateArguments& arguments) {
  StudyRecord record{.study = &study};
  std::ostringstream text;
  const auto begin = std::chrono::steady_clock::now();
  record.as_stated = run(study, arguments, text, record.figures);
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  record.text = text.str();
  if (!arguments.no_pictures) record.pictures = draw(study, arguments.output);
  fmt::print("{}: {}\n{}\n{}: {}\n", study.name, study.summary, record.text, study.name,
             outcome(record.as_stated, record.figures));
  return record;
}

/// This one, and the program that went on as it.
std::vector<std::filesystem::path> programs() {
  std::vector<std::filesystem::path> files = {io::program_file()};
  std::filesystem::path front = files.front();
  front.replace_filename("microslip" + front.extension().string());
  if (front != files.front() && std::filesystem::exists(front)) files.push_back(front);
  return files;
}

int report(const std::vector<const Study*>& studies, ValidateArguments arguments) {
  const std::filesystem::path folder = *arguments.report;
  if (folder.empty()) throw Error("--report: needs the name of a folder");
  io::create_folder(folder);
  io::require_writable_file(folder / validation_page);
  arguments.output = folder;
  const ReportHead head{.purpose = arguments.purpose,
                        .begin = std::time(nullptr),
                        .inputs = digested(validation::study_inputs(arguments.cases)),
                        .programs = digested(programs())};
  std::vector<StudyRecord> records;
  for (const Study* study : studies) records.push_back(run_for_report(*study, arguments));
  const std::vector<std::string> written = write_validation_report(folder, head, records);
  InterruptGuard::throw_if_interrupted();
  for (const auto& file : written) fmt::print("written: {}\n", file);
  return std::ranges::all_of(records, &StudyRecord::as_stated) ? ExitCode::done : ExitCode::not_met;
}

/// Adds the study's figures to the document.
bool run_for_programs(const Study& study, const ValidateArguments& arguments, io::Json& document) {
  std::vector<Figure> figures;
  std::ostream silent(nullptr);
  const bool as_stated = run(study, arguments, silent, figures);
  io::Json result = {{"name", study.name},
                     {"summary", study.summary},
                     {"as_stated", as_stated},
                     {"outcome", outcome(as_stated, figures)},
                     {"figures", io::Json::array()}};
  for (const Figure& figure : figures) result["figures"].push_back(to_json(figure));
  result["pictures"] = arguments.no_pictures ? std::vector<std::string>() : draw(study, arguments.output);
  document["studies"].push_back(result);
  return as_stated;
}

} // namespace

int run_studies(const ValidateArguments& arguments) {
  require_count("--threads", arguments.threads, 1, most_threads);
  const std::vector<const Study*> studies = chosen(arguments.names);
  if (!arguments.purpose.empty() && !arguments.report) throw Error("--purpose: is for --report");
  if (!arguments.cases.empty() && std::ranges::none_of(studies, [](const Study* s) { return s->name == "contact"; }))
    throw Error("--cases: is for the study contact");
  if (!arguments.cases.empty() && !std::filesystem::is_directory(arguments.cases))
    throw Error("--cases: " + arguments.cases.string() + " is no folder");
  if (arguments.list) {
    list_studies();
    return ExitCode::done;
  }
  if (arguments.report) return report(studies, arguments);
  auto document = json_document("validate");
  bool all_as_stated = true;
  for (const Study* study : studies)
    all_as_stated =
        (arguments.json ? run_for_programs(*study, arguments, document) : run_for_people(*study, arguments)) &&
        all_as_stated;
  if (arguments.json) {
    document["as_stated"] = all_as_stated;
    print_json(document);
  }
  return all_as_stated ? ExitCode::done : ExitCode::not_met;
}

} // namespace microslip::app
