#include "validation/layered_cost.hpp"

#include "microslip/rolling/solver.hpp"

#include <ctime>
#include <limits>
#include <tuple>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr double a = 1e-3, radius = 0.1; // of the contact, about, and of the ball [m]
const Material steel = {82e9, 0.28}, hard = {820e9, 0.25}, soft = {16e9, 0.35}, rubber = {1e6, 0.45},
               incompressible = {1e6, 0.5};
const ViscoelasticMaterial rigid = {{std::numeric_limits<double>::infinity(), 0}};
const LayeredBody steel_body = {{}, {steel}};

/// A steel ball on a layered body, with creepages and spin so that half of the contact slips.
RollingProblem ball_on(const LayeredBody& body) {
  constexpr double creepage = 0.15 * a / radius;
  RollingProblem p;
  p.layered = LayeredBodies{steel_body, body};
  p.geometry = GapFormula{ElementGrid::across_ellipse(1.15 * a, 1.15 * a, 48),
                          [](double x, double y) { return (x * x + y * y) / (2 * radius); }};
  p.load = {NormalLoad::Given::approach, 0.6 * a * a / radius};
  p.friction.law = FrictionLaw::coulomb(0.3);
  p.motion.creepage = {creepage, -0.5 * creepage, 0.3 * creepage / a};
  return p;
}

SolverReport report_of(const LayeredBody& body) {
  return Solver({.theory = Theory::exact}).solve(ball_on(body)).report;
}

void report_products(Report& report) {
  report.heading("Steady rolling of a ball on 48 x 48 elements, over those of half-spaces of rubber and steel");
  const double half_spaces = static_cast<double>(report_of({{}, {rubber}}).products);
  const std::tuple<const char*, Material, ViscoelasticMaterial, double> covers[] = {
      {"rubber on steel", rubber, {steel}, 1.2},
      {"rubber on a rigid core", rubber, rigid, 1.2},
      {"a fifth of steel on it", soft, {steel}, 1.2},
      {"ten times steel on it", hard, {steel}, 1.4},
      {"nu = 1/2 on a rigid core", incompressible, rigid, 3},
  };
  for (const auto& [name, layer, below, bound] : covers)
    for (const double h : {0.01 * a, 0.1 * a, a, 10 * a}) {
      const SolverReport found = report_of({{{h, {layer}}}, below});
      if (found.status != Status::ok) report.figure("  status", to_string(found.status), "ok", false);
      report.bounded(fmt::format("products, {}, h = {} a", name, h / a), "{:.2f}",
                     static_cast<double>(found.products) / half_spaces, fmt::format("<= {}", bound));
    }
}

/// Processor time of some work [ms].
template <class Work> double milliseconds(Work work) {
  const std::clock_t start = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Times of the first solve with a body and of the next ones with other loads or creepages [ms].
void report_times(Report& report, const char* name, const LayeredBody& body, double transverse_curvature) {
  RollingProblem p = ball_on(body);
  p.geometry = GapCurvatures{0.5 / radius, transverse_curvature};
  p.layered->speed = p.motion.rolling_speed;
  const double force = transverse_curvature == 0 ? 2000 : 20;
  if (transverse_curvature == 0) p.motion.creepage.spin = 0;
  Solver solver({.theory = Theory::exact, .mx = 48, .my = 48});
  const auto solve = [&](double load, double creepage) {
    p.load = {NormalLoad::Given::force, load};
    p.motion.creepage.longitudinal = creepage;
    return milliseconds([&] { solver.solve(p); });
  };
  const double first = solve(force, 0.01);
  double by_load = 0, by_creepage = 0;
  for (const double share : {1.1, 1.3, 1.6, 2.0}) by_load += solve(share * force, 0.01) / 4;
  for (const double creepage : {0.002, 0.005, 0.02, 0.03}) by_creepage += solve(2 * force, creepage) / 4;
  report.line(fmt::format("  {:30} the first {:5.1f} ms, another load {:4.1f} ms, another creepage {:4.1f} ms", name,
                          first, by_load, by_creepage));
}

} // namespace

void report_layered_cost(Report& report) {
  report_products(report);
  report.heading("Processor time of solves one after another, 48 elements across, 2 mm of rubber on steel");
  const LayeredBody elastic = {{{2e-3, {rubber}}}, {steel}},
                    relaxing = {{{2e-3, {rubber, {{0.3, 1e-3}, {0.2, 1e-2}}}}}, {steel}};
  report_times(report, "a ball", elastic, 0.5 / radius);
  report_times(report, "a ball, viscoelastic rubber", relaxing, 0.5 / radius);
  report_times(report, "a roller", elastic, 0);
  report_times(report, "a roller, viscoelastic rubber", relaxing, 0);
}

} // namespace microslip::validation
