#include "validation/studies.hpp"

#include "io/output_file.hpp"
#include "io/result_file.hpp"
#include "microslip/simplified/model_problem.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

using Cases = std::array<ModelCase, 3>;

struct Strategy {
  std::string_view name;
  std::string_view group; ///< in the result file
  ModelSolution (*solve)(const ModelProblem& problem, int mx);
};

constexpr std::array strategies = {
    Strategy{"backward Euler", "backward_euler", solve_backward_euler},
    Strategy{"theta method, 0.7", "theta_method_0.7",
             [](const ModelProblem& problem, int mx) { return solve_theta_method(problem, mx, 0.7); }},
    Strategy{"theta method, 0.5", "theta_method",
             [](const ModelProblem& problem, int mx) { return solve_theta_method(problem, mx, 0.5); }},
    Strategy{"tracked boundaries, 0.5", "tracked",
             [](const ModelProblem& problem, int mx) { return solve_tracked(problem, mx, 0.5); }},
};
constexpr const Strategy& backward_euler = strategies[0];
constexpr const Strategy& trapezoidal = strategies[2];
constexpr const Strategy& tracked = strategies[3];

constexpr std::array grids = {10, 20, 40, 80, 160, 320, 640};
/// An error depends on where the transitions lie in their steps; the largest one of ten grids does so less.
constexpr int neighbours = 10;

/// The first of them that resolves the elliptic bound near its edges.
constexpr std::size_t fine = 3;

using Series = std::array<double, grids.size()>;

double displacement_error(const ModelCase& model, const ModelSolution& solution) {
  double error = 0;
  for (std::size_t i = 0; i < solution.x.size(); ++i)
    error = std::max(error, std::abs(solution.displacement[i] - model.displacement(solution.x[i])));
  return error;
}

/// Over x <= last: at x = 1 under the elliptic bound the exact slip is infinite.
double slip_error(const ModelCase& model, const ModelSolution& solution, double last) {
  double error = 0;
  for (std::size_t i = 0; i < solution.x.size() && solution.x[i] <= last; ++i)
    error = std::max(error, std::abs(solution.slip[i] - model.slip(solution.x[i])));
  return error;
}

/// Infinite if the number of transitions is wrong.
double transition_error(const ModelCase& model, const ModelSolution& solution) {
  const std::vector<double> exact = model.transitions();
  if (exact.size() != solution.transitions.size()) return std::numeric_limits<double>::infinity();
  double error = 0;
  for (std::size_t k = 0; k < exact.size(); ++k) error = std::max(error, std::abs(solution.transitions[k] - exact[k]));
  return error;
}

/// error(mx), the largest of `neighbours` grids from each of `grids` on.
template <class Error> Series largest(const Error& error) {
  Series series{};
  for (std::size_t n = 0; n < grids.size(); ++n)
    for (int mx = grids[n]; mx < grids[n] + neighbours; ++mx) series[n] = std::max(series[n], error(mx));
  return series;
}

Series displacement_errors(const ModelCase& model, const Strategy& strategy) {
  return largest([&](int mx) { return displacement_error(model, strategy.solve(model.problem(), mx)); });
}

Series slip_errors(const ModelCase& model, const Strategy& strategy) {
  return largest([&](int mx) { return slip_error(model, strategy.solve(model.problem(), mx), 0.9); });
}

/// Mean order of convergence from one of `grids` on.
double mean_order(const Series& errors, std::size_t first = 0) {
  return std::log2(errors[first] / errors.back()) / double(grids.size() - 1 - first);
}

std::string grid_row() {
  std::string text = fmt::format("{:<34}", "n");
  for (const int mx : grids) text += fmt::format(" {:>8}", mx);
  return text + fmt::format("   order from {} and {}", grids[0], grids[fine]);
}

std::string row(std::string_view name, const Series& errors) {
  std::string text = fmt::format("{:<34}", name);
  for (const double error : errors) text += fmt::format(" {:>8.1e}", error);
  return text;
}

std::string row_with_orders(std::string_view name, const Series& errors) {
  return row(name, errors) + fmt::format("   {:.2f}  {:.2f}", mean_order(errors), mean_order(errors, fine));
}

/// Integral of u over a stretch of adhesion: the trapezoidal rule through the grid points inside and its ends.
double adhesion_integral(const ModelSolution& solution, double begin, double u_begin, double end, double u_end) {
  double sum = 0;
  const auto add = [&](double x, double u) {
    sum += 0.5 * (x - begin) * (u + u_begin);
    begin = x;
    u_begin = u;
  };
  for (std::size_t i = 0; i < solution.x.size(); ++i)
    if (begin < solution.x[i] && solution.x[i] < end) add(solution.x[i], solution.displacement[i]);
  add(end, u_end);
  return sum;
}

