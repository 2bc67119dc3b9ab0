// Quick pressures of contacts that are not quite Hertzian.

#include "microslip/exact/normal/approximate_pressure.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/normal/normal_problem.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/steel.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double approach = 50e-6;

const auto methods = {kik_piotrowski_pressure, analyn_pressure};

/// 1.3 times as large as Hertz's ellipse of curvatures A, B, around a point.
ElementGrid grid_of(double a, double b, int count, double x = 0, double y = 0) {
  ElementGrid grid{count, count, x, y, 2.6 * a / count, 2.6 * b / count};
  grid.x0 -= 1.3 * a - grid.dx / 2;
  grid.y0 -= 1.3 * b - grid.dy / 2;
  return grid;
}

double force(const ElementGrid& grid, const Field& p) {
  return sum(p) * grid.element_area();
}

TEST(ApproximatePressure, OfEllipsoidsIsHertzs) {
  for (const double ratio : {0.4, 1.0, 3.0}) {
    const HertzContact hertz = hertz_from_approach({1, 1 / ratio}, steel, approach);
    const ElementGrid grid = grid_of(hertz.a, hertz.b, 81);
    const Field gap = over_grid(grid, [&](double x, double y) { return x * x + y * y / ratio; });
    for (const auto method : methods) {
      const Field p = method(steel, grid, gap, approach);
      EXPECT_NEAR(force(grid, p) / hertz.normal_force, 1, 0.01) << ratio;
      for (int j = 0; j < grid.my; ++j)
        for (int i = 0; i < grid.mx; ++i) {
          const double expected = hertz.pressure(grid.x(i), grid.y(j));
          if (expected > 0.3 * hertz.peak_pressure) {
            EXPECT_NEAR(p[static_cast<std::size_t>(j) * grid.mx + i], expected, 0.02 * hertz.peak_pressure);
          }
        }
    }
  }
}

/// A rail's head: flat in the middle, rounder at one side.
double head(double x, double y) {
  return x * x + (y > 0 ? 0.2 : 2.0) * y * y;
}

/// The method of the exact problem gives a third answer to compare with.
TEST(ApproximatePressure, IsNearTheExactOneBesideHertz) {
  const HertzContact wide = hertz_from_approach({1, 0.3}, steel, approach);
  const ElementGrid grid = grid_of(wide.a, wide.b, 60);
  const Field gap = over_grid(grid, head);
  NormalProblem problem(steel, grid);
  const NormalSolution exact = problem.solve(gap, {NormalLoad::Given::approach, approach});
  for (const auto method : methods) {
    const Field p = method(steel, grid, gap, approach);
    EXPECT_NEAR(force(grid, p) / exact.normal_force, 1, 0.15);
    EXPECT_NEAR(*std::max_element(p.begin(), p.end()) / exact.peak_pressure, 1, 0.15);
  }
}

/// Kik and Piotrowski's pressure presses the half-space in by the approach at the deepest point.
TEST(ApproximatePressure, KikAndPiotrowskisReachesTheApproach) {
  const ElementGrid grid = grid_of(7e-3, 12e-3, 41);
  const Field gap = over_grid(grid, head), p = kik_piotrowski_pressure(steel, grid, gap, approach);
  Field u(grid.count());
  NormalOperator(steel, grid).apply(p, u);
  EXPECT_NEAR(u[20 * 41 + 20], approach, 1e-9 * approach);
}

TEST(ApproximatePressure, FollowsTheContactAndItsMirror) {
  const ElementGrid grid = grid_of(7e-3, 12e-3, 41), beside = grid_of(7e-3, 12e-3, 41, 3e-3, -2e-3);
  const Field gap = over_grid(grid, head);
  const Field moved = over_grid(beside, [](double x, double y) { return head(x - 3e-3, y + 2e-3) + 1e-5; });
  const Field mirrored = over_grid(grid, [](double x, double y) { return head(x, -y); });
  const Field doubled = over_grid(grid, [](double x, double y) { return 2 * head(x, y); });
  for (const auto method : methods) {
    const Field p = method(steel, grid, gap, approach), q = method(steel, beside, moved, approach + 1e-5);
    const Field m = method(steel, grid, mirrored, approach), d = method(steel, grid, doubled, 2 * approach);
    const double peak = *std::max_element(p.begin(), p.end());
    for (int j = 0; j < 41; ++j)
      for (int i = 0; i < 41; ++i) {
        const std::size_t k = static_cast<std::size_t>(j) * 41 + i;
        EXPECT_NEAR(q[k], p[k], 1e-6 * peak);
        EXPECT_NEAR(m[static_cast<std::size_t>(40 - j) * 41 + i], p[k], 1e-6 * peak);
        EXPECT_NEAR(d[k], 2 * p[k], 1e-6 * peak); // all strains twice as large
      }
  }
}

TEST(ApproximatePressure, NothingTouchesOutOfReach) {
  const ElementGrid grid = grid_of(7e-3, 12e-3, 21);
  const Field gap = over_grid(grid, head);
  for (const auto method : methods) EXPECT_EQ(force(grid, method(steel, grid, gap, -1e-6)), 0);
}

TEST(ApproximatePressure, RefusesWhatHasNoCurvature) {
  const ElementGrid grid = grid_of(7e-3, 12e-3, 21);
  const Field slope = over_grid(grid, [](double x, double) { return 0.01 * x; }), gap = over_grid(grid, head);
  for (const auto method : methods) {
    EXPECT_THROW(method(steel, grid, slope, approach), Error);
    EXPECT_THROW(method(steel, grid, Field(5), approach), Error);
    EXPECT_THROW(method(steel, grid, gap, std::nan("")), Error);
    EXPECT_THROW(method(steel, {2, 2, 0, 0, 1e-3, 1e-3}, Field(4), approach), Error);
  }
}

} // namespace
} // namespace microslip
