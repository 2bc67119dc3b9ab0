#include "binding/sweep.hpp"

#include "binding/long_work.hpp"
#include "binding/paths.hpp"
#include "campaign/sweep_file.hpp"
#include "campaign/sweep_statistics.hpp"
#include "io/case_file.hpp"
#include "io/json_result.hpp"
#include "io/output_file.hpp"
#include "microslip/batch/batch.hpp"
#include "microslip/error.hpp"

#include <pybind11/stl.h>

#include <cstring>
#include <filesystem>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace microslip::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

struct SweepReport {
  std::size_t cases = 0, failed = 0, from_checkpoint = 0;
};

/// A chunk as it travels between processes: its number, its rows, its failed cases.
using SentChunk = std::tuple<std::size_t, py::bytes, std::vector<std::pair<std::size_t, std::string>>>;

/// Solves chunks of a sweep in one thread of whichever process.
class ChunkSolver {
public:
  ChunkSolver(const std::string& text, const std::string& name)
      : sweep_(text, name), plan_(sweep_.plan()), worker_(sweep_.make_worker()) {}

  SentChunk solve(std::size_t number) const {
    campaign::CampaignRows rows;
    // A batch of one chunk: its solvers use one thread, as in all batches, on which their last bits depend.
    run_batch(1, 1, 1, [&]() -> BatchWorker {
      return [&](std::size_t, std::size_t, const Progress& progress) {
        campaign::compute_chunk(plan_, number, worker_, progress, rows);
      };
    });
    std::vector<std::pair<std::size_t, std::string>> failed;
    for (const auto& [index, reason] : rows.failed) failed.emplace_back(index, reason);
    const py::bytes values(reinterpret_cast<const char*>(rows.values.data()), rows.values.size() * sizeof(double));
    return {rows.number, values, failed};
  }

private:
  campaign::Sweep sweep_;
  campaign::CampaignPlan plan_;
  campaign::RowWorker worker_;
};

campaign::CampaignRows rows_of(const SentChunk& sent) {
  const std::string bytes = std::get<1>(sent);
  campaign::CampaignRows rows{
      .number = std::get<0>(sent), .values = std::vector<double>(bytes.size() / sizeof(double)), .failed = {}};
  std::memcpy(rows.values.data(), bytes.data(), bytes.size());
  for (const auto& [index, reason] : std::get<2>(sent)) rows.failed.push_back({index, reason});
  return rows;
}

/// A checkpoint's lock keeps other processes away; this one keeps away the other threads of this one. Python's lock
/// must be held.
class OneInProcess {
public:
  explicit OneInProcess(const std::filesystem::path& output) : output_(std::filesystem::weakly_canonical(output)) {
    if (!busy().insert(output_).second) throw Error(output_.string() + ": another sweep of this process writes to it");
  }
  OneInProcess(const OneInProcess&) = delete;
  OneInProcess& operator=(const OneInProcess&) = delete;
  ~OneInProcess() { busy().erase(output_); }

private:
  static std::set<std::filesystem::path>& busy() {
    static std::set<std::filesystem::path> all;
    return all;
  }
  std::filesystem::path output_;
};

/// Some thousand chunks are with the executor at a time; those that are done wait in a queue.
void solve_by(const py::object& executor, const campaign::SweepSpec& spec, campaign::Campaign& campaign) {
  constexpr std::size_t most_pending = 4096;
  const py::object submit = executor.attr("submit"), queue = py::module_::import("queue").attr("SimpleQueue")(),
                   solve_chunk = py::module_::import("microslip.sweep_chunk").attr("solve_chunk");
  py::set pending;
  const auto& missing = campaign.missing_chunks();
  try {
    for (std::size_t next = 0; next < missing.size() || !pending.empty();) {
      for (; next < missing.size() && pending.size() < most_pending; ++next) {
        const py::object future = submit(solve_chunk, spec.text(), spec.name(), missing[next]);
        pending.add(future);
        future.attr("add_done_callback")(queue.attr("put"));
      }
      const py::object done = queue.attr("get")();
      pending.attr("discard")(done);
      campaign.keep(rows_of(done.attr("result")().cast<SentChunk>()));
    }
  } catch (...) {
    const py::error_scope scope;
    for (const auto& future : pending) future.attr("cancel")();
    throw;
  }
}

void solve_on_threads(const campaign::Sweep& sweep, campaign::Campaign& campaign, int threads) {
  long_work([&](const Progress& progress) {
    campaign.run({.threads = threads, .progress = progress}, [&] { return sweep.make_worker(); });
  });
}

