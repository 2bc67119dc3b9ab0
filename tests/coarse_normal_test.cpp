#include "microslip/railway/coarse_normal.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/normal/normal_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace microslip {
namespace {

constexpr CombinedMaterial steel{82e9, 0.28, 0};

struct Sphere {
  double x, y, radius, overlap;

  double gap(double at_x, double at_y) const {
    return (std::pow(at_x - x, 2) + std::pow(at_y - y, 2)) / (2 * radius) - overlap;
  }
};

ElementGrid grid_around(const Sphere& s, int n) {
  const double half = std::sqrt(2 * s.radius * s.overlap), h = 2 * half / n;
  return {.mx = n, .my = n, .x0 = s.x - half + h / 2, .y0 = -half + h / 2, .dx = h, .dy = h};
}

/// Patches each around a sphere, in a plane.
struct Setting {
  std::vector<std::vector<double>> gaps, angles, shears;
  std::vector<CoarsePatch> patches;

  Setting(const std::vector<Sphere>& spheres, int n, double angle = 0) {
    for (const Sphere& s : spheres) {
      const ElementGrid grid = grid_around(s, n);
      std::vector<double> h;
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) h.push_back(s.gap(grid.x(i), s.y + grid.y(j)));
      gaps.push_back(h);
      angles.emplace_back(n, angle);
      shears.emplace_back(n, 0.0);
    }
    for (std::size_t k = 0; k < spheres.size(); ++k)
      patches.push_back({grid_around(spheres[k], n),
                         {0, spheres[k].y * std::cos(angle), spheres[k].y * std::sin(angle)},
                         angle,
                         gaps[k],
                         angles[k],
                         shears[k]});
  }
};

double force(const CoarseNormal& normal, const Setting& setting, std::size_t patch) {
  const std::size_t n = setting.gaps[patch].size(), first = n * patch;
  const auto p = normal.pressure().subspan(first, n);
  return std::accumulate(p.begin(), p.end(), 0.0) * setting.patches[patch].grid.element_area();
}

const Sphere ball{0, 0, 0.3, 50e-6};
/// Hertz: F = 4/3 G/(1 - nu) sqrt(R) delta^1.5 with the combined G, which is that of two equal bodies.
double hertz_force(const Sphere& s) {
  return 4.0 / 3 * steel.shear_modulus / (1 - steel.poisson_ratio) * std::sqrt(s.radius) * std::pow(s.overlap, 1.5);
}

TEST(CoarseNormal, HasHertzsForceOnTwelveElements) {
  CoarseNormal normal(200);
  const Setting one({ball}, 12);
  const auto result = normal.solve(steel, one.patches, {}, false);
  EXPECT_EQ(result.status, Status::ok);
  EXPECT_NEAR(force(normal, one, 0) / hertz_force(ball), 1, 0.01);
  EXPECT_NEAR(result.stiffness * ball.overlap / (1.5 * hertz_force(ball)), 1, 0.02);
  EXPECT_LE(result.sets, 6);
}

TEST(CoarseNormal, AgreesWithTheNormalProblem) {
  const Setting one({ball}, 14);
  NormalProblem exact(steel, one.patches[0].grid);
  std::vector<double> above = one.gaps[0];
  for (double& h : above) h += ball.overlap;
  const NormalSolution expected = exact.solve(above, {NormalLoad::Given::approach, ball.overlap}, 1e-11);
  CoarseNormal normal(200);
  normal.solve(steel, one.patches, {}, false);
  for (std::size_t k = 0; k < above.size(); ++k)
    EXPECT_NEAR(normal.pressure()[k], expected.pressure[k], 1e-8 * expected.peak_pressure);
}

TEST(CoarseNormal, FindsTheLoweringForAVerticalForce) {
  CoarseNormal normal(600);
  const double angle = 0.4;
  const Setting two({ball, {0, 9e-3, 0.2, 30e-6}}, 12, angle);
  const auto given = normal.solve(steel, two.patches, 40e3, false);
  EXPECT_EQ(given.status, Status::ok);
  EXPECT_NEAR((force(normal, two, 0) + force(normal, two, 1)) * std::cos(angle), 40e3, 1e-7);
  const double first = force(normal, two, 0);

  std::vector<Sphere> lowered = {ball, {0, 9e-3, 0.2, 30e-6}};
  Setting there(lowered, 12, angle);
  for (auto& gaps : there.gaps)
    for (double& h : gaps) h -= given.lowering * std::cos(angle);
  EXPECT_LE(normal.solve(steel, there.patches, {}, true).sets, 1);
  EXPECT_NEAR(force(normal, there, 0), first, 1e-6);
}

TEST(CoarseNormal, LetsPatchesActOnEachOtherAsPointForces) {
  CoarseNormal normal(600);
  const double distance = 60e-3;
  const Setting alone({ball}, 12), pair({ball, {0, distance, 0.3, 50e-6}}, 12);
  normal.solve(steel, alone.patches, {}, false);
  const double single = force(normal, alone, 0);
  const auto result = normal.solve(steel, pair.patches, {}, false);
  const double each = force(normal, pair, 0);
  EXPECT_NEAR(force(normal, pair, 1), each, 1e-9 * each);
  // Each is pushed away by u = (1 - nu) F/(pi G D), which is as if its approach were smaller by so much.
  const double push = (1 - steel.poisson_ratio) * each / (M_PI * steel.shear_modulus * distance);
  EXPECT_NEAR(each / single, std::pow(1 - push / ball.overlap, 1.5), 3e-4);
  EXPECT_EQ(result.status, Status::ok);
}

TEST(CoarseNormal, CarriesNothingApart) {
  CoarseNormal normal(200);
  Setting apart({ball}, 8);
  for (double& h : apart.gaps[0]) h += 60e-6;
  const auto result = normal.solve(steel, apart.patches, {}, false);
  EXPECT_EQ(result.status, Status::ok);
  EXPECT_EQ(force(normal, apart, 0), 0);
}

} // namespace
} // namespace microslip
