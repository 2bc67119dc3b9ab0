#include "validation/studies.hpp"

#include "microslip/elasticity/influence.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/fitted/edge_element.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "validation/error_statistics.hpp"
#include "validation/exact_cases.hpp"
#include "validation/hertzian_solve.hpp"
#include "validation/reference_112.hpp"
#include "validation/report.hpp"
#include "validation/rolling_orders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

using std::numbers::pi;
using Field = std::vector<double>;

constexpr CombinedMaterial steel = {82e9, 0.28, 0};

// Figure 1: order

constexpr std::array order_grids = {8, 12, 16, 24, 32, 48, 64, 96};

/// A line contact of the half-width 1 with a leading element fitted to the edge; slip as in FittedOperator, dense.
class FittedLine : public SlipOperator {
public:
  explicit FittedLine(int n) : h_(2.0 / n) {
    // A whole element from the edge is within the range of distances for every n.
    const double rear = 1 - h_;
    for (int i = 0; i < n; ++i) left_.push_back(-1 + i * h_);
    left_.push_back(rear + leading_element_width(1) * h_);
  }

  std::size_t size() const { return left_.size() - 1; }
  double width(std::size_t i) const { return left_[i + 1] - left_[i]; }
  double element() const { return h_; }

  /// The mean of sqrt(1 - x^2) over the area that each element stands for.
  Field bound() const {
    const auto integral = [](double x) { return (x * std::sqrt(1 - x * x) + std::asin(x)) / 2; };
    Field mean(size());
    for (std::size_t i = 0; i < size(); ++i)
      mean[i] = (integral(i + 1 < size() ? left_[i + 1] : 1) - integral(left_[i])) / width(i);
    return mean;
  }

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override {
    ++products_;
    for (std::size_t i = 0; i < size(); ++i) {
      sx[i] = sy[i] = 0;
      for (std::size_t j = 0; j < size(); ++j) {
        const Influence a = growth(i, j);
        sx[i] += a.xx * px[j];
        sy[i] += a.yy * py[j];
      }
    }
  }
  double diagonal() const override {
    const Influence a = growth(0, 0);
    return (a.xx + a.yy) / 2;
  }
  long products() const override { return products_; }

private:
  double centre(std::size_t i) const { return (left_[i] + left_[i + 1]) / 2; }

  Influence growth(std::size_t i, std::size_t j) const {
    const double x = centre(i), end = i + 1 < size() ? centre(i + 1) : left_.back() + h_ / 2;
    const Influence here = line_influence(steel, width(j), x - centre(j), 1);
    const Influence there = line_influence(steel, width(j), end - centre(j), 1);
    return {(here.xx - there.xx) / (end - x), 0, (here.yy - there.yy) / (end - x), 0, 0, 0};
  }

  double h_;
  Field left_;
  long products_ = 0;
};

/// Carter: the adhesion area has the half-width alpha, the force is 1 - alpha^2 of the bound's integral pi/2. Its error
/// over that integral.
double carter_error(int n, double alpha) {
  FittedLine line(n);
  const Field bound = line.bound();
  // Carter's tractions, whose bound is sqrt(1 - x^2) here, make displacements grow at this rate where they adhere.
  const double creepage = 2 * (1 - steel.poisson_ratio) / steel.shear_modulus * (1 - alpha);
  const Field cx(line.size(), creepage), cy(line.size(), 0.0);
  const FrictionProblem problem{
      .slip_operator = line, .bound = bound, .cx = cx, .cy = cy, .element_area = line.element()};
  FrictionNewton newton;
  const FrictionSolution s = newton.solve(problem, {.tolerance = 1e-10});
  if (s.report.status != Status::ok) throw Error("Carter's problem: not converged");
  double force = 0;
  for (std::size_t i = 0; i < line.size(); ++i) force -= s.traction.x[i] * line.width(i);
  return force / (pi / 2) - (1 - alpha * alpha);
}

/// -Fx/(mu Fn) in the test of the refinement paper at a creepage.
double paper_force(int n, double creepage) {
  constexpr double friction = 0.3;
  EllipticContact contact;
  contact.a = 5e-3;
  contact.b = 25e-3;
  contact.shear_modulus = steel.shear_modulus;
  contact.poisson_ratio = steel.poisson_ratio;
  contact.normal_force = 1.3e-6 * steel.shear_modulus;
  contact.friction = FrictionLaw::coulomb(friction);
  contact.creepage.longitudinal = creepage;
  const ContactSolution s = Solver({.mx = n, .my = n, .tolerance = 1e-8}).solve(rolling_problem(contact));
  if (s.report.status != Status::ok) throw Error("the refinement paper's test: not converged");
  return -s.totals.fx / (friction * contact.normal_force);
}

