#include "app/commands.hpp"

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/hertz.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/measured_points.hpp"
#include "app/progress_bar.hpp"
#include "app/sweep.hpp"
#include "campaign/launcher.hpp"
#include "campaign/sweep_file.hpp"
#include "io/case_file.hpp"
#include "io/csv_tables.hpp"
#include "io/output_file.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <thread>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

struct SweepArguments {
  fs::path spec, output;
  fs::path points = {}; ///< measured ones, beside curves over the creepage
  /// Threads of a rank; with many ranks the launcher gives each its processors.
  int threads = campaign::has_launcher() ? 1 : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool json = false;
};

/// Run of the command on one of the ranks.
class SweepRun {
public:
  /// `use` gets the result file, which is not kept then; without it the output is the result file.
  SweepRun(const SweepArguments& arguments, campaign::Ranks& ranks, UseOfFile use = {})
      : arguments_(arguments), ranks_(ranks), use_(std::move(use)) {}

  int run() {
    solve();
    if (!ranks_.is_first()) return ExitCode::done;
    print_warnings(arguments_.output.string(), count_.warnings);
    if (!arguments_.points.empty()) curves_ = campaign::compare_sweep(arguments_.output, arguments_.points);
    arguments_.json ? print_document() : print_summary();
    return count_.failed == 0 ? ExitCode::done : ExitCode::not_met;
  }

  campaign::SweepCount solve() {
    ranks_.agree([&] { io::require_other_file(arguments_.output, arguments_.spec); });
    ranks_.agree([&] { sweep_.emplace(io::read_case_text(arguments_.spec), arguments_.spec.string()); });
    ranks_.agree([&] {
      if (!ranks_.is_first()) return; // before the checkpoint's folder is made
      io::require_writable_file_in(arguments_.output.parent_path(), arguments_.output.filename());
      (void)find_result();
    });
    const campaign::CampaignPlan plan = sweep_->plan();
    campaign::Campaign campaign(campaign::checkpoint_of(arguments_.output), plan, ranks_);
    if (!is_complete(campaign)) {
      kept_ = campaign.kept_cases();
      compute(campaign);
      ranks_.agree(
          [&] {
            if (ranks_.is_first()) write(campaign);
          },
          may_go_on);
    }
    return count_;
  }

private:
  static bool may_go_on(double) {
    InterruptGuard::throw_if_interrupted();
    return true;
  }

  /// What an earlier run has written. Throws Error for another file.
  std::optional<campaign::SweepCount> find_result() const {
    return use_ ? std::nullopt : campaign::find_sweep(*sweep_, arguments_.output);
  }

  /// Returns whether an earlier run has written the result file; what it may have left of the checkpoint is removed.
  bool is_complete(campaign::Campaign& campaign) {
    bool is_there = false;
    ranks_.agree([&] {
      if (!ranks_.is_first()) return;
      const auto found = find_result();
      if (!found) return;
      is_there = true;
      count_ = *found;
      kept_ = count_.cases;
      campaign.remove();
    });
    return !ranks_.from_first(is_there ? "yes" : "").empty();
  }

  void compute(campaign::Campaign& campaign) {
    const double kept = static_cast<double>(kept_) / static_cast<double>(campaign.plan().count);
    ProgressBar bar(arguments_.spec.filename().string(), kept);
    const bool complete = campaign.run({.threads = arguments_.threads,
                                        .progress =
                                            [&](double fraction) {
                                              if (ranks_.is_first()) bar.update(fraction);
                                              return !InterruptGuard::interrupted();
                                            }},
                                       [&] { return sweep_->make_worker(); });
    if (!complete) throw Interrupted();
  }

  void write(campaign::Campaign& campaign) {
    const io::Provenance provenance = {.kind = campaign::sweep_kind,
                                       .title = sweep_->spec().title(),
                                       .command_line = command_line(),
                                       .case_file = arguments_.spec.string(),
                                       .case_text = sweep_->spec().text()};
    if (arguments_.output.has_parent_path()) io::create_folder(arguments_.output.parent_path());
    ProgressBar bar(arguments_.output.filename().string());
    const auto write_file = [&](const fs::path& path) {
      count_ = campaign::write_sweep(*sweep_, campaign, provenance, path, [&](double fraction) {
        bar.update(fraction);
        return may_go_on(fraction);
      });
    };
    if (use_)
      with_result_file(arguments_.output, write_file, use_);
    else
      write_file(arguments_.output);
    campaign.remove();
  }

