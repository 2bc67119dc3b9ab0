#include "validation/studies.hpp"

#include "tests/oracles/convex_gauss_seidel.hpp"
#include "tests/oracles/direct_operator.hpp"
#include "validation/clock.hpp"
#include "validation/hertzian_solve.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr std::array grids = {11, 21, 31, 51, 101, 201};
constexpr std::size_t count_of_grids = grids.size();
/// The first grid on which threads are worth while; compared over so many sweeps.
constexpr std::size_t first_parallel = 3;
constexpr int parallel_sweeps = 20;

/// Sequential and parallel times of the paper, on 8 cores of 2.5 GHz; 0 where it has none.
constexpr std::array<double, count_of_grids> paper_sequential = {0, 0, 0, 12, 263, 6806};
constexpr std::array<double, count_of_grids> paper_parallel = {0, 0, 0, 2.6, 40, 932};

constexpr CombinedMaterial steel = {82e9, 0.28, 0};
constexpr double a = 5e-3, b = 25e-3, normal_force = 1.3e-6 * steel.shear_modulus, friction = 0.3;
constexpr double creepage = 0.000857;

struct Cost {
  int elements = 0; ///< in contact
  int sweeps = 0, newton_steps = 0;
  long products = 0;
  double gauss_seidel = 0, newton = 0; ///< [s]
  double speed_up = 0;
  double force = 0, difference = 0; ///< Fx of ConvexGS over mu Fn, and Newton's less it
  bool converged = false, same_with_threads = true;
};

/// Both solvers from no tractions to a residual of 1e-6, with what they need to set up.
Cost measure(int across, int threads) {
  const auto grid = ElementGrid::across_ellipse(a, b, across);
  const HertzContact hertz = hertz_from_ellipse(a, b, steel, normal_force);
  const NormalSolution normal =
      NormalProblem(steel, grid).solve(hertzian_gap(hertz.gap, grid), {NormalLoad::Given::force, normal_force});
  std::vector<double> bound = normal.pressure;
  for (double& g : bound) g *= friction;

  Cost cost;
  cost.elements = normal.contact_elements;
  const double to_force = grid.element_area() / (friction * normal_force);
  const std::vector<double> cx(grid.count(), creepage), cy(grid.count(), 0.0);
  const auto sweep = [&](int most_sweeps, int with_threads) {
    const auto kernel = TangentialKernel::difference(steel, grid, grid.dx);
    DirectOperator response(kernel, with_threads);
    return solve_convex_gauss_seidel({response, bound, cx, cy, grid.element_area()}, kernel,
                                     {.most_sweeps = most_sweeps, .threads = with_threads});
  };
  GaussSeidelSolution swept;
  cost.gauss_seidel = seconds([&] { swept = sweep(5000, 1); });
  cost.sweeps = swept.sweeps;
  cost.force = std::accumulate(swept.traction.x.begin(), swept.traction.x.end(), 0.0) * to_force;
  if (threads > 1) {
    GaussSeidelSolution one, several;
    const double alone = seconds([&] { one = sweep(parallel_sweeps, 1); });
    cost.speed_up = alone / seconds([&] { several = sweep(parallel_sweeps, threads); });
    cost.same_with_threads = several.traction.x == one.traction.x && several.traction.y == one.traction.y;
  }

  TangentialInput input;
  input.creepage.longitudinal = creepage;
  ContactSolution newton;
  cost.newton = seconds([&] { newton = TangentialProblem(steel, grid).solve(bound, input); });
  for (int again = 0; again < 2; ++again) // short times are the shortest of three
    cost.newton = std::min(cost.newton, seconds([&] { newton = TangentialProblem(steel, grid).solve(bound, input); }));
  cost.newton_steps = newton.report.newton_steps;
  cost.products = newton.report.products;
  cost.difference = newton.totals.fx / (friction * normal_force) - cost.force;
  cost.converged = swept.report.status == Status::ok && newton.report.status == Status::ok;
  return cost;
}

std::string published(double seconds) {
  return seconds > 0 ? fmt::format("{:g} s", seconds) : "";
}