/// Prints errors on order_grids and their ratios from n to 2 n elements, and judges the mean order from the first to
/// the last grid.
void report_order(Report& report, const std::string& name, const std::array<double, order_grids.size()>& errors) {
  std::string values, ratios;
  for (std::size_t g = 0; g < order_grids.size(); ++g) {
    values += fmt::format("{:>10.1e}", errors[g]);
    const auto half = std::find(order_grids.begin(), order_grids.end(), order_grids[g] / 2);
    ratios += half == order_grids.end() ? fmt::format("{:>10}", "")
                                        : fmt::format("{:>10.2f}", errors[half - order_grids.begin()] / errors[g]);
  }
  report.line(fmt::format("{:<18}{}", name, values));
  report.line(fmt::format("{:<18}{}", "  from half of it", ratios));
  const double order =
      std::log(errors.front() / errors.back()) / std::log(double(order_grids.back()) / order_grids.front());
  report.bounded("  mean order, 8 to 96", "{:.2f}", order, ">= 1.8");
}

/// Root mean square over several cases, from error(n, case): where the edge of slip lies within its element changes an
/// error of second order up to its sign.
template <class Cases, class ErrorOf>
std::array<double, order_grids.size()> mean_errors(const Cases& cases, const ErrorOf& error) {
  std::array<double, order_grids.size()> mean{};
  for (std::size_t g = 0; g < order_grids.size(); ++g) {
    for (const auto& each : cases) mean[g] += std::pow(error(order_grids[g], each), 2) / double(std::size(cases));
    mean[g] = std::sqrt(mean[g]);
  }
  return mean;
}

/// A creepage of the refinement paper's test, and the force that it has in the limit.
struct PaperCase {
  double creepage, force;
};

PaperCase paper_case(double creepage) {
  return {creepage, limit(paper_force(96, creepage), 96, paper_force(192, creepage), 192, 2)};
}

void report_orders(Report& report) {
  std::string heads;
  for (const int n : order_grids) heads += fmt::format("{:>10}", n);
  report.heading("Order: errors of Fx over mu Fn, elements across");
  report.line(fmt::format("{:<18}{}", "", heads));
  report_order(report, "Carter, alpha 0.5", mean_errors(std::array{0.5}, carter_error));
  report_order(report, "Carter, rms of 9",
               mean_errors(std::array{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}, carter_error));
  const auto error = [](int n, const PaperCase& c) { return paper_force(n, c.creepage) - c.force; };
  const PaperCase printed = paper_case(0.000857);
  report_order(report, "paper's test", mean_errors(std::array{printed}, error));
  report_order(report, "same, rms of 4",
               mean_errors(std::array{paper_case(0.0003), paper_case(0.0006), printed, paper_case(0.0012)}, error));
  report.near("-Fx/(mu Fn), extrapolated from 96 and 192", "{:.5f}", printed.force, "0.7128", 5e-4);
}

// Figure 2: accuracy

using Results = std::vector<RelativeForces>;

/// From half the elements and all.
Results extrapolated(const Results& coarse, const Results& fine) {
  Results limits;
  for (std::size_t i = 0; i < coarse.size(); ++i) limits.push_back(limit_of_second_order(coarse[i], fine[i]));
  return limits;
}

std::array<double, 3> rms(const Results& results, const Results& reference) {
  std::array<double, 3> values{};
  const std::array components = {&RelativeForces::fx, &RelativeForces::fy, &RelativeForces::mz};
  for (std::size_t c = 0; c < 3; ++c) {
    auto e = differences(results, reference, components[c]);
    values[c] = statistics(e).rms;
  }
  return values;
}

constexpr std::array accuracy_grids = {8, 12, 16, 24, 48, 96};
/// Work on a grid, in that on the finest.
double work(int n) {
  return std::pow(n / 96.0, 2.5);
}

/// Results on accuracy_grids, of the contacts that slide in part.
struct Solved {
  std::vector<Results> on;
  int failures = 0;
};

/// Leaves those that slide in part in `cases`.
std::optional<Solved> solve_all(std::vector<Reference112>& cases, const StudyOptions& options) {
  std::vector<EllipticContact> contacts;
  contacts.reserve(cases.size());
  for (const Reference112& c : cases) contacts.push_back(c.contact);
  std::vector<std::vector<ExactCase>> all;
  double total = 0, done = 0;
  for (const int n : accuracy_grids) total += work(n);
  for (const int n : accuracy_grids) {
    StudyOptions part = options;
    part.progress = part_of(options.progress, done / total, (done + work(n)) / total);
    done += work(n);
    all.push_back(solve_exactly(contacts, {.n = n, .discretisation = Discretisation::second_order}, part));
    if (all.back().empty()) return std::nullopt;
  }
  Solved solved;
  for (const auto& on_grid : all)
    for (const ExactCase& c : on_grid) solved.failures += c.forces.status != Status::ok;
  std::vector<Reference112> partial;
  solved.on.resize(accuracy_grids.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!slides_in_part(all.back()[i].forces, contacts[i])) continue;
    partial.push_back(cases[i]);
    for (std::size_t g = 0; g < accuracy_grids.size(); ++g)
      solved.on[g].push_back(relative(all[g][i].forces, contacts[i]));
  }
  cases = partial;
  return solved;
}

