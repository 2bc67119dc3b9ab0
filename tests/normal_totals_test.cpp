#include "microslip/exact/normal/normal_totals.hpp"

#include "dense_response.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "tests/oracles/active_set_normal.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace microslip {
namespace {

NormalLoad by_force(double force) {
  return {NormalLoad::Given::force, force};
}

Field paraboloid(const ElementGrid& grid, const GapCurvatures& c, double x0 = 0, double y0 = 0) {
  return over_grid(grid, [&](double x, double y) { return c.x * (x - x0) * (x - x0) + c.y * (y - y0) * (y - y0); });
}

/// e = h - delta + u_n with u_n summed pair by pair: closed in contact, open elsewhere.
TEST(NormalTotals, DeformedGap) {
  const ElementGrid grid = ElementGrid::across_ellipse(5e-3, 4e-3, 14, 3);
  const Field h = paraboloid(grid, {0.4, 0.6});
  for (const NormalSolution& s :
       {NormalProblem(steel, grid).solve(h, by_force(3e4), 1e-10), solve_norm(steel, grid, h, by_force(3e4), 1e-10)}) {
    const Field u = dense_normal_displacement(steel, grid, s.pressure);
    ASSERT_EQ(s.gap.size(), grid.count());
    for (std::size_t k = 0; k < h.size(); ++k) {
      EXPECT_NEAR(s.gap[k], h[k] - s.approach + u[k], 1e-12 * s.approach);
      if (s.pressure[k] > 0) {
        EXPECT_NEAR(s.gap[k], 0, 1e-9 * s.approach);
      } else {
        EXPECT_GT(s.gap[k], 0);
      }
    }
  }
}

TEST(NormalTotals, GapOfBodiesThatDoNotTouch) {
  const ElementGrid grid = ElementGrid::across_ellipse(5e-3, 4e-3, 5);
  const Field h = paraboloid(grid, {0.4, 0.6});
  const NormalSolution s = NormalProblem(steel, grid).solve(h, {NormalLoad::Given::approach, -1e-3});
  EXPECT_EQ(s.status, Status::no_contact);
  for (std::size_t k = 0; k < h.size(); ++k) EXPECT_EQ(s.gap[k], h[k] + 1e-3);
  EXPECT_EQ(s.elastic_energy, 0);
}

/// Hertz: 2/5 Fn delta, of second order.
TEST(NormalTotals, ElasticEnergyOfHertz) {
  for (const double ratio : {0.3, 1.0, 4.0})
    for (const int n : {12, 24, 48}) {
      const HertzContact hertz = hertz_from_ellipse(4e-3 * ratio, 4e-3, steel, 82e3);
      const ElementGrid grid = ElementGrid::across_ellipse(hertz.a, hertz.b, n, 2);
      const NormalSolution s = NormalProblem(steel, grid).solve(paraboloid(grid, hertz.gap), by_force(82e3));
      const double energy = 0.4 * hertz.normal_force * hertz.approach;
      EXPECT_NEAR(s.elastic_energy, energy, 0.4 / (n * n) * energy);
    }
}

/// CONTACT's figure for Cattaneo's sphere with 15 elements (User guide, section 5.1).
TEST(NormalTotals, ElasticEnergyAsContactPrintsIt) {
  const CombinedMaterial material{200e6, 0.42, 0};
  const HertzContact hertz = hertz_from_ellipse(1e-3, 1e-3, material, 9.1954);
  const ElementGrid grid = ElementGrid::across_ellipse(1e-3, 1e-3, 15, 2);
  const NormalSolution s = NormalProblem(material, grid).solve(paraboloid(grid, hertz.gap), by_force(9.1954));
  EXPECT_NEAR(s.elastic_energy, 7.350e-5, 0.001e-5);
}

/// The force does work: dU/d(delta) = Fn, exact for the discrete problem.
TEST(NormalTotals, EnergyIsTheWorkOfTheForce) {
  const ElementGrid grid = ElementGrid::across_ellipse(5e-3, 4e-3, 14, 3);
  const Field h = paraboloid(grid, {0.4, 0.6});
  NormalProblem problem(steel, grid);
  const auto at = [&](double approach) { return problem.solve(h, {NormalLoad::Given::approach, approach}, 1e-12); };
  for (const double approach : {3e-6, 8e-6}) {
    const double change = 1e-4 * approach;
    const double slope = (at(approach + change).elastic_energy - at(approach - change).elastic_energy) / (2 * change);
    const double force = at(approach).normal_force;
    EXPECT_NEAR(slope, force, 1e-5 * force);
  }
}

TEST(NormalTotals, BorderSides) {
  const HertzContact hertz = hertz_from_ellipse(3e-3, 3e-3, steel, 4e4);
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 4e-3, 16);
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y) {
      const Field h = paraboloid(grid, hertz.gap, 2e-3 * x, 2e-3 * y);
      for (const NormalSolution& s :
           {NormalProblem(steel, grid).solve(h, by_force(4e4)), solve_norm(steel, grid, h, by_force(4e4))}) {
        EXPECT_EQ(s.border.low_x, x < 0);
        EXPECT_EQ(s.border.high_x, x > 0);
        EXPECT_EQ(s.border.low_y, y < 0);
        EXPECT_EQ(s.border.high_y, y > 0);
        EXPECT_EQ(s.touches_border, x != 0 || y != 0);
      }
    }
}

TEST(NormalTotals, OverflowIsAStatus) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 4e-3, 6, 1);
  const Field h = paraboloid(grid, {0.5, 0.5});
  for (const double force : {1e200, 1e300})
    EXPECT_EQ(NormalProblem(steel, grid).solve(h, by_force(force)).status, Status::invalid_input);
  EXPECT_EQ(NormalProblem(steel, grid).solve(Field(grid.count(), 1.5e308), by_force(1)).status, Status::invalid_input);
}

} // namespace
} // namespace microslip
