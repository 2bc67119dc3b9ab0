// Newton's method with Broyden's updates: roots, few Jacobians, what has none.

#include "microslip/numerics/damped_newton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace microslip {
namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<double, 9>;

/// Functions of three unknowns, with their derivatives from central differences.
struct Equations {
  std::function<Vector(const Vector&)> f;
  Vector point, tried = {};
  int evaluations = 0, jacobians = 0;

  Vector residual(const Vector& step) {
    ++evaluations;
    tried = moved(step);
    return f(tried);
  }
  void accept() { point = tried; }
  Matrix jacobian() {
    ++jacobians;
    constexpr double step = 1e-6;
    Matrix m{};
    for (std::size_t j = 0; j < 3; ++j) {
      Vector ahead{}, back{};
      ahead[j] = step, back[j] = -step;
      const Vector high = f(moved(ahead)), low = f(moved(back));
      for (std::size_t i = 0; i < 3; ++i) m[3 * i + j] = (high[i] - low[i]) / (2 * step);
    }
    return m;
  }
  Vector moved(const Vector& step) const { return {point[0] + step[0], point[1] + step[1], point[2] + step[2]}; }
};

TEST(DampedNewton, FindsARootWithFewJacobians) {
  Equations e{[](const Vector& v) {
                return Vector{v[0] + 0.1 * v[1] * v[1] - 1, v[1] + 0.1 * std::sin(v[2]) - 2, v[2] - 0.2 * v[0] * v[1]};
              },
              {}};
  const NewtonResult found = find_root<3>(e, 1e-12);
  EXPECT_LE(found.residual, 1e-12);
  EXPECT_EQ(largest_magnitude(e.f(e.point)), found.residual);
  EXPECT_LE(e.jacobians, 2);
  EXPECT_EQ(e.evaluations, found.steps + 1);
}

/// Newton's steps alone diverge from |x| > 1.39.
TEST(DampedNewton, HalvesStepsThatLeadAway) {
  Equations e{[](const Vector& v) { return Vector{std::atan(v[0]), v[1], v[2] - v[0]}; }, {5, 1, -1}};
  EXPECT_LE(find_root<3>(e, 1e-10).residual, 1e-10);
  EXPECT_NEAR(e.point[0], 0, 1e-10);
}

TEST(DampedNewton, StartsAtARootWithoutAStep) {
  Equations e{[](const Vector& v) { return v; }, {}};
  const NewtonResult found = find_root<3>(e, 0);
  EXPECT_EQ(found.steps + e.jacobians, 0);
  EXPECT_EQ(found.residual, 0);
}

TEST(DampedNewton, GivesUpAtAJumpAtASingularMatrixAndWithoutNumbers) {
  Equations jump{[](const Vector& v) { return Vector{v[0] < 0.5 ? v[0] - 1 : v[0] + 1, v[1], v[2]}; }, {}};
  EXPECT_GE(find_root<3>(jump, 1e-9).residual, 0.5);
  Equations flat{[](const Vector& v) { return Vector{1, v[1], v[2]}; }, {}};
  EXPECT_EQ(find_root<3>(flat, 1e-9).residual, 1);
  EXPECT_EQ(flat.evaluations, 1);
  Equations none{[](const Vector&) { return Vector{0, std::numeric_limits<double>::quiet_NaN(), 0}; }, {}};
  EXPECT_TRUE(std::isnan(find_root<3>(none, 1e-9).residual));
}

TEST(DampedNewton, UpdatesAMatrixToTheLastDifference) {
  Matrix m = {1, 2, 3, 4, 5, 6, 7, 8, 10};
  const Vector step = {0.5, -1, 2}, change = {1, 0, -3}, across = {2, 1, 0};
  const Matrix before = m;
  update_by_broyden<3>(m, step, change);
  for (std::size_t i = 0; i < 3; ++i) {
    double along = 0, other = 0;
    for (std::size_t j = 0; j < 3; ++j)
      along += m[3 * i + j] * step[j], other += (m[3 * i + j] - before[3 * i + j]) * across[j];
    EXPECT_NEAR(along, change[i], 1e-14);
    EXPECT_NEAR(other, 0, 1e-14);
  }
}

} // namespace
} // namespace microslip
