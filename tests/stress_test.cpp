#include "microslip/elasticity/stress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace microslip {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unit(const Vector& a) {
  const double size = std::sqrt(dot(a, a));
  return {a[0] / size, a[1] / size, a[2] / size};
}

/// The tensor with given principal stresses along random axes.
Stress turned(const Vector& values, std::mt19937& engine) {
  std::uniform_real_distribution<double> any(-1, 1);
  const Vector a = unit({any(engine), any(engine), any(engine)});
  const Vector b = unit(cross(a, {any(engine), any(engine), any(engine)})), c = cross(a, b);
  const auto entry = [&](int i, int j) {
    return values[0] * a[i] * a[j] + values[1] * b[i] * b[j] + values[2] * c[i] * c[j];
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

/// Distinct, nearly and fully equal, of very different sizes, zero.
const std::vector<Vector> principal = {{3, 2, 1},        {5, -1, -7}, {1, 1, -2},          {2, -1, -1},
                                       {1 + 1e-9, 1, 1}, {4, 4, 4},   {1e9, 1e-3, -1e3},   {0, 0, 0},
                                       {0, 0, -1},       {1, 0, -1},  {-1, -2, -2 - 1e-12}};

TEST(Stress, PrincipalStressesWhateverTheAxes) {
  std::mt19937 engine(7);
  for (const Vector& values : principal)
    for (int k = 0; k < 200; ++k) {
      const auto found = principal_stresses(turned(values, engine));
      const double size = std::max(std::abs(values[0]), std::abs(values[2]));
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], values[i], 4e-15 * size);
    }
}

TEST(Stress, InvariantsWhateverTheAxes) {
  std::mt19937 engine(8);
  for (const Vector& v : principal)
    for (int k = 0; k < 50; ++k) {
      const Stress s = turned(v, engine);
      const double size = std::max(std::abs(v[0]), std::abs(v[2]));
      const double mises = std::sqrt(
          ((v[0] - v[1]) * (v[0] - v[1]) + (v[1] - v[2]) * (v[1] - v[2]) + (v[2] - v[0]) * (v[2] - v[0])) / 2);
      EXPECT_NEAR(hydrostatic(s), (v[0] + v[1] + v[2]) / 3, 4e-15 * size);
      EXPECT_NEAR(von_mises(s), mises, 4e-15 * size);
      EXPECT_NEAR(tresca(s), v[0] - v[2], 8e-15 * size);
    }
}

/// Uniaxial tension: both equivalent stresses are the tension. Pure shear t: root 3 t and 2 t.
TEST(Stress, EquivalentStressesOfTensionAndShear) {
  EXPECT_DOUBLE_EQ(von_mises({0, 5, 0, 0, 0, 0}), 5);
  EXPECT_DOUBLE_EQ(tresca({0, -5, 0, 0, 0, 0}), 5);
  EXPECT_DOUBLE_EQ(von_mises({0, 0, 0, 0, 2, 0}), 2 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(tresca({0, 0, 0, 0, 0, 2}), 4);
  EXPECT_EQ(von_mises({-3, -3, -3, 0, 0, 0}), 0);
  EXPECT_EQ(tresca({-3, -3, -3, 0, 0, 0}), 0);
}

TEST(Stress, TinyAndHugeOnes) {
  for (const double scale : {1e-150, 1e-20, 1e20, 1e150}) {
    const auto found = principal_stresses({scale, scale, 0, scale, 0, 0});
    EXPECT_NEAR(found[0] / scale, 2, 1e-15);
    EXPECT_NEAR(found[1] / scale, 0, 1e-15);
    EXPECT_NEAR(found[2] / scale, 0, 1e-15);
  }
}

} // namespace
} // namespace microslip