void print_costs(Report& report, const std::array<Cost, count_of_grids>& costs) {
  report.line("across elements        Fx  sweeps  a sweep [ms]  total [s]   paper   steps  products  total [s]  ratio");
  for (std::size_t g = 0; g < count_of_grids; ++g) {
    const Cost& c = costs[g];
    report.line(
        fmt::format("{:>6} {:>8}  {:>8.5f}  {:>6}  {:>12.3f}  {:>9.4f}  {:>6}  {:>6}  {:>8}  {:>9.4f}  {:>5.1f}",
                    grids[g], c.elements, c.force, c.sweeps, 1e3 * c.gauss_seidel / c.sweeps, c.gauss_seidel,
                    published(paper_sequential[g]), c.newton_steps, c.products, c.newton, c.gauss_seidel / c.newton));
  }
}

/// Exponent of the number of elements with which a cost grows between two grids.
double exponent(const Cost& coarse, const Cost& fine, double coarse_cost, double fine_cost) {
  return std::log(fine_cost / coarse_cost) / std::log(double(fine.elements) / coarse.elements);
}

void print_growth(Report& report, const std::array<Cost, count_of_grids>& costs) {
  const Cost &first = costs[1], &fifty = costs[3], &last = costs.back();
  const double sweeps = exponent(first, last, first.sweeps, last.sweeps);
  report.figure("ConvexGS, sweeps from 21 to 201", fmt::format("{:.2f}", sweeps), "0.3 +- 0.2",
                std::abs(sweeps - 0.3) <= 0.2);
  const auto times = [&](double Cost::*time) {
    return fmt::format("{:.2f}", exponent(fifty, last, fifty.*time, last.*time));
  };
  report.remark("ConvexGS, time from 51 to 201", times(&Cost::gauss_seidel),
                fmt::format("{:.2f}", exponent(fifty, last, paper_sequential[3], paper_sequential.back())),
                "not judged");
  report.remark("Newton, time from 51 to 201", times(&Cost::newton), "", "not judged");
}

void print_threads(Report& report, const std::array<Cost, count_of_grids>& costs, int threads) {
  if (threads < 2) return;
  report.heading(
      fmt::format("{} sweeps of ConvexGS on {} threads; the paper's speed-up on 8 cores", parallel_sweeps, threads));
  for (std::size_t g = first_parallel; g < count_of_grids; ++g)
    report.remark(fmt::format("speed-up at {}", grids[g]), fmt::format("{:.2f}", costs[g].speed_up),
                  fmt::format("{:.1f}", paper_sequential[g] / paper_parallel[g]), "not judged");
  const bool same = std::all_of(costs.begin(), costs.end(), [](const Cost& c) { return c.same_with_threads; });
  report.figure("tractions with more threads", same ? "the same" : "differ", "the same", same);
}

} // namespace

bool run_solver_growth(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  report.line("a = 5 mm, a/b = 0.2, Fn/G = 1.3 mm2, mu = 0.3, nu = 0.28, xi = 0.000857, steady rolling with dq = dx");
  std::array<Cost, count_of_grids> costs;
  double work = 0, done = 0;
  const auto work_of = [](int across) { return std::pow(across, 4.6); };
  for (const int across : grids) work += work_of(across);
  for (std::size_t g = 0; g < count_of_grids; ++g) {
    costs[g] = measure(grids[g], g >= first_parallel ? options.threads : 1);
    done += work_of(grids[g]);
    if (options.progress && !options.progress(done / work)) return false;
  }
  report.heading("ConvexGS on one thread, Newton's method beside it, and the paper's Table 1");
  print_costs(report, costs);
  bool converged = true;
  double difference = 0;
  for (const Cost& c : costs) {
    converged = converged && c.converged;
    difference = std::max(difference, std::abs(c.difference));
  }
  report.figure("both converge", converged ? "all" : "not all", "all", converged);
  report.bounded("largest difference of Fx", "{:.1e}", difference, "<= 1e-6");
  report.heading("Growth with the number of elements, as an exponent; the paper's");
  print_growth(report, costs);
  print_threads(report, costs, options.threads);
  return report.all_as_stated();
}

} // namespace microslip::validation
