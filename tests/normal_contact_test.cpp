#include "microslip/exact/normal/normal_contact.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace microslip {
namespace {

constexpr std::size_t plenty = 10000;

NormalLoad by_force(double force) {
  return {NormalLoad::Given::force, force};
}

GapFunction paraboloid(const GapCurvatures& c, double x0 = 0, double y0 = 0) {
  return [=](double x, double y) { return c.x * (x - x0) * (x - x0) + c.y * (y - y0) * (y - y0); };
}

/// A free element all around.
void expect_free_border(const NormalContact& c) {
  const auto pressure = [&](int i, int j) { return c.solution.pressure[static_cast<std::size_t>(j) * c.grid.mx + i]; };
  for (int j = 0; j < c.grid.my && c.grid.mx > 1; ++j) EXPECT_EQ(pressure(0, j) + pressure(c.grid.mx - 1, j), 0);
  for (int i = 0; i < c.grid.mx && c.grid.my > 1; ++i) EXPECT_EQ(pressure(i, 0) + pressure(i, c.grid.my - 1), 0);
}

TEST(NormalContact, KeepsAGridThatIsLargeEnough) {
  const HertzContact hertz = hertz_from_ellipse(4e-3, 3e-3, steel, 82e3);
  const ElementGrid grid = ElementGrid::across_ellipse(hertz.a, hertz.b, 12, 2);
  for (const std::size_t most : {std::size_t{0}, plenty}) {
    const NormalContact c = solve_normal_contact(steel, paraboloid(hertz.gap), grid, by_force(82e3), most);
    EXPECT_EQ(c.grid.mx, grid.mx);
    EXPECT_EQ(c.grid.x0, grid.x0);
    const NormalSolution direct = NormalProblem(steel, grid).solve(c.undeformed_gap, by_force(82e3));
    EXPECT_EQ(c.solution.pressure, direct.pressure);
  }
}

/// From a grid anywhere near, also one that is a hundred times too small: the solution is that of a large grid.
TEST(NormalContact, GrowsUntilTheBorderIsFree) {
  const HertzContact hertz = hertz_from_ellipse(4e-3, 3e-3, steel, 82e3);
  const ElementGrid full = ElementGrid::across_ellipse(hertz.a, hertz.b, 20, 3);
  const NormalContact whole = solve_normal_contact(steel, paraboloid(hertz.gap), full, by_force(82e3));
  for (const NormalLoad& load : {by_force(82e3), NormalLoad{NormalLoad::Given::approach, whole.solution.approach}})
    for (const auto& [first_i, first_j, mx, my] : {std::array{12, 13, 2, 2}, {3, 3, 5, 20}, {3, 3, 20, 3}}) {
      ElementGrid start = full;
      start.mx = mx;
      start.my = my;
      start.x0 = full.x(first_i);
      start.y0 = full.y(first_j);
      const NormalContact c = solve_normal_contact(steel, paraboloid(hertz.gap), start, load, plenty);
      ASSERT_EQ(c.solution.status, Status::ok);
      expect_free_border(c);
      EXPECT_FALSE(c.solution.touches_border);
      EXPECT_EQ(c.grid.dx, full.dx);
      const double columns = (full.x0 - c.grid.x0) / full.dx, rows = (full.y0 - c.grid.y0) / full.dy;
      EXPECT_NEAR(columns, std::round(columns), 1e-9); // by whole elements
      EXPECT_NEAR(rows, std::round(rows), 1e-9);
      EXPECT_EQ(c.solution.contact_elements, whole.solution.contact_elements);
      EXPECT_NEAR(c.solution.approach, whole.solution.approach, 1e-7 * whole.solution.approach);
      EXPECT_NEAR(c.solution.normal_force, 82e3, 1e-6 * 82e3);
      EXPECT_NEAR(c.solution.peak_pressure, whole.solution.peak_pressure, 1e-6 * whole.solution.peak_pressure);
    }
}

/// It grows on the sides that the contact reaches, and only there.
TEST(NormalContact, GrowsWhereTheContactReachesTheBorder) {
  const HertzContact hertz = hertz_from_ellipse(3e-3, 3e-3, steel, 4e4);
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 4e-3, 16);
  const NormalContact c = solve_normal_contact(steel, paraboloid(hertz.gap, 2e-3, 0), grid, by_force(4e4), plenty);
  expect_free_border(c);
  EXPECT_EQ(c.grid.x0, grid.x0);
  EXPECT_GT(c.grid.mx, grid.mx);
  EXPECT_EQ(c.grid.my, grid.my);
  EXPECT_EQ(c.grid.y0, grid.y0);
}

