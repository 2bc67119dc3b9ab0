#include "validation/studies.hpp"

#include "microslip/exact/classical/contact_sequence.hpp"
#include "validation/hertzian_solve.hpp"
#include "validation/report.hpp"

#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

const Bodies aluminium_on_steel = combine({23e9, 0.31}, {82e9, 0.28});
constexpr double curvature = 20, load = 16201.9; // A [1/m]; Fn [N] on a length of 1 m
constexpr double length = 1;

/// Friction, longitudinal force over mu Fn, creepage and elements in adhesion as CONTACT prints them.
struct Case {
  const char* name;
  double friction, force, creepage, peak;
  int adhesion;
};
constexpr std::array cases = {
    Case{"mu = 0.0001, free rolling", 1e-4, 0, 5.260e-4, 103.1, 1},
    Case{"mu = 10, free rolling", 10, 0, 3.591e-4, 103.8, 200},
    Case{"mu = 0.05, free rolling", 0.05, 0, 4.294e-4, 103.6, 125},
    Case{"mu = 0.05, Fx = 0.75 mu Fn", 0.05, 0.75, 2.108e-4, 103.2, 36},
    Case{"mu = 0.05, Fx = -0.75 mu Fn", 0.05, -0.75, 5.392e-4, 103.3, 106},
};
/// Free rolling with very little friction: 0.457 kappa a/R, kappa = 2 K/(1 - nu) (Bentall and Johnson 1967).
constexpr double free_rolling = 5.259e-4;

ContactStep rolling(const ElementGrid& grid, const Case& c) {
  ContactStep step;
  step.grid = grid;
  step.bodies = aluminium_on_steel;
  for (int i = 0; i < grid.mx; ++i) step.gap.push_back(curvature * grid.x(i) * grid.x(i));
  step.load = {NormalLoad::Given::force, load};
  step.friction = {FrictionLaw::coulomb(c.friction)};
  step.force_x = c.friction * c.force;
  step.motion.direction = RollingDirection::backward;
  step.motion.tolerance = 1e-8;
  return step;
}

/// CONTACT's grid: a row of elements of 1 um x 1 m.
ElementGrid contact_grid() {
  return {216, 1, -107.5e-6, 0, 1e-6, length};
}

ElementGrid plane_grid(int across) {
  const double a = line_contact_from_load(curvature, aluminium_on_steel.material, load / length).half_width;
  return ElementGrid::across_line(a, across, across / 20, length);
}

} // namespace

bool run_bentall_johnson(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  report.line(
      fmt::format("Aluminium on steel, R = 25 mm, K = {:.4f}, rolling along -x; creepage found for the force given",
                  aluminium_on_steel.material.dissimilarity));
  report.heading("On CONTACT's grid, 200 elements across: computed, CONTACT");
  ContactSequence sequence, in_turn, plane;
  long newton = 0, alternating = 0;
  for (const Case& c : cases) {
    ContactStep step = rolling(contact_grid(), c);
    const ContactStepSolution s = sequence.solve(step);
    const double creepage = s.creepage.longitudinal, peak = s.normal.peak_pressure * 1e-6;
    report.figure(fmt::format("{}: creepage", c.name), fmt::format("{:.4e}", creepage),
                  fmt::format("{:.3e}", c.creepage),
                  s.report.status == Status::ok && std::abs(creepage - c.creepage) <= 0.6e-7);
    report.near("  peak pressure [N/mm2]", "{:.2f}", peak, "{:.1f}", c.peak, 0.06);
    report.figure("  elements in adhesion", std::to_string(s.adhesion_elements), std::to_string(c.adhesion),
                  std::abs(s.adhesion_elements - c.adhesion) <= 1);
    step.coupling = Coupling::alternating;
    const ContactStepSolution other = in_turn.solve(step);
    newton += s.report.products;
    alternating += other.report.products + other.normal.products;
    const double difference = std::abs(other.creepage.longitudinal - creepage);
    report.figure("  by the alternating process: difference", fmt::format("{:.1e}", difference), "<= 1e-9",
                  other.report.status == Status::ok && difference <= 1e-9);
  }
  report.line(fmt::format("products in all: {} with one Newton system, {} in turn", newton, alternating));
  if (options.progress && !options.progress(0.3)) return false;

  report.heading("Plane strain, free rolling with mu = 0.0001: elements across, creepage");
  constexpr std::array grids = {50, 100, 200, 400};
  std::array<double, grids.size()> creepage{};
  for (std::size_t g = 0; g < grids.size(); ++g) {
    const ContactStepSolution s = plane.solve(rolling(plane_grid(grids[g]), cases[0]));
    creepage[g] = s.creepage.longitudinal;
    report.line(fmt::format("{:>4}  {:.5e}  {}", grids[g], creepage[g], to_string(s.report.status)));
    if (options.progress && !options.progress(0.3 + 0.7 * double(g + 1) / grids.size())) return false;
  }
  const double found = limit(creepage[2], grids[2], creepage[3], grids[3]);
  report.near("extrapolated", "{:.4e}", found, "{:.3e}", free_rolling, 0.002 * free_rolling);
  return report.all_as_stated();
}

} // namespace microslip::validation
