#include "validation/studies.hpp"

#include "microslip/exact/fitted/second_order_rolling.hpp"
#include "validation/hertzian_solve.hpp"
#include "validation/report.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr std::array grids = {25, 50, 100, 200, 400};
constexpr CombinedMaterial steel = {82e9, 0.28, 0};
constexpr double half_width = 1e-3, curvature = 1, friction = 0.3;
constexpr double creepage = 0.00024;
/// Carter's adhesion area has the half-width a - R xi/mu, R = 1/(2 A), and what is missing to full sliding is its
/// square.
constexpr double adhesion_share = 1 - creepage / (2 * curvature * friction * half_width);
constexpr double exact_force = 1 - adhesion_share * adhesion_share;

struct Outcome {
  double force;    ///< over mu Fn
  double adhesion; ///< half-width of the adhesion area over a
  int adhering, sliding;
};

Outcome roll(const ElementGrid& grid, RollingDirection direction) {
  const double load =
      line_contact_from_half_width(curvature, steel, half_width).force_per_length * grid.dy; // fn for the length dy
  HertzianSolve contact(steel, grid, {curvature, 0}, load);
  TangentialInput input;
  input.creepage = {-creepage, 0, 0};
  input.direction = direction;
  input.tolerance = 1e-10;
  const ContactSolution s = contact.solve(friction, input);
  return {s.totals.fx / (friction * load), s.totals.adhesion_area / grid.dy / (2 * half_width),
          count(s, CellState::adhesion), count(s, CellState::slip)};
}

/// Fx over mu Fn at second order, with elements fitted to the edges.
double roll_at_second_order(int n) {
  SecondOrderRolling rolling(steel, fit_line(half_width, n));
  const double load = line_contact_from_half_width(curvature, steel, half_width).force_per_length;
  std::vector<double> bound = rolling.contact().load_share;
  for (double& g : bound) g *= friction * load;
  SecondOrderInput input;
  input.creepage = {-creepage, 0, 0};
  input.tolerance = 1e-10;
  const SecondOrderSolution s = rolling.solve(bound, input);
  double force = 0;
  for (std::size_t k = 0; k < bound.size(); ++k)
    force += s.friction.traction.x[k] * rolling.contact().elements[k].width();
  return force / (friction * load);
}

void report_second_order(Report& report) {
  report.heading("At second order: elements across, Fx, its error, ratio");
  std::array<double, grids.size()> error{};
  for (std::size_t g = 0; g < grids.size(); ++g) {
    const double force = roll_at_second_order(grids[g]);
    error[g] = force - exact_force;
    report.line(fmt::format("{:>4}  {:.6f}  {:>8.1e}  {:>6}", grids[g], force, error[g],
                            g == 0 ? "" : fmt::format("{:.3f}", error[g - 1] / error[g])));
  }
  const double order = std::log2(std::abs(error.front() / error.back())) / double(grids.size() - 1);
  report.bounded("mean order", "{:.3f}", order, ">= 1.8");
}

} // namespace

bool run_carter(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  report.line(
      fmt::format("a = 1 mm, R = 500 mm, mu = 0.3, xi = -0.00024: Fx = {:.2f} mu Fn, adhesion half-width {:.1f} a",
                  exact_force, adhesion_share));
  report.heading("Elements across, Fx, its error, ratio, adhesion half-width");
  std::array<double, grids.size()> error{}, force{};
  double worst_mirror = 0;
  bool adhesion_fits = true;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    const auto grid = ElementGrid::across_line(half_width, grids[g], 2);
    const Outcome forward = roll(grid, RollingDirection::forward), backward = roll(grid, RollingDirection::backward);
    force[g] = forward.force;
    error[g] = forward.force - exact_force;
    worst_mirror = std::max(worst_mirror, std::abs(forward.force - backward.force));
    adhesion_fits = adhesion_fits && std::abs(forward.adhesion - adhesion_share) <= 2.0 / grids[g];
    report.line(fmt::format("{:>4}  {:.5f}  {:>8.1e}  {:>5}  {:.4f}", grids[g], force[g], error[g],
                            g == 0 ? "" : fmt::format("{:.3f}", error[g - 1] / error[g]), forward.adhesion));
    if (options.progress && !options.progress(double(g + 1) / double(grids.size() + 1))) return false;
  }
  const std::size_t last = grids.size() - 1;
  const double order = std::log2(error[0] / error[last]) / double(last);
  const double extrapolated = limit(force[last - 1], grids[last - 1], force[last], grids[last]);
  report.near("mean order", "{:.3f}", order, "1", 0.1);
  report.near("Fx extrapolated from the last two", "{:.6f}", extrapolated, "{:.2f}", exact_force, 1e-4);
  report.figure("adhesion half-width, on all grids", adhesion_fits ? "fits" : "does not fit", "0.6 a +- dx",
                adhesion_fits);
  report.bounded("rolling along -x: largest difference of Fx", "{:.1e}", worst_mirror, "<= 1e-8");

  report_second_order(report);

  // The leading element's outer edge lies dx/4 beyond the true one there, which makes the error larger.
  const ElementGrid as_contact{55, 1, -1.05e-3, 0, 0.04e-3, 0.2, true};
  const Outcome same = roll(as_contact, RollingDirection::forward);
  report.heading("On the grid of CONTACT's example: 50 elements of 0.04 mm, shifted by 0.01 mm; computed, CONTACT");
  report.near("Fx", "{:.4f}", same.force, "0.6480", 2e-4);
  report.count("elements in adhesion", same.adhering, 30);
  report.count("elements in slip", same.sliding, 20);
  return report.all_as_stated();
}

} // namespace microslip::validation