TEST(NormalContact, ARowStaysARow) {
  for (const bool column : {false, true}) {
    ElementGrid grid{.mx = 4, .my = 1, .x0 = -4e-4, .y0 = 0, .dx = 2e-4, .dy = 3e-4, .line = false};
    if (column) grid = {.mx = 1, .my = 4, .x0 = 0, .y0 = -4e-4, .dx = 3e-4, .dy = 2e-4, .line = false};
    const NormalContact c = solve_normal_contact(steel, paraboloid({1, 1}), grid, by_force(200), plenty);
    expect_free_border(c);
    EXPECT_GT(c.grid.count(), 4U);
    EXPECT_EQ(column ? c.grid.mx : c.grid.my, 1);
  }
  const ElementGrid one{.mx = 1, .my = 1, .x0 = 0, .y0 = 0, .dx = 1e-3, .dy = 1e-3, .line = false};
  EXPECT_EQ(solve_normal_contact(steel, paraboloid({1, 1}), one, by_force(200), plenty).grid.count(), 1U);
}

TEST(NormalContact, ErrorNamesTheBorder) {
  const HertzContact hertz = hertz_from_ellipse(3e-3, 3e-3, steel, 4e4);
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 4e-3, 16);
  const auto shifted = [&](double x, double y, std::size_t most) {
    return error_of([&] { solve_normal_contact(steel, paraboloid(hertz.gap, x, y), grid, by_force(4e4), most); });
  };
  EXPECT_EQ(shifted(2e-3, 0, 0), "grid: the contact reaches its border at x = 0.004000 m; the potential contact of "
                                 "16 x 16 elements is too small");
  EXPECT_NE(shifted(-2e-3, 0, 0).find("at x = -0.004000 m;"), std::string::npos);
  EXPECT_NE(shifted(0, 2e-3, 0).find("at y = 0.004000 m;"), std::string::npos);
  EXPECT_NE(shifted(-2e-3, -2e-3, 0).find("at x = -0.004000 m, y = -0.004000 m;"), std::string::npos);
  EXPECT_NE(shifted(2e-3, 0, 256).find("too small, and it may have 256 at most"), std::string::npos);
  EXPECT_EQ(shifted(0, 0, 0), "no error");
}

/// Flat bodies are in contact everywhere: the limit is reached, and used as far as it goes.
TEST(NormalContact, LimitIsUsed) {
  const ElementGrid grid = ElementGrid::across_ellipse(1e-3, 1e-3, 10);
  const std::string text = error_of([&] {
    solve_normal_contact(
        steel, [](double, double) { return 0.0; }, grid, by_force(1), 500);
  });
  EXPECT_NE(text.find("of 22 x 22 elements"), std::string::npos) << text;
}

TEST(NormalContact, NoContactIsAStatus) {
  const ElementGrid grid = ElementGrid::across_ellipse(1e-3, 1e-3, 5);
  const NormalContact c = solve_normal_contact(
      steel, [](double, double) { return 1e-6; }, grid, {NormalLoad::Given::approach, 1e-6}, plenty);
  EXPECT_EQ(c.solution.status, Status::no_contact);
  EXPECT_EQ(c.grid.count(), 25U);
}

/// A ball's gap is not a number beyond its radius; the point is named, also when growth leads there.
TEST(NormalContact, GapWithoutANumber) {
  const double radius = 1e-3;
  const GapFunction ball = [=](double x, double y) { return radius - std::sqrt(radius * radius - x * x - y * y); };
  expect_error([&] { solve_normal_contact(steel, ball, ElementGrid::across_ellipse(2e-3, 1e-3, 4), by_force(1)); },
               "gap at x = -0.001500 m, y = -0.000750 m", "[m]: must be finite");
  const ElementGrid small = ElementGrid::across_ellipse(2e-4, 2e-4, 4);
  EXPECT_NE(error_of([&] { solve_normal_contact(steel, ball, small, by_force(1e6), plenty); }).find("gap at x ="),
            std::string::npos);
}

TEST(NormalContact, LineContactGrowsWithTheForceGiven) {
  const ElementGrid grid = ElementGrid::across_line(2e-4, 4);
  const NormalContact c = solve_normal_contact(steel, paraboloid({1, 0}), grid, by_force(2e5), plenty);
  const LineContact line = line_contact_from_load(1, steel, 2e5);
  EXPECT_NEAR(c.solution.contact_elements * grid.dx, 2 * line.half_width, 2 * grid.dx);
  EXPECT_NE(error_of([&] {
              solve_normal_contact(steel, paraboloid({1, 0}), grid, {NormalLoad::Given::approach, 1e-5}, plenty);
            }).find("needs the force given"),
            std::string::npos);
}

} // namespace
} // namespace microslip