/// Integral of the elliptic bound from 0 to x.
double bound_integral(double x) {
  const double phi = std::acos(1 - 2 * x);
  return phi / 4 - std::sin(2 * phi) / 8;
}

/// Integral of the third case's exact solution; that of -w is 3x^2 - 7x^3/3.
double exact_integral(const ModelCase& model) {
  const auto adhesion = [](double offset, double x) { return x * (offset + x * (3 - x * 7 / 3)); };
  const auto& pieces = model.pieces();
  const double t1 = pieces[0].end, t2 = pieces[1].end, t3 = pieces[2].end, offset = pieces[2].offset;
  return adhesion(0, t1) + bound_integral(t2) - bound_integral(t1) + adhesion(offset, t3) - adhesion(offset, t2) -
         bound_integral(1) + bound_integral(t3);
}

/// Of the third case: trapezoidal rule in adhesion, the bound's integral in slip.
double integral_error(const ModelCase& model, const ModelSolution& solution) {
  if (solution.transitions.size() != 3) return std::numeric_limits<double>::infinity();
  const auto& bound = model.problem().bound;
  const double t1 = solution.transitions[0], t2 = solution.transitions[1], t3 = solution.transitions[2];
  const double integral = adhesion_integral(solution, 0, 0, t1, bound(t1)) + bound_integral(t2) - bound_integral(t1) +
                          adhesion_integral(solution, t2, bound(t2), t3, -bound(t3)) - bound_integral(1) +
                          bound_integral(t3);
  return std::abs(integral - exact_integral(model));
}

