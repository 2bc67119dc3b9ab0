#include "app/run.hpp"

#include "app/command_line.hpp"
#include "app/contact_tables.hpp"
#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/progress_bar.hpp"
#include "cases/interior_result.hpp"
#include "compat/contact/mat.hpp"
#include "compat/contact/run.hpp"
#include "compat/contact/run_file.hpp"
#include "io/output_file.hpp"
#include "io/result_json.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;
using contact_program::Case;
using contact_program::InputReader;
using contact_program::Outcome;

struct RunArguments {
  fs::path input, folder = "results";
  bool mat = false, json = false;
};

/// The file is read twice: once to see that all of it is right.
std::ifstream open(const fs::path& path) {
  const auto fail = [&](const std::string& why) { throw Error(path.string() + ": cannot be read: " + why); };
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) fail("it is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(std::generic_category().message(errno));
  if (!fs::is_regular_file(path, ignored)) fail("it is not a regular file");
  return file;
}

/// Number of cases of a file without mistakes.
int count_cases(const fs::path& path) {
  auto file = open(path);
  InputReader reader(file, path.string());
  int count = 0;
  while (const Case* c = reader.next()) {
    count = c->number;
    if (count % 256 == 0) InterruptGuard::throw_if_interrupted();
  }
  if (count == 0) throw Error(path.string() + ": there is no case in it");
  return count;
}

