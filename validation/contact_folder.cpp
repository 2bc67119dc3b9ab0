#include "validation/studies.hpp"

#include "compat/contact/input.hpp"
#include "compat/contact/out.hpp"
#include "compat/contact/run.hpp"
#include "microslip/error.hpp"
#include "validation/contact_comparison.hpp"
#include "validation/contact_output.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

namespace fs = std::filesystem;
using contact_program::Case;
using contact_program::Outcome;

constexpr const char* input_folder = MICROSLIP_REFERENCE_DATA "/../contact-cases";

/// Results for one file, or the sum over many.
struct Tally {
  int cases = 0, patches = 0;
  std::array<int, agreements> counts = {};
  std::map<std::string, int> explained = {}; ///< differences by the text of their explanation
  int unexplained = 0;
  int without_file = 0, not_run = 0, other_patches = 0; ///< cases; of the first files that they name are not there
  int missing = 0;                                      ///< quantities that are not printed
  double seconds = 0;                                   ///< of the processor

  int quantities() const { return std::accumulate(counts.begin(), counts.end(), 0); }
  Tally& operator+=(const Tally& other) {
    cases += other.cases, patches += other.patches, unexplained += other.unexplained, not_run += other.not_run;
    without_file += other.without_file;
    other_patches += other.other_patches, missing += other.missing, seconds += other.seconds;
    for (std::size_t k = 0; k < agreements; ++k) counts[k] += other.counts[k];
    for (const auto& [text, count] : other.explained) explained[text] += count;
    return *this;
  }
};

std::string row(const std::string& name, const Tally& t) {
  std::string text = fmt::format("{:<24} {:>6} {:>7} {:>8}", name, t.cases, t.patches, t.quantities());
  for (const int count : t.counts) text += fmt::format(" {:>7}", count);
  return text + fmt::format(" {:>7} {:>8.2f}", t.unexplained, t.seconds);
}

/// Returns true for a case that is refused because a file that it names is not there.
bool lacks_file(const Outcome& outcome) {
  return std::ranges::any_of(
      outcome.reasons, [](const std::string& reason) { return reason.find("cannot be read") != std::string::npos; });
}

/// A case as its output file would have it.
PrintedCase printed(const Case& c, const Outcome& outcome) {
  std::istringstream text(contact_program::out_text(c, outcome));
  auto cases = read_contact_output(text);
  return cases.empty() ? PrintedCase{} : std::move(cases.front());
}

/// Runs an input file beside its output file.
class FileComparison {
public:
  FileComparison(Report& report, const fs::path& input, const fs::path& output) : report_(report), input_(input) {
    std::ifstream in(output);
    printed_ = read_contact_output(in);
  }

  /// False if it was asked to stop.
  bool run(const Progress& progress) {
    std::ifstream in(input_);
    contact_program::InputReader reader(in, input_.string());
    contact_program::Run runs;
    const std::clock_t begin = std::clock(); // of the processor, whatever else runs
    std::size_t at = 0;
    while (const Case* c = reader.next()) {
      const Outcome outcome = runs.run(*c);
      const PrintedCase ours = printed(*c, outcome);
      const auto theirs = std::find_if(printed_.begin() + static_cast<std::ptrdiff_t>(at), printed_.end(),
                                       [&](const PrintedCase& one) { return one.label == ours.label; });
      if (theirs != printed_.end()) {
        at = static_cast<std::size_t>(theirs - printed_.begin()) + 1;
        take(*c, outcome, ours, *theirs);
      }
      const double all = static_cast<double>(std::max<std::size_t>(1, printed_.size()));
      if (progress && !progress(static_cast<double>(at) / all)) return false;
    }
    tally_.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return true;
  }