void report_exact_solutions(const Cases& cases, Report& report) {
  struct Published {
    std::string_view name;
    double computed, printed;
  };
  const auto &one = cases[0].pieces(), &two = cases[1].pieces(), &three = cases[2].pieces();
  const Published figures[] = {
      {"case 1, adhesion to slip (F22)", one[0].end, 0.39},
      {"case 2, slip to adhesion (F25)", two[0].end, 1.0 / 3},
      {"case 2, adhesion to slip (F25)", two[1].end, 0.8744},
      {"case 3, adhesion to slip (F27)", three[0].end, 0.1355},
      {"case 3, slip to adhesion (F27)", three[1].end, 0.3992},
  };
  report.heading("Transition points of the exact solutions: computed, published");
  for (const auto& [name, computed, printed] : figures)
    report.near(name, "{:.8f}", computed, "{:.4f}", printed, 0.5e-4);

  // The printed constant breaks the continuity of u, and the last transition follows from it.
  const double x = three[1].end, jump = three[2].offset + 0.3203;
  report.remark("case 3, constant of the second adhesion area (F27)", fmt::format("{:.8f}", three[2].offset), "-0.3203",
                fmt::format("not judged, a misprint: u would jump by {:.4f} at {:.4f}", jump, x));
  report.remark("case 3, adhesion to slip (F27)", fmt::format("{:.8f}", three[2].end), "0.9011",
                "not judged, follows from that constant");

  // Without any of the algebra above.
  const double last = backward_euler.solve(cases[2].problem(), 100'000).transitions.back();
  report.near("case 3, the same by backward Euler, 100,000 points", "{:.8f}", last, "{:.4f}", three[2].end, 0.5e-4);
}

void report_parabolic_bound(const Cases& cases, Report& report) {
  report.heading("Tracked boundaries, theta = 1/2, parabolic bound: largest error at the grid points");
  for (int k = 0; k < 2; ++k)
    for (const int mx : {5, 10, 17, 40, 100}) {
      const ModelSolution solution = tracked.solve(cases[k].problem(), mx);
      const double u = displacement_error(cases[k], solution), s = slip_error(cases[k], solution, 1);
      report.bounded(fmt::format("case {}, {} points, u", k + 1, mx), "{:.1e}", u, "<= 1e-12");
      report.bounded(fmt::format("case {}, {} points, s", k + 1, mx), "{:.1e}", s, "<= 1e-12");
    }
}

void report_elliptic_bound(const ModelCase& model, Report& report) {
  const auto errors = [&](double (*error)(const ModelCase&, const ModelSolution&)) {
    return largest([&](int mx) { return error(model, tracked.solve(model.problem(), mx)); });
  };
  const Series u = displacement_errors(model, tracked), integral = errors(integral_error),
               s = slip_errors(model, tracked), transitions = errors(transition_error);
  report.heading(fmt::format("Tracked boundaries, theta = 1/2, case 3: largest error of the grids from n to n + {}",
                             neighbours - 1));
  report.line(grid_row());
  report.line(row_with_orders("u at the grid points", u));
  report.line(row_with_orders("integral of u", integral));
  report.line(row_with_orders("s at the grid points, x <= 0.9", s));
  report.line(row_with_orders("transition points", transitions));
  report.figure("mean order of u at the grid points, from 10", fmt::format("{:.2f}", mean_order(u)), "at least 2",
                mean_order(u) >= 1.9);
  report.near("mean order of the integral of u, from 10", "{:.2f}", mean_order(integral), "2", 0.1);
}

void report_other_strategies(const Cases& cases, Report& report) {
  report.heading(
      fmt::format("The other strategies: largest error of u, and of s up to x = 0.9, of the grids from n to n + {}",
                  neighbours - 1));
  report.line(grid_row());
  for (int k = 0; k < 3; ++k)
    for (const Strategy& strategy : strategies) {
      if (&strategy == &tracked) continue;
      const Series u = displacement_errors(cases[k], strategy);
      const auto name = fmt::format("case {}, {}: u", k + 1, strategy.name);
      report.line(u.back() <= 1e-12 ? row(name, u) + "   exact" : row_with_orders(name, u));
      report.line(row(fmt::format("case {}, {}: s", k + 1, strategy.name), slip_errors(cases[k], strategy)));
    }
  for (int k = 0; k < 3; ++k) {
    const double order = mean_order(displacement_errors(cases[k], backward_euler));
    report.near(fmt::format("case {}, backward Euler, mean order of u", k + 1), "{:.2f}", order, "1", 0.1);
  }
  const Series u = displacement_errors(cases[0], trapezoidal);
  const double largest_error = *std::max_element(u.begin(), u.end());
  report.figure("case 1, theta method, 0.5: u", fmt::format("{:.1e}", largest_error), "exact", largest_error <= 1e-12);
}

/// The exact solution on a fine grid that has its transition points too.
void write_exact(const ModelCase& model, const std::string& group, io::ResultFile& file) {
  std::vector<double> x = model.transitions();
  for (const double transition : model.transitions()) x.push_back(std::nextafter(transition, 1));
  for (int i = 0; i <= 400; ++i) x.push_back(i / 400.0);
  std::sort(x.begin(), x.end());
  std::vector<double> u, s, bound;
  for (const double point : x) {
    u.push_back(model.displacement(point));
    s.push_back(model.slip(point));
    bound.push_back(model.problem().bound(point));
  }
  file.array(group + "/x_exact", x, "-", "positions, from the leading edge");
  file.array(group + "/u_exact", u, "-", "exact displacement difference");
  file.array(group + "/s_exact", s, "-", "exact slip");
  file.array(group + "/u_max", bound, "-", "bound on |u|");
}

void write_strategy(const ModelCase& model, const Strategy& strategy, const std::string& group, io::ResultFile& file) {
  const ModelSolution solution = strategy.solve(model.problem(), grids[0]);
  const auto name = fmt::format("{}/{}/", group, strategy.group);
  file.array(name + "x", solution.x, "-", "grid points");
  file.array(name + "u", solution.displacement, "-", "computed displacement difference");
  file.array(name + "s", solution.slip, "-", "computed slip");
  file.array(name + "error_u", displacement_errors(model, strategy), "-",
             "largest error of u at the grid points, of the grids from n to n + 9");
  file.array(name + "error_s", slip_errors(model, strategy), "-",
             "largest error of s at the grid points up to x = 0.9, of the grids from n to n + 9");
}

std::filesystem::path write_result(const Cases& cases, const StudyOptions& options) {
  io::create_folder(options.output);
  auto path = options.output / "model_problem.h5";
  io::ResultFile file(path, {.kind = "model-problem",
                             .title = "1-D model problem of the FASTSIM2 paper",
                             .command_line = "microslip validate model-problem"});
  file.array("/grids", std::span<const int>(grids), "-", "n: steps of the grids");
  for (int k = 0; k < 3; ++k) {
    const auto group = fmt::format("/case{}", k + 1);
    write_exact(cases[k], group, file);
    for (const Strategy& strategy : strategies) write_strategy(cases[k], strategy, group, file);
  }
  file.commit();
  return path;
}

} // namespace

bool run_model_problem(const StudyOptions& options, std::ostream& out) {
  io::require_writable_folder(options.output);
  const Cases cases = model_cases();
  Report report(out, options.figures);
  report_exact_solutions(cases, report);
  report_parabolic_bound(cases, report);
  report_elliptic_bound(cases[2], report);
  report_other_strategies(cases, report);
  report.line(fmt::format("written: {}", write_result(cases, options).string()));
  return report.all_as_stated();
}

} // namespace microslip::validation
