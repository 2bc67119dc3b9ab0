#include "tests/oracles/prescribed_force.hpp"

#include "spring_operator.hpp"
#include "tests/oracles/friction_residual.hpp"
#include "tests/support/fields.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace microslip {
namespace {

constexpr double area = 0.3, flexibility = 2;

/// Springs stick with p = -c/flexibility or slide with p = -g c/|c|.
FrictionSolution solve_springs(const FrictionProblem& problem, double, std::span<const double>,
                               std::span<const double>) {
  EXPECT_FALSE(problem.force_x || problem.force_y);
  FrictionSolution s;
  for (std::size_t k = 0; k < problem.bound.size(); ++k) {
    const double size = std::hypot(problem.cx[k], problem.cy[k]) / flexibility;
    const double factor = (size > problem.bound[k] ? problem.bound[k] / size : 1) / flexibility;
    s.traction.x.push_back(-factor * problem.cx[k]);
    s.traction.y.push_back(-factor * problem.cy[k]);
  }
  find_residual(problem, s);
  return s;
}

double total(const Field& p) {
  return area * sum(p);
}

const Field bounds = {1, 2, 0.5, 3, 0, 0.1};
const Field cx = {0.1, -0.4, 0.3, 2, 1, 0}, cy = {0, 0.2, -0.7, 0.4, -1, 0};
constexpr double capacity = 6.6 * area;

TEST(PrescribedForce, WithoutForcesItIsTheSolver) {
  SpringOperator springs(flexibility);
  const FrictionSolution s = solve_prescribed_force({springs, bounds, cx, cy, area}, 1e-8, solve_springs);
  EXPECT_EQ(s.constants.x, 0);
  EXPECT_EQ(s.constants.y, 0);
  EXPECT_EQ(s.traction.x, solve_springs({springs, bounds, cx, cy, area}, 0, {}, {}).traction.x);
}

/// Equal springs under a common slip: F = -n area c/flexibility below the bound.
TEST(PrescribedForce, EqualSpringsInClosedForm) {
  SpringOperator springs(flexibility);
  const Field g(40, 2.0), none(40, 0.0);
  for (const double share : {0.0, 0.1, -0.5, 0.9}) {
    const double force = share * 40 * 2 * area;
    const FrictionSolution s = solve_prescribed_force({springs, g, none, none, area, force}, 1e-10, solve_springs);
    EXPECT_EQ(s.report.status, Status::ok);
    EXPECT_NEAR(s.constants.x, -flexibility * force / (40 * area), 1e-8);
    EXPECT_EQ(s.constants.y, 0);
  }
}

TEST(PrescribedForce, OneOrTwoForcesUpToNearlyFullSliding) {
  SpringOperator springs(flexibility);
  const Field share = {1, 0.9, 0.8, 0.7, 1, 0.6};
  for (const double size : {0.0, 0.3, 0.7, 0.9, 0.97})
    for (int k = 0; k < 12; ++k) {
      FrictionProblem problem{springs, bounds, cx, cy, area, {}, {}, {}};
      const double fx = size * capacity * std::cos(k), fy = size * capacity * std::sin(k);
      if (k % 3 != 1) problem.force_x = fx;
      if (k % 3 != 2) problem.force_y = fy;
      if (k % 2 == 1) problem.constant_share = share;
      SCOPED_TRACE(testing::Message() << "size " << size << ", direction " << k);
      const FrictionSolution s = solve_prescribed_force(problem, 1e-9, solve_springs);
      ASSERT_EQ(s.report.status, Status::ok) << s.report.residual;
      EXPECT_LE(s.report.residual, 1e-9);
      if (problem.force_x) {
        EXPECT_NEAR(total(s.traction.x), fx, 1e-7 * capacity);
      } else {
        EXPECT_EQ(s.constants.x, 0);
      }
      if (problem.force_y) {
        EXPECT_NEAR(total(s.traction.y), fy, 1e-7 * capacity);
      } else {
        EXPECT_EQ(s.constants.y, 0);
      }
    }
}

/// No slip gives a force beyond friction.
TEST(PrescribedForce, BeyondFrictionIsAStatus) {
  SpringOperator springs(flexibility);
  const FrictionSolution s =
      solve_prescribed_force({springs, bounds, cx, cy, area, 1.1 * capacity, 0}, 1e-8, solve_springs);
  EXPECT_EQ(s.report.status, Status::not_converged);
  EXPECT_GT(s.report.residual, 1e-3);
  EXPECT_TRUE(std::isfinite(s.report.residual) && std::isfinite(s.constants.x) && std::isfinite(s.constants.y));
}

} // namespace
} // namespace microslip
