// Least squares: the normal equations of linear problems, Rosenbrock's valley, parameters that are held, the box.

#include "fit/least_squares.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::fit {
namespace {

/// Deviations of a line a + b x from points.
LeastSquares line_through(const std::vector<double>& x, const std::vector<double>& y) {
  return {.residuals =
              [x, y](std::span<const double> p, std::span<double> r) {
                for (std::size_t i = 0; i < x.size(); ++i) r[i] = p[0] + p[1] * x[i] - y[i];
                return true;
              },
          .count = x.size(),
          .lower = {-100, -100},
          .upper = {100, 100}};
}

const std::vector<double> x = {0, 1, 2, 3}, y = {1, 2, 2, 5}; // line 0.7 + 1.2 x

TEST(LeastSquares, OfALineSolveTheNormalEquations) {
  const auto found = minimise(line_through(x, y), std::vector<double>{0, 0});
  EXPECT_NEAR(found.parameters[0], 0.7, 1e-6);
  EXPECT_NEAR(found.parameters[1], 1.2, 1e-6);
  EXPECT_NEAR(found.cost, 1.8, 1e-9);
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(found.jacobian[2 * i], 1, 1e-9);
    EXPECT_NEAR(found.jacobian[2 * i + 1], x[i], 1e-9);
  }
}

TEST(LeastSquares, HoldParameters) {
  const auto found = minimise(line_through(x, y), std::vector<double>{0, 2}, {false, true});
  EXPECT_EQ(found.parameters[1], 2);
  EXPECT_NEAR(found.parameters[0], 2.5 - 2 * 1.5, 1e-6); // mean of y - 2 x
}

TEST(LeastSquares, StayInTheirBox) {
  LeastSquares problem = line_through(x, y);
  problem.upper[1] = 1;
  const auto found = minimise(problem, std::vector<double>{0, 0});
  EXPECT_EQ(found.parameters[1], 1);
  EXPECT_NEAR(found.parameters[0], 1, 2e-4);
}

TEST(LeastSquares, FollowRosenbrocksValley) {
  const LeastSquares valley = {.residuals =
                                   [](std::span<const double> p, std::span<double> r) {
                                     r[0] = 10 * (p[1] - p[0] * p[0]), r[1] = 1 - p[0];
                                     return true;
                                   },
                               .count = 2,
                               .lower = {-5, -5},
                               .upper = {5, 5}};
  const auto found = minimise(valley, std::vector<double>{-1.2, 1}, {}, {}, {.steps = 200, .gain = 0});
  EXPECT_NEAR(found.parameters[0], 1, 1e-4);
  EXPECT_NEAR(found.parameters[1], 1, 2e-4);
}

TEST(LeastSquares, GoRoundWhereThereIsNothing) {
  LeastSquares problem = line_through(x, y);
  const auto everywhere = problem.residuals;
  problem.residuals = [everywhere](std::span<const double> p, std::span<double> r) {
    return p[0] < 0.95 && everywhere(p, r);
  };
  const auto found = minimise(problem, std::vector<double>{0, 0});
  EXPECT_NEAR(found.parameters[0], 0.7, 2e-4);
  const auto nowhere = minimise(problem, std::vector<double>{1, 0});
  EXPECT_TRUE(std::isinf(nowhere.cost));
}

TEST(LeastSquares, InverseOfASymmetricMatrix) {
  const std::vector<double> matrix = {4, 1, 1, 3}, inverse = inverse_of(matrix, 2);
  EXPECT_NEAR(inverse[0], 3. / 11, 1e-9);
  EXPECT_NEAR(inverse[1], -1. / 11, 1e-9);
  EXPECT_NEAR(inverse[3], 4. / 11, 1e-9);
  EXPECT_GT(inverse_of({1, 0, 0, 0}, 2)[3], 1e6); // without effect: hardly known
}

} // namespace
} // namespace microslip::fit
