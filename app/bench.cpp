#include "app/commands.hpp"

#include "app/bench_comparison.hpp"
#include "app/bench_rows.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/machine.hpp"
#include "app/progress_bar.hpp"
#include "io/nearest_word.hpp"
#include "microslip/error.hpp"
#include "microslip/version.hpp"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

/// Processor time, which other work on the machine changes less than elapsed time: the median over at least five runs
/// and half a second, after one to warm up.
double seconds_a_contact(const Work& work) {
  constexpr double long_enough = 0.5;
  const auto now = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  work();
  std::vector<double> times;
  const double begin = now();
  while (times.size() < 5 || now() - begin < long_enough) {
    const double start = now();
    const auto count = static_cast<double>(work());
    times.push_back((now() - start) / count);
    InterruptGuard::throw_if_interrupted();
  }
  std::ranges::nth_element(times, times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2));
  return times[times.size() / 2];
}

const BenchRow* row_of(const std::vector<BenchRow>& rows, std::string_view name) {
  const auto found = std::ranges::find(rows, name, &BenchRow::name);
  return found == rows.end() ? nullptr : &*found;
}

void print_rows(const std::vector<BenchRow>& rows) {
  const auto build = build_info();
  fmt::print("microslip {}, commit {}, {}, {}\n{}\n\n{:<42}{:>10}  {}\n", build.version, build.commit, build.compiler,
             build.build_type, machine(), "processor time, median", "a contact", "ratio");
  for (const BenchRow& row : rows) {
    std::string ratio;
    if (const BenchRow* over = row_of(rows, row.over)) {
      ratio = fmt::format("{:.3g} x {}", row.seconds / over->seconds, over->name);
      if (row.limit > 0) ratio += fmt::format(", by design at most {:g}", row.limit);
    }
    fmt::print("{:<42}{:>10}  {}\n", row.name, time_text(row.seconds), ratio);
  }
}

io::Json document_of(const std::vector<BenchRow>& rows) {
  io::Json document = json_document("bench");
  document["machine"] = machine();
  document["rows"] = io::Json::array();
  for (const BenchRow& row : rows) {
    io::Json line = {{"name", row.name}, {"seconds", row.seconds}};
    if (const BenchRow* over = row_of(rows, row.over))
      line.update(io::Json{{"over", row.over}, {"ratio", row.seconds / over->seconds}});
    if (row.limit > 0) line["limit"] = row.limit;
    document["rows"].push_back(line);
  }
  return document;
}

struct BenchArguments {
  std::string subject;
  std::vector<std::filesystem::path> compared; ///< an older document, and a newer one in place of a run now
  bool json = false;
};

std::vector<BenchRow> measured_rows() {
  std::vector<BenchRow> rows = bench_rows();
  ProgressBar bar("bench");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].seconds = seconds_a_contact(rows[k].work);
    bar.update(static_cast<double>(k + 1) / static_cast<double>(rows.size()));
  }
  return rows;
}

void compare(const BenchArguments& arguments) {
  const io::Json older = read_bench(arguments.compared.front());
  io::Json document = arguments.compared.size() > 1 ? read_bench(arguments.compared[1]) : document_of(measured_rows());
  add_comparison(document, older);
  if (arguments.json)
    print_json(document);
  else
    print_comparison(document, older);
}

void bench(const BenchArguments& arguments) {
  if (!arguments.compared.empty()) return compare(arguments);
  const std::vector<BenchRow> rows = measured_rows();
  if (arguments.json)
    print_json(document_of(rows));
  else
    print_rows(rows);
}

constexpr const char* footer =
    R"(Each line is the median processor time of runs for half a second, and its ratio to another line: times depend
on the machine and on what else it does, ratios less. docs/performance.md has more.

With the word vehicle: a wheelset, a bogie and a car over an irregular track, in times of real time, where
microslip was built with Simbody; docs/vehicle.md describes them.

What is slower or faster than before, with each line's ratio:
  microslip bench --json > before.json
  microslip bench --compare before.json

Example:
  microslip bench)";

} // namespace

void add_bench_command(Command& program, int& exit_code, int (*vehicle)(bool json)) {
  Command command =
      program.add_subcommand("bench", "Print what a contact costs on this machine, within a minute", footer);
  const auto arguments = std::make_shared<BenchArguments>();
  command.add_option("SUBJECT", arguments->subject, "vehicle: a running vehicle in place of contacts");
  command
      .add_option("--compare OLD [NEW]", arguments->compared,
                  "print the ratios to what `bench --json` wrote before; of two such files in place of a run now")
      .expected(1, 2);
  add_json_flag(command, arguments->json);
  command.callback([=, &exit_code] {
    const std::string& subject = arguments->subject;
    if (subject == "vehicle" && arguments->compared.empty())
      exit_code = vehicle(arguments->json);
    else if (subject == "vehicle")
      throw Error("--compare is for contacts, not for vehicle");
    else if (subject.empty())
      bench(*arguments);
    else
      throw Error("there is nothing called " + io::printable(subject) + " to measure; did you mean vehicle?");
  });
}

} // namespace microslip::app
