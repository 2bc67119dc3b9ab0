#include "microslip/numerics/cubic_roots.hpp"

#include <gtest/gtest.h>

#include <random>

namespace microslip {
namespace {

std::array<double, 4> with_roots(double a, double b, double c, double factor) {
  return {-factor * a * b * c, factor * (a * b + b * c + c * a), -factor * (a + b + c), factor};
}

TEST(CubicRoots, FindsThoseInsideTheInterval) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-2, 2);
  for (int k = 0; k < 2000; ++k) {
    std::array<double, 3> known{any(random), any(random), any(random)};
    std::sort(known.begin(), known.end());
    const double low = -1, high = 1;
    bool clear = known[1] - known[0] > 1e-3 && known[2] - known[1] > 1e-3;
    std::vector<double> inside;
    for (const double t : known) {
      clear = clear && std::abs(t - low) > 1e-6 && std::abs(t - high) > 1e-6;
      if (t > low && t < high) inside.push_back(t);
    }
    if (!clear) continue;
    const CubicRoots roots = cubic_roots(with_roots(known[0], known[1], known[2], any(random)), low, high);
    ASSERT_EQ(roots.count, static_cast<int>(inside.size()));
    for (std::size_t i = 0; i < inside.size(); ++i) EXPECT_NEAR(roots.value[i], inside[i], 1e-9);
  }
}

TEST(CubicRoots, LowerDegreesAndEndsOfTheInterval) {
  EXPECT_EQ(cubic_roots({1, 0, 0, 0}, 0, 1).count, 0);
  EXPECT_EQ(cubic_roots({0, 0, 0, 0}, 0, 1).count, 0);
  const CubicRoots line = cubic_roots({-1, 2, 0, 0}, 0, 1);
  ASSERT_EQ(line.count, 1);
  EXPECT_EQ(line.value[0], 0.5);
  const CubicRoots parabola = cubic_roots({-0.25, 0, 1, 0}, -1, 1);
  ASSERT_EQ(parabola.count, 2);
  EXPECT_NEAR(parabola.value[0], -0.5, 1e-15);
  EXPECT_NEAR(parabola.value[1], 0.5, 1e-15);
  const CubicRoots ends = cubic_roots({0, -1, 1, 0}, 0, 1);
  ASSERT_EQ(ends.count, 2);
  EXPECT_EQ(ends.value[0], 0);
  EXPECT_EQ(ends.value[1], 1);
  const CubicRoots touching = cubic_roots({0, 0, 1, 0}, -1, 1);
  ASSERT_EQ(touching.count, 1);
  EXPECT_EQ(touching.value[0], 0);
}

TEST(CubicRoots, AReversedPolynomialHasTheNegativeRoots) {
  const std::array<double, 4> c{0.3, -1.1, -0.2, 1.7};
  const CubicRoots roots = cubic_roots(c, -3, 3), mirrored = cubic_roots({c[0], -c[1], c[2], -c[3]}, -3, 3);
  ASSERT_EQ(roots.count, 3);
  ASSERT_EQ(mirrored.count, 3);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(roots.value[k], -mirrored.value[2 - k], 1e-15);
}

} // namespace
} // namespace microslip
