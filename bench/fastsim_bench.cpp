// Speed of the simplified theory on the 3,220 cases, one core. Every figure is nanoseconds per contact; what counts are
// the ratios within one run, which are printed at the end.

#include "microslip/simplified/fastsim.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "tests/plain_fastsim.hpp"
#include "validation/test_set.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <string>

namespace {

using namespace microslip;

const std::vector<EllipticContact>& contacts() {
  static const std::vector<EllipticContact> all = validation::test_set_contacts();
  return all;
}

SimplifiedOptions grid(int mx, int my) {
  SimplifiedOptions options;
  options.mx = mx;
  options.my = my;
  return options;
}

/// A plain scalar algorithm, contact by contact: scheme as in plain::solve.
void plain_scalar(benchmark::State& state, int scheme, int mx, int my) {
  const SimplifiedOptions options = grid(mx, my);
  for ([[maybe_unused]] auto _ : state)
    for (const EllipticContact& contact : contacts()) benchmark::DoNotOptimize(plain::solve(scheme, options, contact));
  state.SetItemsProcessed(state.iterations() * static_cast<long>(contacts().size()));
}

void batch(benchmark::State& state, RowSolver solver) {
  std::vector<ContactForces> forces(contacts().size());
  for ([[maybe_unused]] auto _ : state) {
    solver.solve(contacts(), forces);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(contacts().size()));
}

void one_by_one(benchmark::State& state, RowSolver solver) {
  for ([[maybe_unused]] auto _ : state)
    for (const EllipticContact& contact : contacts()) benchmark::DoNotOptimize(solver.solve(contact));
  state.SetItemsProcessed(state.iterations() * static_cast<long>(contacts().size()));
}

void derivatives(benchmark::State& state, RowSolver solver) {
  std::vector<ContactDerivatives> results(contacts().size());
  for ([[maybe_unused]] auto _ : state) {
    solver.differentiate(contacts(), results);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(contacts().size()));
}

/// The usual console table, with the medians kept for the ratios.
class Table : public benchmark::ConsoleReporter {
public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      if (run.aggregate_name == "median") median_[run.run_name.function_name] = run.GetAdjustedCPUTime();
  }

  void ratio(const char* what, const char* numerator, const char* denominator, const char* wanted) const {
    const auto over = median_.find(numerator), under = median_.find(denominator);
    if (over == median_.end() || under == median_.end()) return;
    std::printf("%-64s %7.2f   wanted: %s\n", what, over->second / under->second, wanted);
  }
  void nanoseconds(const char* name) const {
    const auto found = median_.find(name);
    if (found == median_.end()) return;
    const double each = found->second / static_cast<double>(contacts().size());
    std::printf("%-64s %7.0f ns per contact, %9.0f contacts per second\n", name, each, 1e9 / each);
  }

private:
  std::map<std::string, double> median_;
};

void register_all() {
  const auto add = [](const std::string& name, auto function, auto... arguments) {
    benchmark::RegisterBenchmark(name.c_str(), function, arguments...)->Repetitions(5)->ReportAggregatesOnly(true);
  };
  add("plain_fastsim_80x20", plain_scalar, 0, 80, 20);
  add("plain_fastsim2_10x10", plain_scalar, 2, 10, 10);
  add("fastsim_80x20_batch", batch, RowSolver(Fastsim(grid(80, 20))));
  add("fastsim2_10x10_batch", batch, RowSolver(Fastsim2(grid(10, 10))));
  SimplifiedOptions single = grid(10, 10);
  single.precision = Precision::single;
  add("fastsim2_10x10_batch_single", batch, RowSolver(Fastsim2(single)));
  add("fastsim2_10x10_one_by_one", one_by_one, RowSolver(Fastsim2(grid(10, 10))));
  add("fastsim2_10x10_derivatives", derivatives, RowSolver(Fastsim2(grid(10, 10))));
  for (const auto& [name, set] :
       {std::pair{"baseline", InstructionSet::baseline}, std::pair{"avx2", InstructionSet::avx2},
        std::pair{"avx512", InstructionSet::avx512}}) {
    if (!is_available(set)) continue;
    SimplifiedOptions options = grid(10, 10);
    options.instruction_set = set;
    add(std::string("fastsim2_10x10_batch_") + name, batch, RowSolver(Fastsim2(options)));
  }
}

} // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  register_all();
  Table table;
  benchmark::RunSpecifiedBenchmarks(&table);
  std::printf("\n");
  for (const char* name : {"plain_fastsim_80x20", "plain_fastsim2_10x10", "fastsim_80x20_batch", "fastsim2_10x10_batch",
                           "fastsim2_10x10_batch_single", "fastsim2_10x10_one_by_one", "fastsim2_10x10_derivatives",
                           "fastsim2_10x10_batch_baseline", "fastsim2_10x10_batch_avx2", "fastsim2_10x10_batch_avx512"})
    table.nanoseconds(name);
  std::printf("\n");
  table.ratio("plain FASTSIM 80 x 20 / FASTSIM2 10 x 10 in a batch", "plain_fastsim_80x20", "fastsim2_10x10_batch",
              ">= 30");
  table.ratio("plain FASTSIM2 10 x 10 / the same in a batch", "plain_fastsim2_10x10", "fastsim2_10x10_batch", ">= 5");
  table.ratio("a batch in single precision / in double", "fastsim2_10x10_batch_single", "fastsim2_10x10_batch",
              "<= 0.5");
  table.ratio("one call alone / in a batch", "fastsim2_10x10_one_by_one", "fastsim2_10x10_batch", "<= 3");
  table.ratio("derivatives / forces", "fastsim2_10x10_derivatives", "fastsim2_10x10_batch", "<= 4");
  return 0;
}
