// Surface fatigue index and shakedown map.

#include "microslip/damage/fatigue.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/interior/interior_field.hpp"
#include "microslip/rolling/solver.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/test_cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

// Ekberg, Kabo & Andersson 2002: mu - 2 pi a b k/(3 Fz).
TEST(Fatigue, IndexIsEkbergsForAnEllipse) {
  constexpr double a = 7e-3, b = 5e-3, load = 90e3, k = 300e6, mu = 0.28;
  const HertzContact hertz = hertz_from_ellipse(a, b, steel, load);
  EXPECT_NEAR(surface_fatigue_index(mu, hertz.peak_pressure, k), mu - 2 * std::numbers::pi * a * b * k / (3 * load),
              1e-12);
}

// Zero where the surface's limit on the map is met.
TEST(Fatigue, IndexVanishesOnTheMapsLimitOfTheSurface) {
  constexpr double k = 300e6, mu = 0.4;
  EXPECT_NEAR(surface_fatigue_index(mu, k * line_shakedown_limit(mu), k), 0, 1e-12);
  EXPECT_NEAR(surface_fatigue_index(mu, k * point_shakedown_limit(mu), k), 0, 1e-12);
}

/// tau_xz over p0 below a cylinder that slides, in half-widths (McEwen 1949; Johnson 1985, (4.49), (7.8)).
double shear_below_a_line(double x, double z, double mu) {
  const double sum = 1 - x * x + z * z, root = std::sqrt(sum * sum + 4 * x * x * z * z);
  const double m = std::sqrt(std::max((root + sum) / 2, 0.0)), n = std::copysign(std::sqrt((root - sum) / 2), x);
  const double ratio = (z * z + n * n) / (m * m + n * n);
  return n * (m * m - z * z) / (m * m + n * n) + mu * (m * (1 + ratio) - 2 * z);
}

TEST(Fatigue, ShakedownLimitOfALineIsThatOfItsLargestOrthogonalShear) {
  for (double mu = 0; mu <= 0.6; mu += 0.04) {
    double largest = mu; // at the surface
    for (double z = 0.002; z < 1; z += 0.002)
      for (double x = -1.2; x < 1.2; x += 0.004) largest = std::max(largest, std::abs(shear_below_a_line(x, z, mu)));
    EXPECT_NEAR(line_shakedown_limit(mu) * largest, 1, 3e-4) << mu;
  }
  EXPECT_DOUBLE_EQ(line_shakedown_limit(0), 4); // Johnson & Jefferis 1963
  // From here on the surface is sheared most.
  EXPECT_NEAR(line_shakedown_limit(0.366) * 0.366, 0.9977, 3e-4);
  EXPECT_LT(line_shakedown_limit(0.36) * 0.36, 0.999);
  EXPECT_DOUBLE_EQ(line_shakedown_limit(0.37), 1 / 0.37);
}

TEST(Fatigue, ShakedownLimitOfAPointIsThatOfItsLargestOrthogonalShear) {
  constexpr int n = 60;
  const ElementGrid grid = ElementGrid::across_ellipse(1, 1, n, 0);
  std::vector<double> pressure(grid.count());
  constexpr int parts = 6; // mean over each element
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      for (int part = 0; part < parts * parts; ++part) {
        const int column = part % parts, row = part / parts;
        const double x = grid.x(i) + ((column + 0.5) / parts - 0.5) * grid.dx,
                     y = grid.y(j) + ((row + 0.5) / parts - 0.5) * grid.dy;
        pressure[static_cast<std::size_t>(j) * n + i] += std::sqrt(std::max(1 - x * x - y * y, 0.0)) / (parts * parts);
      }
  const Material body{82e9, 0.3};
  const InteriorField normal(body, Body::first, grid, {.px = {}, .py = {}, .pn = pressure}),
      tangential(body, Body::first, grid, {.px = pressure, .py = {}, .pn = {}});
  std::vector<double> by_pressure, by_traction;
  for (double z = 0.25; z < 0.4; z += 0.01)
    for (double x = 0.78; x < 0.9; x += 0.01) {
      by_pressure.push_back(normal.at({x, 0, z}).stress.xz);
      by_traction.push_back(tangential.at({x, 0, z}).stress.xz);
    }
  for (double mu = 0; mu <= 0.4; mu += 0.05) {
    double largest = mu;
    for (std::size_t k = 0; k < by_pressure.size(); ++k)
      largest = std::max(
          {largest, std::abs(by_pressure[k] + mu * by_traction[k]), std::abs(by_pressure[k] - mu * by_traction[k])});
    EXPECT_NEAR(point_shakedown_limit(mu) * largest, 1, 1e-3) << mu;
  }
  EXPECT_NEAR(point_shakedown_limit(0), 4.7, 0.05); // Ponter, Hearle & Johnson 1985
}

TEST(Fatigue, ShakedownLimitsFallWithTraction) {
  for (double mu = 0; mu < 1; mu += 0.01) {
    EXPECT_GT(line_shakedown_limit(mu), line_shakedown_limit(mu + 0.01));
    EXPECT_GE(point_shakedown_limit(mu), line_shakedown_limit(mu));
    EXPECT_GT(point_shakedown_limit(mu), point_shakedown_limit(mu + 0.01));
  }
}

// Somewhere |p| exceeds k if and only if the index of a contact that slides is positive.
TEST(Fatigue, SurfaceYieldsSomewhereWhereTheIndexOfAContactThatSlidesIsPositive) {
  EllipticContact c = steel_contact(6e-3, 4e-3, 0, 0, 0);
  c.creepage = {0.5, 0, 0};
  const ContactSolution s = Solver({.mx = 30, .my = 30}).solve(rolling_problem(c));
  const double mu = c.friction.static_coefficient();
  for (const double share : {0.97, 1.03}) {
    const double k = share * mu * s.totals.peak_pressure;
    const auto excess = shear_excess(s, k);
    EXPECT_EQ(*std::max_element(excess.begin(), excess.end()) > 0,
              surface_fatigue_index(std::hypot(s.totals.fx, s.totals.fy) / c.normal_force, s.totals.peak_pressure, k) >
                  0);
  }
  expect_error([&] { shear_excess(s, 0); }, "shear_yield_strength", "[Pa]: must be positive");
}

} // namespace
} // namespace microslip
