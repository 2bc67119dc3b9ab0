#include "app/commands.hpp"

#include "app/command_line.hpp"
#include "app/contact_tables.hpp"
#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/progress_bar.hpp"
#include "cases/interior_result.hpp"
#include "compat/contact/mat.hpp"
#include "compat/contact/out.hpp"
#include "compat/contact/run.hpp"
#include "compat/contact/run_file.hpp"
#include "compat/contact/wheel_rail/own_solution.hpp"
#include "io/input_file.hpp"
#include "io/output_file.hpp"
#include "io/result_json.hpp"
#include "microslip/error.hpp"

#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;
using contact_program::Case;
using contact_program::InputReader;
using contact_program::Outcome;

struct RunArguments {
  fs::path input, folder = "results";
  bool out = false, mat = false, accurate = false, json = false;
};

/// The file is read twice: once to see that all of it is right.
std::ifstream open(const fs::path& path) {
  std::ifstream file = io::open_input(path);
  if (!fs::is_regular_file(path)) throw Error(path.string() + ": cannot be read: it is not a regular file");
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
      : path_(arguments.input), mat_(arguments.mat), accurate_(arguments.accurate), json_(arguments.json),
        count_(count_cases(path_)), output_(output_path(arguments)), file_(output_, {.kind = "contact_run",
                                                                                     .title = path_.stem().string(),
                                                                                     .command_line = command_line(),
                                                                                     .case_file = path_.string(),
                                                                                     .case_text = short_text(path_)}),
        bar_(path_.filename().string()), run_(arguments.out) {
    if (!arguments.out) return;
    auto path = output_;
    out_.emplace(path.replace_extension(".out"));
    files_.push_back(path.string());
    out_->write(contact_program::out_head());
  }

  /// Returns whether all cases are solved.
  bool run() {
    auto input = open(path_);
    InputReader reader(input, path_.string());
    while (const Case* c = reader.next()) {
      const Outcome outcome = run_.run(*c);
      count(*c, outcome);
      if (shows_both_) bar_.clear();
      if (json_)
        keep(*c, outcome);
      else
        print(*c, outcome);
      if (accurate_ && outcome.kind == Outcome::Kind::solved && outcome.wheel) compare(*c, *outcome.wheel);
      file_.add(*c, outcome);
      if (out_) out_->write(contact_program::out_text(*c, outcome));
      if (mat_ && outcome.kind == Outcome::Kind::solved) write_texts(*c, outcome);
      InterruptGuard::throw_if_interrupted();
      bar_.update(static_cast<double>(c->number) / count_);
    }
    bar_.clear();
    print_refusals();
    file_.commit();
    if (out_) {
      out_->write(contact_program::out_end());
      out_->commit();
    }
    if (!json_) print_not_compared(), print_effort();
    json_ ? print_document() : fmt::print("\n{}\n", output_.string());
    std::fflush(stdout);
    if (!reader.is_complete())
      fmt::print(stderr, "microslip: warning: {}: the file ends without MODULE 0; is it complete?\n", path_.string());
    warn(refused_, "not run");
    warn(unsolved_, "not solved, see their status");
    return refused_.empty() && unsolved_.empty();
  }

private:
  static fs::path output_path(const RunArguments& arguments) {
    io::create_folder(arguments.folder);
    return arguments.folder / (arguments.input.stem().string() + ".h5");
  }

  void count(const Case& c, const Outcome& outcome) {
    if (outcome.kind == Outcome::Kind::refused) refused_.push_back(c.number);
    if (outcome.wheel) {
      effort_.geometry += outcome.wheel->effort.geometry;
      effort_.normal += outcome.wheel->effort.normal;
      effort_.tangential += outcome.wheel->effort.tangential;
    }
    if (outcome.kind == Outcome::Kind::solved && outcome.solution.report.status != Status::ok)
      unsolved_.push_back(c.number);
  }

  void print(const Case& c, const Outcome& outcome) {
    if (outcome.kind == Outcome::Kind::refused) {
      if (outcome.reasons != waiting_.reasons) print_refusals();
      if (waiting_.cases.empty()) waiting_ = {.reasons = outcome.reasons};
      waiting_.cases.push_back(c.number);
      waiting_.lines.push_back(c.line);
      return;
    }
    print_refusals();
    begin_case();
    fmt::print("Case {} (line {}): ", c.number, c.line);
    if (outcome.kind == Outcome::Kind::skipped) {
      fmt::print("skipped, {}\n", written(c.digits.solve));
    } else {
      print_solution(c, outcome);
      for (const auto& note : outcome.notes)
        if (known_notes_.insert(note).second) fmt::print("  note: {}\n", note);
    }
    std::fflush(stdout);
  }

  /// Cases that were not run for the same reasons, one after the other.
  void print_refusals() {
    const auto& [cases, lines, reasons] = std::exchange(waiting_, {});
    if (cases.empty()) return;
    begin_case();
    if (cases.size() == 1)
      fmt::print("Case {} (line {}): not run\n", cases[0], lines[0]);
    else
      fmt::print("Cases {} to {} (lines {} to {}): not run\n", cases.front(), cases.back(), lines.front(),
                 lines.back());
    for (const auto& reason : reasons) fmt::print("  {}\n", reason);
    std::fflush(stdout);
  }

  /// Prints the effort of wheels on rails.
  void print_effort() const {
    if (effort_.geometry == 0) return;
    fmt::print("\n{} analyses of the geometry, {} normal and {} tangential problems, {:.2f} s of the processor\n",
               effort_.geometry, effort_.normal, effort_.tangential,
               static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
  }

  /// Reasons, each with its cases.
  void print_not_compared() const {
    if (!not_compared_.empty()) fmt::print("\nNot solved accurately:\n");
    for (const auto& [reason, cases] : not_compared_)
      fmt::print("  {} {}: {}\n", cases.size() == 1 ? "case" : "cases", ranges(cases), reason);
  }

  void begin_case() {
    if (std::exchange(has_printed_, true)) fmt::print("\n");
  }

  /// The comparison with microslip's geometry, patches and elements of second order.
  void compare(const Case& c, const contact_program::WheelOutcome& wheel) {
    const auto own = contact_program::compare_with_own(c, wheel);
    if (json_) {
      comparisons_.push_back(comparison_json(c.number, own));
      return;
    }
    for (const auto& reason : own.reasons) not_compared_[reason].push_back(c.number);
    if (!own.reasons.empty()) return;
    fmt::print("  accurate: {}, {} {}\n", own.status, own.own_patches, own.own_patches == 1 ? "patch" : "patches");
    fmt::print("  {:>5} {:<20} {:>13} {:>13} {:>11}\n", "patch", "", "as CONTACT", "accurate", "difference");
    for (const auto& n : own.numbers)
      fmt::print("  {:>5} {:<20} {:>13.6g} {:>13.6g} {:>11.2g}\n", n.patch > 0 ? std::to_string(n.patch) : "",
                 n.name + " [" + n.unit + "]", n.program, n.own, n.own - n.program);
  }

  static io::Json comparison_json(int number, const contact_program::OwnComparison& own) {
    io::Json numbers = io::Json::array();
    for (const auto& n : own.numbers)
      numbers.push_back({{"name", n.name},
                         {"unit", n.unit},
                         {"patch", n.patch},
                         {"contact", io::json_number(n.program)},
                         {"accurate", io::json_number(n.own)},
                         {"difference", io::json_number(n.own - n.program)}});
    return {{"case", number},
            {"status", own.status},
            {"patches", own.own_patches},
            {"not_solved", own.reasons},
            {"quantities", numbers}};
  }

  /// Keeps what the result file does not have.
  void keep(const Case& c, const Outcome& outcome) {
    if (outcome.kind == Outcome::Kind::refused)
      refusals_.push_back({{"case", c.number}, {"line", c.line}, {"reasons", outcome.reasons}});
    if (outcome.kind == Outcome::Kind::solved && outcome.solution.report.status != Status::ok)
      failures_.push_back({{"case", c.number},
                           {"line", c.line},
                           {"status", std::string(to_string(outcome.solution.report.status))},
                           {"residual", io::json_number(outcome.solution.report.residual)},
                           {"notes", outcome.notes}});
    known_notes_.insert(outcome.notes.begin(), outcome.notes.end());
    keep_extremes(c.number, outcome);
    if (outcome.wheel)
      for (const auto& patch : outcome.wheel->patches) keep_extremes(c.number, *patch.solution);
  }

  void keep_extremes(int number, const Outcome& outcome) {
    int block = 0;
    for (const auto& [points, states] : outcome.interior)
      extremes_.push_back({{"case", number}, {"block", ++block}, {"extremes", cases::extremes_json(points, states)}});
  }

  void print_document() const {
    auto document = io::result_json(output_);
    document["cases_not_run"] = refusals_;
    document["cases_not_solved"] = failures_;
    name_codes(document);
    document["interior_extremes"] = extremes_;
    if (accurate_) document["accurate"] = comparisons_;
    if (effort_.geometry > 0)
      document["effort"] = {
          {"geometry", effort_.geometry}, {"normal", effort_.normal}, {"tangential", effort_.tangential}};
    document["notes"] = known_notes_;
    document["files"] = files_;
    print_json(document);
  }

  /// Words instead of the numbers that the result file has.
  static void name_codes(io::Json& document) {
    constexpr const char* outcomes[] = {"solved", "skipped", "refused"};
    const auto name_status = [](io::Json& status) {
      status = std::string(to_string(static_cast<Status>(status.get<int>())));
    };
    io::Json& cases = document["cases"];
    for (io::Json& outcome : cases["outcome"]) outcome = outcomes[outcome.get<int>()];
    for (std::size_t k = 0; k < cases["status"].size(); ++k)
      if (cases["outcome"][k] == outcomes[0])
        name_status(cases["status"][k]);
      else
        cases["status"][k] = io::Json();
    if (document.contains("wheels"))
      for (io::Json& status : document["wheels"]["status"]) name_status(status);
  }

  /// Names the cases: 3, 5 to 9.
  static std::string ranges(const std::vector<int>& numbers) {
    std::string text;
    for (std::size_t first = 0, last = 0; first < numbers.size(); first = ++last) {
      while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
      text += (text.empty() ? "" : ", ") + std::to_string(numbers[first]);
      if (last > first) text += (last == first + 1 ? ", " : " to ") + std::to_string(numbers[last]);
    }
    return text;
  }

  void warn(const std::vector<int>& cases, const char* what) const {
    if (!cases.empty())
      fmt::print(stderr, "microslip: warning: {}: {} of {} cases are {}: {}\n", path_.string(), cases.size(), count_,
                 what, ranges(cases));
  }

  /// Writes texts in CONTACT's layout.
  void write_texts(const Case& c, const Outcome& outcome) {
    if (!outcome.wheel) {
      if (c.digits.matfil != contact_program::Stored::none)
        write_text(c, ".mat", contact_program::mat_text(c, outcome));
      write_points(c, outcome, "");
      return;
    }
    const auto& patches = outcome.wheel->patches;
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const std::string letter = contact_program::patch_letter(k);
      if (c.digits.matfil != contact_program::Stored::none)
        write_text(c, letter + ".mat", contact_program::mat_text(c, *outcome.wheel, k));
      write_points(c, *patches[k].solution, letter);
    }
  }

  void write_points(const Case& c, const Outcome& outcome, const std::string& patch) {
    if (!outcome.interior.empty() && c.subs_file != contact_program::SubsFile::none)
      write_text(c, patch + ".subs", contact_program::subs_text(c, outcome.interior));
  }

  /// Beside the result file, numbered as CONTACT does.
  void write_text(const Case& c, const std::string& ending, const std::string& text) {
    auto name = output_;
    io::OutputFile file(name.replace_extension(fmt::format(".{:04}{}", c.number, ending)));
    file.write(text);
    file.commit();
    if (json_) files_.push_back(name.string());
  }

  fs::path path_;
  bool mat_, accurate_, json_;
  int count_;
  fs::path output_;
  contact_program::RunFile file_;
  std::optional<io::OutputFile> out_; ///< in CONTACT's layout
  ProgressBar bar_;
  bool shows_both_ = ::isatty(STDOUT_FILENO) == 1; ///< the tables and the bar in one terminal
  contact_program::Run run_;
  std::set<std::string> known_notes_; ///< each is printed once
  /// Refusals that are not printed yet, for others of the same reasons may follow.
  struct Waiting {
    std::vector<int> cases = {};
    std::vector<std::size_t> lines = {};
    std::vector<std::string> reasons = {};
  };
  Waiting waiting_;
  bool has_printed_ = false;
  contact_program::WheelEffort effort_;
  std::vector<int> refused_, unsolved_;                  ///< numbers of cases
  std::map<std::string, std::vector<int>> not_compared_; ///< of the accurate level
  // Of the document:
  io::Json refusals_ = io::Json::array(), failures_ = io::Json::array(), extremes_ = io::Json::array(),
           comparisons_ = io::Json::array();
  std::vector<std::string> files_ = {output_.string()};
};