SweepReport sweep(const py::object& spec, const py::object& output, int threads, const py::object& executor) {
  const int count = thread_count(threads);
  // Other processes may stand in other folders.
  const std::string name = std::filesystem::absolute(readable_path(spec)).string();
  const std::filesystem::path path = std::filesystem::absolute(path_from(output));
  const OneInProcess alone(path);
  const campaign::Sweep cases(io::read_case_text(name), name);
  campaign::Ranks one;
  campaign::Campaign campaign(campaign::checkpoint_of(path), cases.plan(), one);
  if (const auto found = campaign::find_sweep(cases, path)) {
    campaign.remove();
    return {found->cases, found->failed, found->cases};
  }
  const std::size_t kept = campaign.kept_cases();
  executor.is_none() ? solve_on_threads(cases, campaign, count) : solve_by(executor, cases.spec(), campaign);
  const auto arguments = py::module_::import("shlex").attr("join")(py::module_::import("sys").attr("argv"));
  // Holds Python's lock: the HDF5 library keeps global state, which other modules may share.
  SignalCheck signals;
  const campaign::SweepCount found = campaign::write_sweep(cases, campaign,
                                                           {.kind = campaign::sweep_kind,
                                                            .title = cases.spec().title(),
                                                            .command_line = arguments.cast<std::string>(),
                                                            .case_file = name,
                                                            .case_text = cases.spec().text()},
                                                           path, signals.progress());
  campaign.remove();
  return {found.cases, found.failed, kept};
}

/// The document of `microslip statistics --json`.
py::object sweep_statistics(const py::object& path, const std::vector<std::string>& quantities,
                            const std::vector<double>& quantiles, const std::string& group_by) {
  const std::string name = readable_path(path);
  const auto found =
      campaign::sweep_statistics(name, {.quantities = quantities, .probabilities = quantiles, .group_by = group_by});
  io::JsonResult result({.kind = campaign::statistics_kind, .title = found.title, .case_file = name},
                        io::JsonFields::kept);
  campaign::write_statistics(found, result);
  return py::module_::import("json").attr("loads")(io::json_text(result.document()));
}

} // namespace

void bind_sweep(py::module_& module) {
  py::class_<SweepReport>(module, "SweepReport", "How the cases of a sweep ended.")
      .def_readonly("cases", &SweepReport::cases, "All of them [-].")
      .def_readonly("failed", &SweepReport::failed, "Those with another status than ok [-].")
      .def_readonly("from_checkpoint", &SweepReport::from_checkpoint, "Those that an earlier run had computed [-].");
  py::class_<ChunkSolver>(module, "_ChunkSolver")
      .def(py::init<const std::string&, const std::string&>())
      .def("solve", &ChunkSolver::solve);
  module.def(
      "sweep", &sweep, "path"_a, "output"_a, "threads"_a = 0, "executor"_a = py::none(),
      "Solves the cases of a specification file, as `microslip sweep` does, and writes them to an HDF5 file, SI\n"
      "units [-]. What is finished is kept in OUTPUT.checkpoint: after an interruption the same call goes on with "
      "what\n"
      "is missing, and ends at once if nothing is. On threads, 0: one for each processor, or by a "
      "concurrent.futures.Executor, whose workers import\n"
      "microslip and read the files of the specification. The results are the same to the last bit. Returns\n"
      "SweepReport; Error for a wrong specification, another sweep's checkpoint, or an output that cannot be written.");
  module.def(
      "sweep_statistics", &sweep_statistics, "path"_a, "quantities"_a = std::vector<std::string>(),
      "quantiles"_a = campaign::StatisticsOptions().probabilities, "group_by"_a = "",
      "What the cases in the result file of a sweep say of the distributions of their quantities, all or those that\n"
      "are named: a dict as `microslip statistics --json` prints it, SI units [-]. Below each quantity's path, "
      "[\"contact\"][\"fx\"], there are\n"
      "mean, mean_error, standard_deviation, least, largest, quantiles with the ends of their intervals of 95 %, and "
      "of "
      "cases for\n"
      "Sobol's indices sobol_first and sobol_total with their errors: a list with an entry for each group, the values "
      "of "
      "the key\n"
      "group_by, or one. Cases whose status is not ok are left out. Error for another file and names that it lacks.");
}

} // namespace microslip::python