  const Tally& tally() const { return tally_; }

private:
  void take(const Case& c, const Outcome& outcome, const PrintedCase& ours, const PrintedCase& theirs) {
    if (outcome.kind == Outcome::Kind::skipped) return;
    if (outcome.kind == Outcome::Kind::refused) {
      ++(lacks_file(outcome) ? tally_.without_file : tally_.not_run);
      for (const auto& reason : outcome.reasons) line(ours.label + ": not run: " + reason);
      return;
    }
    const CaseComparison found = compare(ours, theirs);
    ++tally_.cases;
    tally_.patches += static_cast<int>(found.their_patches);
    for (std::size_t k = 0; k < agreements; ++k) tally_.counts[k] += found.counts[k];
    if (found.our_patches != found.their_patches) {
      ++tally_.other_patches;
      line(fmt::format("{}: {} patches, CONTACT {}", ours.label, found.our_patches, found.their_patches));
    }
    for (const auto& name : found.missing) ++tally_.missing, line(ours.label + ": no " + name);
    for (const Difference& d : found.differences) explain(d, c, outcome, ours.label);
  }

  void explain(const Difference& d, const Case& c, const Outcome& outcome, const std::string& label) {
    if (const Explanation* found = explanation_of(d, c, outcome)) {
      ++tally_.explained[found->text];
      return;
    }
    ++tally_.unexplained;
    line(fmt::format("{}{}: {} {:.6g}, CONTACT {:.6g}", label, d.patch > 0 ? fmt::format(" patch {}", d.patch) : "",
                     d.name, d.ours.value, d.theirs.value));
  }

  /// Of the first differences: the table counts the others.
  void line(const std::string& text) {
    constexpr int most = 20;
    if (lines_ == 0) report_.heading(input_.filename().string());
    if (++lines_ <= most) report_.line(text);
    if (lines_ == most) report_.line("...");
  }

  Report& report_;
  fs::path input_;
  std::vector<PrintedCase> printed_;
  Tally tally_;
  int lines_ = 0;
};

/// The input files of a folder and those below it that have CONTACT's output beside them, as FILE.ref_out.
std::vector<fs::path> input_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".inp" && fs::exists(fs::path(entry.path()).replace_extension(".ref_out")))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

void print_groups(Report& report, const Tally& all) {
  report.heading("Differences by their explanation in docs/contact-differences.md: quantities");
  for (const auto& [text, count] : all.explained) report.line(fmt::format("{:<52} {:>12}", text, count));
  report.line(fmt::format("{:<52} {:>12}", "not explained", all.unexplained));
}

} // namespace

bool run_contact_folder(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  const fs::path folder = options.cases.empty() ? fs::path(input_folder) : options.cases;
  if (options.cases.empty() && !fs::exists(folder)) {
    report.line("SKIPPED: the folder of CONTACT's cases is not beside MICROSLIP_REFERENCE_DATA; --cases names another");
    return true;
  }
  const std::vector<fs::path> files = input_files(folder);
  if (files.empty()) throw Error(folder.string() + ": no .inp file there has a .ref_out file beside it");
  Tally all;
  std::vector<std::string> rows;
  for (std::size_t k = 0; k < files.size(); ++k) {
    FileComparison file(report, files[k], fs::path(files[k]).replace_extension(".ref_out"));
    const double count = static_cast<double>(files.size()), done = static_cast<double>(k) / count;
    if (!file.run(part_of(options.progress, done, done + 1 / count))) return false;
    rows.push_back(row(files[k].stem().string(), file.tally()));
    all += file.tally();
  }
  report.heading(
      "Cases, patches, quantities; of these equal in all printed digits, but for the last digit, within 0.1 %, "
      "within 1 %, off; not explained; seconds of the processor");
  report.line(fmt::format("{:<24} {:>6} {:>7} {:>8} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>8}", "", "cases", "patches",
                          "numbers", "equal", "last", "0.1 %", "1 %", "off", "unexpl.", "time s"));
  for (const auto& text : rows) report.line(text);
  report.line(row("all", all));
  print_groups(report, all);
  report.remark("cases whose files are not there", fmt::format("{}", all.without_file), "", "a file that they name");
  report.count("cases that were not run", all.not_run, 0);
  report.count("cases with another number of patches", all.other_patches, 0);
  report.count("numbers that are not printed", all.missing, 0);
  report.count("differences without an explanation", all.unexplained, 0);
  return report.all_as_stated();
}

} // namespace microslip::validation