int run(const RunArguments& arguments) {
  return Run(arguments).run() ? ExitCode::done : ExitCode::not_met;
}

constexpr const char* footer =
    R"(Reads the whole file, then runs its cases in order, each with what the ones before it have left. Prints
CONTACT's quantities with its names and units for each case and writes FILE.h5 (SI): totals of all cases and
the fields that digit A asks for. A case with something that is not supported is named with digit and meaning,
and the others run; docs/contact-input.md has the list. With --json the totals of all cases in SI units, by the
names that they have in FILE.h5. Exit code 1: some cases are not run or not solved.

Example:
  microslip run examples/sphere_on_plane.inp -o results)";

} // namespace

void add_run_command(Command& program, int& exit_code) {
  Command command = program.add_subcommand("run", "Run the cases of an input file of the program CONTACT", footer);
  RunArguments& arguments = command.arguments(exit_code, run);
  command.add_option("FILE.inp", arguments.input, "input file, modules 1 and 3").required();
  command.add_option("-o,--output FOLDER", arguments.folder, "folder for FILE.h5").capture_default_str();
  command.add_flag("--out", arguments.out, "also FILE.out, CONTACT's output file");
  command.add_flag(
      "--mat", arguments.mat,
      "also FILE.0001.mat, ... in CONTACT's layout for cases with A > 0, and .subs for points inside the bodies");
  command.add_flag(
      "--accurate", arguments.accurate,
      "also solves wheels on rails by microslip's geometry, patches and elements of second order, and prints "
      "both beside each other");
  add_json_flag(command, arguments.json);
}

} // namespace microslip::app
