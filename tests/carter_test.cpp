#include "tangential_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace microslip {
namespace {

using std::numbers::pi;

/// Cylinders, Carter 1926: with k = |xi|/(2 mu A a), |Fx| = mu Fn (1 - (1 - k)^2), adhesion over (1 - k) of the width
/// at the leading edge.
struct LineProblem {
  double curvature = 1, per_length = 178.9e3, friction = 0.3;
  double a, scale; ///< half-width, and creepage of full sliding
  Problem problem;

  explicit LineProblem(int n) {
    a = line_contact_from_load(curvature, steel, per_length).half_width;
    scale = 2 * friction * curvature * a;
    problem = with_gap(steel, ElementGrid::across_line(a, n, 2), {curvature, 0}, per_length, friction, a);
  }
};

TEST(Carter, IsOfFirstOrder) {
  for (const double k : {0.1, 0.4, 0.8}) {
    const double exact = 1 - (1 - k) * (1 - k);
    double before = 0;
    for (const int n : {25, 50, 100, 200}) {
      SCOPED_TRACE("k = " + std::to_string(k) + ", elements: " + std::to_string(n));
      const LineProblem c(n);
      for (const RollingDirection direction : {forward, backward})
        for (const int sign : {1, -1}) {
          TangentialInput input;
          input.creepage.longitudinal = sign * k * c.scale;
          input.direction = direction;
          input.tolerance = 1e-9;
          const ContactSolution s = solve(c.problem, input);
          ASSERT_EQ(s.report.status, Status::ok);
          const double force = -sign * s.totals.fx / c.problem.capacity;
          EXPECT_NEAR(s.totals.fy, 0, 1e-9 * c.problem.capacity);
          EXPECT_GT(force, exact);
          EXPECT_LT(force, exact + 0.35 / n);
          EXPECT_NEAR(s.totals.adhesion_area / (2 * c.a), 1 - k, 1.0 / n);
          EXPECT_EQ(s.fields.state[static_cast<std::size_t>(direction == forward ? 2 : n + 1)], CellState::slip);
          EXPECT_EQ(s.fields.state[static_cast<std::size_t>(direction == forward ? n + 1 : 2)], CellState::adhesion);
          if (direction == forward && sign == 1) {
            if (before > 0) {
              EXPECT_NEAR((before - exact) / (force - exact), 2, 0.15);
              EXPECT_NEAR(2 * force - before, exact, 0.5 / (n * n)); // without its first-order part
            }
            before = force;
          }
        }
    }
  }
}

TEST(Carter, Tractions) {
  const int n = 200;
  const LineProblem c(n);
  const double k = 0.4, d = 1 - k, peak = 2 * c.problem.capacity / (pi * c.a);
  TangentialInput input;
  input.creepage.longitudinal = k * c.scale;
  const ContactSolution s = solve(c.problem, input);
  for (int i = 0; i < c.problem.grid.mx; ++i) {
    const double x = c.problem.grid.x(i) / c.a, inner = (x - k) / d;
    const double p = std::sqrt(std::max(0.0, 1 - x * x)) - d * std::sqrt(std::max(0.0, 1 - inner * inner));
    EXPECT_NEAR(-s.fields.traction.x[static_cast<std::size_t>(i)] / peak, p, std::abs(x) < 0.95 ? 0.025 : 0.12) << x;
  }
}

/// In line contact lateral traction is anti-plane shear: the same as longitudinal with 1 - nu times the creepage.
TEST(Carter, LateralCreepageOfALine) {
  const LineProblem c(40);
  TangentialInput input;
  input.tolerance = 1e-11;
  input.creepage.lateral = 0.5 * c.scale;
  const ContactSolution lateral = solve(c.problem, input);
  input.creepage = {0.5 * c.scale * (1 - c.problem.material.poisson_ratio), 0, 0};
  const ContactSolution longitudinal = solve(c.problem, input);
  for (std::size_t i = 0; i < c.problem.bound.size(); ++i)
    EXPECT_NEAR(lateral.fields.traction.y[i], longitudinal.fields.traction.x[i],
                1e-8 * longitudinal.totals.peak_traction);
  EXPECT_NEAR(lateral.totals.fx, 0, 1e-9 * c.problem.capacity);
}

/// CONTACT's example of Carter's problem (User guide, section 5.2): plates of 200 mm, leading element 1/4 too far out.
TEST(Carter, AsContactPrintsIt) {
  const ElementGrid grid{.mx = 55, .my = 1, .x0 = -1.05e-3, .y0 = 0, .dx = 4e-5, .dy = 0.2, .line = false};
  const Problem p = with_gap(steel, grid, {1, 0}, 35780, 0.3, 1e-3);
  TangentialInput input;
  input.creepage.longitudinal = -2.4e-4;
  input.rolling_speed = 30;
  const ContactSolution s = solve(p, input);
  EXPECT_NEAR(s.totals.fx, 6955, 0.5);
  EXPECT_NEAR(s.totals.frictional_power, 47.62, 0.005);
  EXPECT_NEAR(s.totals.adhesion_area / grid.element_area(), 30, 1e-9);
  EXPECT_NEAR(s.totals.slip_area / grid.element_area(), 20, 1e-9);
}

} // namespace
} // namespace microslip
