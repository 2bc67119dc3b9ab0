#include "tests/oracles/active_set_normal.hpp"

#include "dense_response.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace microslip {
namespace {

constexpr auto approach = NormalLoad::Given::approach, force = NormalLoad::Given::force;

struct GapCase {
  std::string name;
  ElementGrid grid;
  Field gap;
  double force; ///< [N]
};

template <class Shape> GapCase gap_case(std::string name, const ElementGrid& grid, double load, Shape shape) {
  return {std::move(name), grid, over_grid(grid, shape), load};
}

std::vector<GapCase> gap_cases() {
  const ElementGrid grid = ElementGrid::across_ellipse(5e-3, 4e-3, 12, 2);
  const auto paraboloid = [](double x, double y) { return 0.4 * x * x + 0.6 * y * y; };
  const auto waves = [=](double x, double y) {
    return paraboloid(x, y) + 2e-6 * (std::sin(2500 * x + 900 * y) + std::sin(1800 * y - 700 * x + 1));
  };
  const auto two = [=](double x, double y) {
    return std::min(paraboloid(x - 3e-3, y), paraboloid(x + 2e-3, y - 2e-3));
  };
  const auto punch = [](double x, double y) { return std::max(std::abs(x), std::abs(y)) < 3e-3 ? 0 : 1.0; };
  return {gap_case("paraboloid", grid, 2e4, paraboloid),
          gap_case("waves", grid, 3e4, waves),
          gap_case("two patches", grid, 5e3, two),
          gap_case("a punch", grid, 1e4, punch),
          gap_case("up to the border", grid, 4e5, paraboloid),
          gap_case("a row", {30, 1, -5e-3, 0, 3e-4, 2e-3, false}, 3e2, paraboloid),
          gap_case("line contact", ElementGrid::across_line(1e-3, 30, 2, 0.02), 1e3,
                   [](double x, double) { return 0.8 * x * x; })};
}

/// p >= 0, e >= 0, p e = 0, and what NormalProblem finds.
void expect_solution(const GapCase& c, const NormalSolution& s, const NormalSolution& other) {
  ASSERT_EQ(s.status, Status::ok);
  ASSERT_EQ(other.status, Status::ok);
  EXPECT_LE(s.residual, 1e-10);
  const Field u = dense_normal_displacement(steel, c.grid, s.pressure);
  const double largest = *std::max_element(u.begin(), u.end());
  for (std::size_t k = 0; k < u.size(); ++k) {
    const double e = c.gap[k] - s.approach + u[k];
    ASSERT_GE(s.pressure[k], 0);
    ASSERT_GE(e, -1e-9 * largest);
    if (s.pressure[k] > 0) {
      ASSERT_LE(e, 1e-9 * largest);
    }
    ASSERT_NEAR(s.displacement[k], u[k], 1e-12 * largest);
    ASSERT_NEAR(s.pressure[k], other.pressure[k], 1e-6 * other.peak_pressure);
  }
  EXPECT_NEAR(s.approach, other.approach, 1e-9 * largest);
  EXPECT_NEAR(s.normal_force, other.normal_force, 1e-8 * other.normal_force);
  EXPECT_NEAR(s.peak_pressure, other.peak_pressure, 1e-6 * other.peak_pressure);
  EXPECT_EQ(s.contact_elements, other.contact_elements);
  EXPECT_EQ(s.touches_border, other.touches_border);
}

TEST(ActiveSetNormal, FindsWhatConjugateGradientsFind) {
  for (const GapCase& c : gap_cases()) {
    SCOPED_TRACE(c.name);
    NormalProblem problem(steel, c.grid);
    const NormalSolution loaded = solve_norm(steel, c.grid, c.gap, {force, c.force}, 1e-10);
    expect_solution(c, loaded, problem.solve(c.gap, {force, c.force}, 1e-10));
    EXPECT_NEAR(loaded.normal_force, c.force, 1e-10 * c.force);
    EXPECT_GE(loaded.products, loaded.iterations);
    const NormalSolution pressed = solve_norm(steel, c.grid, c.gap, {approach, loaded.approach}, 1e-10);
    expect_solution(c, pressed, problem.solve(c.gap, {approach, loaded.approach}, 1e-10));
    EXPECT_EQ(pressed.approach, loaded.approach);
    EXPECT_NEAR(pressed.normal_force, c.force, 1e-8 * c.force);
  }
}

/// Fn and the peak pressure, of second order.
TEST(ActiveSetNormal, Hertz) {
  double before = 0;
  for (const int n : {6, 12, 24}) {
    const HertzContact hertz = hertz_from_ellipse(6e-3, 3e-3, steel, 82e3);
    const auto c = gap_case("", ElementGrid::across_ellipse(6e-3, 3e-3, n, 1), 0,
                            [&](double x, double y) { return hertz.gap.x * x * x + hertz.gap.y * y * y; });
    const NormalSolution s = solve_norm(steel, c.grid, c.gap, {approach, hertz.approach});
    ASSERT_EQ(s.status, Status::ok);
    const double error = std::abs(s.normal_force / hertz.normal_force - 1);
    EXPECT_LT(error, 0.5 / (n * n));
    if (n > 6) {
      EXPECT_GT(before / error, 3);
    }
    before = error;
  }
}

TEST(ActiveSetNormal, OneElementIsASpring) {
  const ElementGrid grid{1, 1, 0, 0, 1e-3, 2e-3, false};
  const Field gap{3e-6};
  const double flexibility = element_influence(steel, grid, 0, 0).zz;
  const NormalSolution pressed = solve_norm(steel, grid, gap, {approach, 5e-6});
  EXPECT_NEAR(pressed.pressure[0], 2e-6 / flexibility, 1e-12 * pressed.pressure[0]);
  EXPECT_TRUE(pressed.status == Status::ok && pressed.contact_elements == 1);
  const NormalSolution loaded = solve_norm(steel, grid, gap, {force, 100});
  EXPECT_NEAR(loaded.approach, 3e-6 + flexibility * 100 / 2e-6, 1e-18);
  EXPECT_NEAR(loaded.normal_force, 100, 1e-10);
}

TEST(ActiveSetNormal, NoContact) {
  const ElementGrid grid{4, 3, 0, 0, 1e-3, 1e-3, false};
  const Field gap(grid.count(), 2e-6);
  for (const double depth : {2e-6, 1e-6, 0.0, -1.0}) {
    const NormalSolution s = solve_norm(steel, grid, gap, {approach, depth});
    EXPECT_EQ(s.status, Status::no_contact);
    EXPECT_EQ(s.pressure, Field(grid.count(), 0.0));
    EXPECT_EQ(s.normal_force, 0);
    EXPECT_EQ(s.contact_elements, 0);
    EXPECT_EQ(s.residual, 0);
  }
}

TEST(ActiveSetNormal, RefusesInputOutOfRange) {
  const ElementGrid grid{4, 3, 0, 0, 1e-3, 1e-3, false};
  Field gap(grid.count(), 2e-6);
  expect_error([&] { solve_norm(steel, grid, gap, {force, 0}); }, "normal_force", "[N]: must be positive");
  expect_error(
      [&] {
        solve_norm(steel, grid, gap, {approach, std::numeric_limits<double>::quiet_NaN()});
      },
      "approach", "[m]: must be finite");
  expect_error([&] { solve_norm(steel, grid, gap, {force, 1}, 0); }, "tolerance", "[-]: must be positive");
  EXPECT_THROW(solve_norm(steel, grid, Field(5), {force, 1}), Error);
  gap[7] = std::numeric_limits<double>::quiet_NaN();
  expect_error([&] { solve_norm(steel, grid, gap, {force, 1}); }, "gap[7]", "[m]: must be finite");
}

} // namespace
} // namespace microslip
