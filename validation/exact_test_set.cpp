#include "validation/studies.hpp"

#include "validation/exact_cases.hpp"
#include "validation/report.hpp"
#include "validation/test_set.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <string>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

enum class Solver { classical_from_nothing, classical, second_order };

struct Run {
  int elements;
  Solver solver;
  double work_until; ///< share of the study's work up to its end
};
constexpr Run runs[] = {
    {12, Solver::second_order, 0.005}, {12, Solver::classical, 0.01}, {12, Solver::classical_from_nothing, 0.015},
    {24, Solver::second_order, 0.03},  {24, Solver::classical, 0.06}, {24, Solver::classical_from_nothing, 0.1},
    {48, Solver::second_order, 0.2},   {48, Solver::classical, 0.45}, {48, Solver::classical_from_nothing, 1}};

const char* describe(Solver solver) {
  constexpr const char* texts[] = {"classical, from no tractions", "classical, from FASTSIM2's tractions",
                                   "second order, from FASTSIM2's tractions"};
  return texts[static_cast<int>(solver)];
}

std::vector<ExactCase> solve(const std::vector<EllipticContact>& contacts, const Run& run,
                             const StudyOptions& options) {
  return solve_exactly(
      contacts,
      {.n = run.elements,
       .discretisation = run.solver == Solver::second_order ? Discretisation::second_order : Discretisation::classical,
       .start = run.solver == Solver::classical_from_nothing ? Start::no_tractions : Start::fastsim2},
      options);
}

std::string distribution(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(std::ceil(share * double(values.size()))) - 1];
  };
  return fmt::format("mean {:.1f}, 95 % {:.0f}, largest {:.0f}", mean, at(0.95), values.back());
}

void report_run(Report& report, const Run& run, const std::vector<ExactCase>& cases, double seconds, int threads) {
  std::vector<double> steps, products;
  double worst = 0;
  int failures = 0;
  for (const ExactCase& c : cases) {
    steps.push_back(c.newton_steps);
    products.push_back(double(c.products));
    worst = std::max(worst, c.residual);
    if (c.forces.status != Status::ok) ++failures;
  }
  report.heading(fmt::format("{0} x {0} elements across the ellipse, {1}", run.elements, describe(run.solver)));
  report.count("cases that do not converge", failures, 0);
  report.bounded("largest residual", "{:.3e}", worst, "<= 1e-6");
  report.line("Newton steps: " + distribution(steps));
  report.line("products:     " + distribution(products));
  report.line(fmt::format("time:         {:.1f} s on {} thread{}, {:.2f} ms of a thread for a case", seconds, threads,
                          threads == 1 ? "" : "s", 1e3 * seconds * threads / double(cases.size())));
}

} // namespace

bool run_exact_test_set(const StudyOptions& options, std::ostream& out) {
  const std::vector<EllipticContact> contacts = test_set_contacts();
  Report report(out, options.figures);
  report.line(fmt::format("{} cases, to a residual of 1e-6", contacts.size()));
  double begin = 0;
  for (const Run& run : runs) {
    StudyOptions part = options;
    part.progress = part_of(options.progress, begin, run.work_until);
    begin = run.work_until;
    const auto start = std::chrono::steady_clock::now();
    const std::vector<ExactCase> cases = solve(contacts, run, part);
    if (cases.empty()) return false;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    report_run(report, run, cases, wall.count(), options.threads);
  }
  return report.all_as_stated();
}

} // namespace microslip::validation
