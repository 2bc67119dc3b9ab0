// A sheet on rigid bodies against integrals of p = (delta - h)/L.

#include "microslip/exact/normal/thin_sheet.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/support/fields.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double flexibility = 2e-12; // m/Pa
constexpr double curvature = 10, a = 2e-3, delta = curvature * a * a;

std::vector<double> paraboloid(const ElementGrid& grid, double across) {
  return over_grid(grid, [=](double x, double y) { return curvature * x * x + across * y * y; });
}

NormalLoad approach(double value) {
  return {NormalLoad::Given::approach, value};
}
NormalLoad force(double value) {
  return {NormalLoad::Given::force, value};
}

/// F = pi delta^2/(4 A L), energy F delta/3 for h = A (x^2 + y^2).
TEST(ThinSheet, Paraboloid) {
  const ElementGrid grid = ElementGrid::across_ellipse(a, a, 400, 4);
  const double expected = std::numbers::pi * delta * delta / (2 * curvature * flexibility);
  const NormalSolution s = solve_thin_sheet(flexibility, grid, paraboloid(grid, curvature), approach(delta));
  EXPECT_EQ(s.status, Status::ok);
  EXPECT_NEAR(s.normal_force / expected, 1, 1e-4);
  EXPECT_NEAR(s.elastic_energy / (expected * delta / 3), 1, 1e-4);
  EXPECT_NEAR(s.peak_pressure / (delta / flexibility), 1, 1e-4);
  EXPECT_NEAR(s.contact_elements * grid.element_area() / (std::numbers::pi * a * a), 1, 1e-3);
  EXPECT_FALSE(s.touches_border);
}

/// F = 4/3 delta^(3/2) length/(sqrt(A) L) for h = A x^2.
TEST(ThinSheet, Cylinder) {
  const ElementGrid grid = ElementGrid::across_line(a, 1000, 10, 0.01);
  const double expected = 4. / 3 * std::pow(delta, 1.5) * 0.01 / (std::sqrt(curvature) * flexibility);
  const NormalSolution s = solve_thin_sheet(flexibility, grid, paraboloid(grid, 0), approach(delta));
  EXPECT_NEAR(s.normal_force / expected, 1, 1e-5);
}

/// The approach of a force gives the force back, and a force the approach.
TEST(ThinSheet, ForceAndApproachAreInverse) {
  const ElementGrid grid = ElementGrid::across_ellipse(a, a, 24, 30, 3);
  const std::vector<double> gap = paraboloid(grid, 2 * curvature);
  for (const double share : {0.05, 0.1, 0.7, 1.0}) {
    const NormalSolution given = solve_thin_sheet(flexibility, grid, gap, approach(share * delta));
    const NormalSolution found = solve_thin_sheet(flexibility, grid, gap, force(given.normal_force));
    EXPECT_NEAR(found.approach / (share * delta), 1, 1e-13);
    EXPECT_NEAR(found.normal_force / given.normal_force, 1, 1e-13);
    EXPECT_EQ(found.contact_elements, given.contact_elements);
  }
}

/// Where it presses e = 0, elsewhere e > 0, and u_n = L p_n.
TEST(ThinSheet, MeetsTheConditionsOfContact) {
  const ElementGrid grid = ElementGrid::across_ellipse(a, a, 17, 12, 2);
  const NormalSolution s = solve_thin_sheet(flexibility, grid, paraboloid(grid, 3 * curvature), force(500));
  for (std::size_t k = 0; k < grid.count(); ++k) {
    EXPECT_NEAR(s.gap[k], s.pressure[k] > 0 ? 0 : std::max(s.gap[k], 0.0), 1e-18);
    EXPECT_DOUBLE_EQ(s.displacement[k], flexibility * s.pressure[k]);
  }
}

TEST(ThinSheet, ExcludedElementsBearNothing) {
  const ElementGrid grid = ElementGrid::across_ellipse(a, a, 20, 20, 2);
  const std::vector<double> gap = paraboloid(grid, curvature);
  std::vector<char> excluded(grid.count());
  for (std::size_t k = 0; k < grid.count(); ++k) excluded[k] = k % grid.mx < 12;
  const NormalSolution half = solve_thin_sheet(flexibility, grid, gap, approach(delta), excluded);
  EXPECT_NEAR(half.normal_force, solve_thin_sheet(flexibility, grid, gap, approach(delta)).normal_force / 2, 1e-9);
  const NormalSolution loaded = solve_thin_sheet(flexibility, grid, gap, force(2 * half.normal_force), excluded);
  EXPECT_NEAR(loaded.normal_force, 2 * half.normal_force, 1e-9);
  for (std::size_t k = 0; k < grid.count(); ++k) EXPECT_TRUE(!excluded[k] || loaded.pressure[k] == 0);
}

TEST(ThinSheet, BodiesThatDoNotReachEachOther) {
  const ElementGrid grid = ElementGrid::across_ellipse(a, a, 4, 4, 0);
  const NormalSolution s = solve_thin_sheet(flexibility, grid, paraboloid(grid, curvature), approach(-1e-6));
  EXPECT_EQ(s.status, Status::no_contact);
  EXPECT_EQ(s.normal_force, 0);
}

TEST(ThinSheet, NamesInputOutOfRange) {
  const ElementGrid grid = ElementGrid::across_ellipse(a, a, 2, 2, 0);
  const auto message = [&](double l, std::size_t gaps, const NormalLoad& load, std::vector<char> excluded) {
    return error_of([&] { solve_thin_sheet(l, grid, std::vector<double>(gaps), load, excluded); });
  };
  EXPECT_EQ(message(0, 4, force(1), {}).find("flexibility = 0 [m/Pa]"), 0U);
  EXPECT_EQ(message(1, 3, force(1), {}), "gap: must have mx times my = 4 values");
  EXPECT_EQ(message(1, 4, force(-1), {}).find("normal_force = -1 [N]"), 0U);
  EXPECT_EQ(message(1, 4, approach(std::numeric_limits<double>::quiet_NaN()), {}).find("approach = nan [m]"), 0U);
  EXPECT_EQ(message(1, 4, force(1), {1}), "excluded: must have mx times my = 4 values");
}

} // namespace
} // namespace microslip
