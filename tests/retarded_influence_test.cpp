// Delayed deformation against plain sums over time, and its limits.

#include "microslip/exact/halfspace/retarded_influence.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const CombinedMaterial material = {2.0, 0.3, 0.2};
constexpr double dx = 0.5, dy = 0.7;

Influence at(double x, double y) {
  return influence(material, dx, dy, x, y);
}

/// The integral by the midpoint rule in t = 1 - exp(-q/l), many points.
Influence brute_force(double x, double y, double ratio, double length) {
  constexpr int n = 60000;
  Influence sum = {};
  for (int k = 0; k < n; ++k) {
    const double q = -std::abs(length) * std::log(1 - (k + 0.5) / n);
    const Influence a = at(x + std::copysign(q, length), y);
    sum.xx += a.xx, sum.xy += a.xy, sum.yy += a.yy, sum.zz += a.zz, sum.xz += a.xz, sum.yz += a.yz;
  }
  const double w = ratio / n;
  return {w * sum.xx, w * sum.xy, w * sum.yy, w * sum.zz, w * sum.xz, w * sum.yz};
}

void expect_near(const Influence& a, const Influence& b, double tolerance) {
  const double unit = at(0, 0).zz;
  EXPECT_NEAR(a.xx, b.xx, tolerance * unit);
  EXPECT_NEAR(a.xy, b.xy, tolerance * unit);
  EXPECT_NEAR(a.yy, b.yy, tolerance * unit);
  EXPECT_NEAR(a.zz, b.zz, tolerance * unit);
  EXPECT_NEAR(a.xz, b.xz, tolerance * unit);
  EXPECT_NEAR(a.yz, b.yz, tolerance * unit);
}

TEST(RetardedInfluence, IsTheIntegralOverThePast) {
  for (const double y : {0.0, 0.35})
    for (const double length : {0.03, 0.4, -6.0}) {
      const Retardation retardation{1.7, length};
      for (const double first : {-2.0, -1.87}) { // on the grid, and between its points
        const auto row = retarded_row<Influence>(
            retardation, [y](double x) { return at(x, y); }, dx, first, 9);
        for (const int i : {0, 4, 8}) {
          SCOPED_TRACE(testing::Message() << "y " << y << " l " << length << " point " << i);
          expect_near(row[static_cast<std::size_t>(i)], brute_force(first + i * dx, y, 1.7, length), 1e-4);
        }
      }
    }
}

TEST(RetardedInfluence, DoesNotDependOnWhereTheRowBegins) {
  const Retardation retardation{1, 1.3};
  const RowInfluence<Influence> influence = [](double x) { return at(x, 0.2); };
  const auto row = retarded_row(retardation, influence, dx, -2, 9);
  for (int i = 0; i < 9; ++i)
    expect_near(retarded_row(retardation, influence, dx, -2 + i * dx, 1)[0], row[static_cast<std::size_t>(i)], 1e-8);
}

TEST(RetardedInfluence, WithoutDelayIsTheRatioTimesTheElasticOne) {
  const auto row = retarded_row<Influence>(
      {0.6, 0}, [](double x) { return at(x, 0); }, dx, -1, 5);
  for (int i = 0; i < 5; ++i) {
    Influence a = at(-1 + i * dx, 0);
    for (double* part : {&a.xx, &a.xy, &a.yy, &a.zz, &a.xz, &a.yz}) *part *= 0.6;
    expect_near(row[static_cast<std::size_t>(i)], a, 1e-14);
  }
}

TEST(RetardedInfluence, IsTheMirrorImageInTheOtherDirection) {
  const auto forward = retarded_row<Influence>(
      {1, 0.8}, [](double x) { return at(x, dy); }, dx, -2, 9);
  const auto backward = retarded_row<Influence>(
      {1, -0.8}, [](double x) { return at(x, dy); }, dx, -2, 9);
  for (std::size_t i = 0; i < 9; ++i) {
    Influence mirrored = backward[8 - i];
    mirrored.xy *= -1, mirrored.xz *= -1;
    expect_near(forward[i], mirrored, 1e-12);
  }
}

} // namespace
} // namespace microslip