void report_rms(Report& report, const std::string& name, const Results& results, const Results& own_limit,
                const Results& published) {
  const auto own = rms(results, own_limit), other = rms(results, published);
  report.line(fmt::format("{:<10}{:>12.5f}{:>10.5f}{:>10.5f}{:>12.5f}{:>10.5f}{:>10.5f}", name, own[0], own[1], own[2],
                          other[0], other[1], other[2]));
}

void report_wanted(Report& report, const std::string& name, const Results& results, const Results& own_limit,
                   double wanted_fx, double wanted_fy) {
  const auto own = rms(results, own_limit);
  report.bounded(name + ", rms of Fx", "{:.5f}", own[0], fmt::format("<= {}", wanted_fx));
  report.bounded(name + ", rms of Fy", "{:.5f}", own[1], fmt::format("<= {}", wanted_fy));
}

void report_accuracy(Report& report, const Solved& solved, const std::vector<Reference112>& cases) {
  Results published;
  for (const Reference112& c : cases) published.push_back(c.limit);
  const auto on = [&](int n) -> const Results& {
    return solved.on[std::find(accuracy_grids.begin(), accuracy_grids.end(), n) - accuracy_grids.begin()];
  };
  const auto both = [&](int n) { return extrapolated(on(n), on(2 * n)); };
  const Results own_limit = both(48);
  report.heading(
      fmt::format("{} partial-slip cases of the 112: rms of Fx, Fy over mu Fn, Mz over mu Fn sqrt(a b)", cases.size()));
  report.line(
      fmt::format("{:<10}{:>32}{:>32}", "elements", "against 48 + 96 extrapolated", "against CONTACT's 31 + 63"));
  report.line(fmt::format("{:<10}{:>12}{:>10}{:>10}{:>12}{:>10}{:>10}", "", "Fx", "Fy", "Mz", "Fx", "Fy", "Mz"));
  for (const int n : accuracy_grids) report_rms(report, std::to_string(n), on(n), own_limit, published);
  for (const int n : {8, 12, 24, 48})
    report_rms(report, fmt::format("{} + {}", n, 2 * n), both(n), own_limit, published);
  report.count("cases that do not converge, of 112 on each grid", solved.failures, 0);
  report_wanted(report, "24 x 24", on(24), own_limit, 0.0005, 0.002);
  report_wanted(report, "extrapolated from 12 and 24", both(12), own_limit, 0.0003, 0.0007);
  report_wanted(report, "extrapolated from 8 and 16", both(8), own_limit, 0.0005, 0.0015);
}

/// Forces to an accuracy: the estimate of the error over the true one, the largest of the three components'.
void report_estimates(Report& report, double accuracy, const Solved& solved, const std::vector<Reference112>& cases) {
  AccurateContactSolver solver({.accuracy = accuracy});
  const Results true_limit = extrapolated(solved.on[accuracy_grids.size() - 2], solved.on.back());
  double least = HUGE_VAL, elements = 0;
  int above = 0;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const AccurateContact s = solver.solve(rolling_problem(cases[i].contact));
    const RelativeForces f = relative(s.forces, cases[i].contact), &t = true_limit[i];
    const double error = std::max({std::abs(f.fx - t.fx), std::abs(f.fy - t.fy), std::abs(f.mz - t.mz)});
    ratios.push_back(s.error / error);
    least = std::min(least, ratios.back());
    above += error > accuracy;
    elements += s.elements / double(cases.size());
  }
  std::sort(ratios.begin(), ratios.end());
  report.figure(fmt::format("accuracy {}: {:.0f} elements across on average, estimate over error: median {:.1f}, least",
                            accuracy, elements, ratios[ratios.size() / 2]),
                fmt::format("{:.2f}", least), ">= 0.33", least >= 1.0 / 3);
  report.count(fmt::format("accuracy {}: cases with a larger error", accuracy), above, 0);
}

} // namespace

bool run_second_order(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  report_orders(report);
  report_rolling_orders(report);
  std::vector<Reference112> cases = read_reference_112();
  if (cases.empty()) {
    report.line(reference_112_skipped);
    return report.all_as_stated();
  }
  const auto solved = solve_all(cases, options);
  if (!solved) return false;
  report_accuracy(report, *solved, cases);
  report.heading("The same cases to an accuracy, with an estimate of the error");
  for (const double accuracy : {1e-2, 1e-3}) report_estimates(report, accuracy, *solved, cases);
  return report.all_as_stated();
}

} // namespace microslip::validation