/// The text, unless it is long.
std::string short_text(const fs::path& path) {
  constexpr std::uintmax_t longest = 1 << 20;
  if (fs::file_size(path) > longest) return "";
  auto file = open(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

class Run {
public:
  explicit Run(const RunArguments& arguments)
      : path_(arguments.input), mat_(arguments.mat), json_(arguments.json), count_(count_cases(path_)),
        output_(output_path(arguments)), file_(output_, {.kind = "contact_run",
                                                         .title = path_.stem().string(),
                                                         .command_line = command_line(),
                                                         .case_file = path_.string(),
                                                         .case_text = short_text(path_)}),
        bar_(path_.filename().string()) {}

  /// Returns whether all cases are solved.
  bool run() {
    auto input = open(path_);
    InputReader reader(input, path_.string());
    while (const Case* c = reader.next()) {
      const Outcome outcome = run_.run(*c);
      count(outcome);
      if (shows_both_) bar_.clear();
      if (json_)
        keep(*c, outcome);
      else
        print(*c, outcome);
      file_.add(*c, outcome);
      if (mat_ && outcome.kind == Outcome::Kind::solved) write_texts(*c, outcome);
      InterruptGuard::throw_if_interrupted();
      bar_.update(static_cast<double>(c->number) / count_);
    }
    bar_.clear();
    file_.commit();
    json_ ? print_document() : fmt::print("\n{}\n", output_.string());
    std::fflush(stdout);
    if (!reader.is_complete())
      fmt::print(stderr, "microslip: warning: {}: the file ends without MODULE 0; is it complete?\n", path_.string());
    warn(refused_, "not run");
    warn(unsolved_, "not solved, see their status");
    return refused_ == 0 && unsolved_ == 0;
  }

private:
  static fs::path output_path(const RunArguments& arguments) {
    create_folder(arguments.folder);
    return arguments.folder / (arguments.input.stem().string() + ".h5");
  }

  void count(const Outcome& outcome) {
    if (outcome.kind == Outcome::Kind::refused) ++refused_;
    if (outcome.kind == Outcome::Kind::solved && outcome.solution.status != Status::ok) ++unsolved_;
  }

  void print(const Case& c, const Outcome& outcome) {
    fmt::print("{}Case {} (line {}): ", c.number == 1 ? "" : "\n", c.number, c.line);
    if (outcome.kind == Outcome::Kind::skipped) {
      fmt::print("skipped, {}\n", written(c.digits.solve));
    } else if (outcome.kind == Outcome::Kind::refused) {
      fmt::print("not run\n");
      for (const auto& reason : outcome.reasons) fmt::print("  {}\n", reason);
    } else {
      print_solution(c, outcome);
      for (const auto& note : outcome.notes)
        if (known_notes_.insert(note).second) fmt::print("  note: {}\n", note);
    }
    std::fflush(stdout);
  }

  /// What the result file does not have.
  void keep(const Case& c, const Outcome& outcome) {
    if (outcome.kind == Outcome::Kind::refused)
      refusals_.push_back({{"case", c.number}, {"line", c.line}, {"reasons", outcome.reasons}});
    known_notes_.insert(outcome.notes.begin(), outcome.notes.end());
    keep_extremes(c.number, outcome);
    if (outcome.wheel)
      for (const auto& patch : outcome.wheel->patches) keep_extremes(c.number, *patch.solution);
  }

  void keep_extremes(int number, const Outcome& outcome) {
    int block = 0;
    for (const auto& [points, states] : outcome.interior)
      extremes_.push_back({{"case", number}, {"block", ++block}, {"extremes", extremes_json(points, states)}});
  }

  void print_document() const {
    auto document = result_json(output_);
    document["cases_not_run"] = refusals_;
    document["cases_not_solved"] = unsolved_;
    document["interior_extremes"] = extremes_;
    document["notes"] = known_notes_;
    document["files"] = files_;
    print_json(document);
  }

  void warn(std::size_t cases, const char* what) const {
    if (cases > 0)
      fmt::print(stderr, "microslip: warning: {}: {} of {} cases are {}\n", path_.string(), cases, count_, what);
  }

  /// In CONTACT's own layout.
  void write_texts(const Case& c, const Outcome& outcome) {
    if (!outcome.wheel) {
      write_texts(c, outcome, "");
      return;
    }
    char letter = 'a'; // as CONTACT names them, if there are several
    for (const auto& patch : outcome.wheel->patches) {
      const bool alone = outcome.wheel->patches.size() == 1;
      write_texts(patch.contact, *patch.solution, alone ? "" : std::string(1, letter++));
    }
  }

  void write_texts(const Case& c, const Outcome& outcome, const std::string& patch) {
    if (c.digits.matfil != contact_program::Stored::none)
      write_text(c, patch + ".mat", contact_program::mat_text(c, outcome));
    if (!outcome.interior.empty() && c.subs_file != contact_program::SubsFile::none)
      write_text(c, patch + ".subs", contact_program::subs_text(c, outcome.interior));
  }

  /// Beside the result file, numbered as CONTACT does.
  void write_text(const Case& c, const std::string& ending, const std::string& text) {
    auto name = output_;
    OutputFile file(name.replace_extension(fmt::format(".{:04}{}", c.number, ending)));
    file.write(text);
    file.commit();
    if (json_) files_.push_back(name.string());
  }

  fs::path path_;
  bool mat_, json_;
  int count_;
  fs::path output_;
  contact_program::RunFile file_;
  ProgressBar bar_;
  bool shows_both_ = ::isatty(STDOUT_FILENO) == 1; ///< the tables and the bar in one terminal
  contact_program::Run run_;
  std::set<std::string> known_notes_; ///< each is printed once
  std::size_t refused_ = 0, unsolved_ = 0;
  // Of the document:
  Json refusals_ = Json::array(), extremes_ = Json::array();
  std::vector<std::string> files_ = {output_.string()};
};

int run(const RunArguments& arguments) {
  const InterruptGuard guard;
  return Run(arguments).run() ? ExitCode::done : ExitCode::not_met;
}

} // namespace

void add_run_command(CLI::App& program, int& exit_code) {
  auto* command = program.add_subcommand("run", "Run the cases of an input file of the program CONTACT");
  const auto arguments = std::make_shared<RunArguments>();
  command->add_option("FILE.inp", arguments->input, "input file, modules 1 and 3")->required()->type_name("");
  command->add_option("-o,--output", arguments->folder, "folder for FILE.h5")
      ->type_name("FOLDER")
      ->capture_default_str();
  command->add_flag(
      "--mat", arguments->mat,
      "also FILE.0001.mat, ... in CONTACT's layout for cases with A > 0, and .subs for points inside the bodies");
  add_json_flag(*command, arguments->json);
  command->footer(
      "Reads the whole file, then runs its cases in order, each with what the ones before it have left. Prints\n"
      "CONTACT's quantities with its names and units for each case and writes FILE.h5 (SI): totals of all cases and\n"
      "the fields that digit A asks for. A case with something that is not supported is named with digit and meaning,\n"
      "and the others run; docs/contact-input.md has the list. With --json the totals of all cases in SI units, by "
      "the\n"
      "names that they have in FILE.h5. Exit code 1: some cases are not run or not solved.\n\n"
      "Example:\n  microslip run examples/sphere_on_plane.inp -o results");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

} // namespace microslip