  void print_summary() const {
    fmt::print("{} {}", count_.cases, count_.cases == 1 ? "case" : "cases");
    if (kept_ == count_.cases)
      fmt::print(", all of them computed before");
    else if (kept_ > 0)
      fmt::print(", {} of them from the checkpoint", kept_);
    fmt::print("\n{}\n", arguments_.output.string());
    if (!curves_.empty()) fmt::print("{}\n", comparison_text(curves_));
    std::fflush(stdout);
    if (count_.failed > 0)
      fmt::print(stderr, "microslip: warning: {}: {} of {} cases have another status than ok, see failures/\n",
                 arguments_.output.string(), count_.failed, count_.cases);
  }

  void print_document() const {
    io::Json document = json_document(campaign::sweep_kind);
    document["cases"] = count_.cases;
    document["cases_from_checkpoint"] = kept_;
    document["cases_failed"] = count_.failed;
    document["warnings"] = count_.warnings;
    if (!curves_.empty()) document["measured_points"] = comparison_document(curves_);
    document["files"] = {arguments_.output.string()};
    print_json(document);
  }

  const SweepArguments& arguments_;
  campaign::Ranks& ranks_;
  UseOfFile use_;
  std::optional<campaign::Sweep> sweep_;
  std::size_t kept_ = 0;
  campaign::SweepCount count_;
  std::vector<campaign::ComparedCurve> curves_; ///< those with measured points
};

/// What makes the table where one is asked for. Nothing in a table tells of which sweep it is: none is replaced.
UseOfFile table_of(const SweepArguments& arguments, const campaign::Ranks& ranks) {
  if (!io::is_csv(arguments.output)) return {};
  if (ranks.is_first() && fs::exists(arguments.output))
    throw Error(arguments.output.string() + ": is there already; remove it, or name another file");
  return [&](const fs::path& result_file) { io::write_csv_tables(result_file, arguments.output); };
}

int sweep(const SweepArguments& arguments) {
  require_count("--threads", arguments.threads, 1, most_threads);
  if (!arguments.points.empty() && io::is_csv(arguments.output)) throw Error("--points: needs OUT.h5, not a table");
  const auto ranks = campaign::launched_ranks();
  try {
    UseOfFile table;
    ranks->agree([&] { table = table_of(arguments, *ranks); });
    return SweepRun(arguments, *ranks, table).run();
  } catch (const Error&) { // the same on all ranks
    if (ranks->is_first()) throw;
    return ExitCode::done; // with another code mpirun would end the first rank, which has yet to say what is wrong
  }
}

constexpr const char* footer = R"(SPEC.toml names a case file of `solve` and the keys that vary:

  case = "wheel_on_rail.toml"
  [grid]                                  # all combinations; or [sample] with count and seed, or
  wheel.lateral = { from = 0, to = 7e-3, count = 71 }              # [list] with file = "cases.csv"
  solution.theory = ["fastsim2", "exact"]

OUT.h5 has the parameters and all quantities of every case, in their order, and the reasons of those that are
not solved. Finished chunks of cases are kept in OUT.h5.checkpoint until OUT.h5 is complete: after an
interruption, a crash or a full disk the same command goes on with what is missing, and ends at once if nothing
is. With -o OUT.csv all of it is one table, a row for each case. Started by mpirun all ranks share the cases. The
results are the same to the last bit on any threads and ranks. Exit code 1: some cases have another status than
ok.

Example:
  microslip sweep examples/creep_sweep.toml -o creep.h5
  mpirun -n 64 microslip sweep examples/creep_sweep.toml -o creep.h5)";

} // namespace

campaign::SweepCount run_sweep(const fs::path& spec, const fs::path& output, const UseOfFile& use) {
  const SweepArguments arguments = {.spec = spec, .output = output};
  const auto ranks = campaign::launched_ranks();
  return SweepRun(arguments, *ranks, use).solve();
}

void add_sweep_command(Command& program, int& exit_code) {
  Command command =
      program.add_subcommand("sweep", "Solve many cases: a grid, a list or a random sample of a case's keys", footer);
  SweepArguments& arguments = command.arguments(exit_code, sweep);
  command.add_option("SPEC.toml", arguments.spec, "what varies in which case").required();
  command.add_option("-o,--output OUT.h5", arguments.output, "result file, or OUT.csv for a table").required();
  command.add_option("--points POINTS.csv", arguments.points,
                     "measured creep curves as of `fit`, beside those of a sweep over the creepage, with rms and bias");
  command.add_option(
      "--threads COUNT", arguments.threads,
      "threads, 1 to 1024; results do not depend on it; default: one for each processor, with mpirun one "
      "for each rank");
  add_json_flag(command, arguments.json);
}

} // namespace microslip::app
