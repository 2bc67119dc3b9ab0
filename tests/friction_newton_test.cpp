#include "microslip/exact/newton/friction_newton.hpp"

#include "friction_conditions.hpp"
#include "spring_operator.hpp"
#include "tests/support/fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace microslip {
namespace {

class RandomNumbers {
public:
  explicit RandomNumbers(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return low + (high - low) * (static_cast<double>(engine_()) * 0x1p-32); }
  Field field(std::size_t n, double low, double high) {
    Field f(n);
    for (double& value : f) value = between(low, high);
    return f;
  }

private:
  std::mt19937 engine_;
};

/// Any matrix on (px, py); here I + a random one that is small enough for x.Dx > 0.
class MatrixOperator : public SlipOperator {
public:
  MatrixOperator(std::size_t n, double coupling, unsigned seed)
      : n_(n), values_(RandomNumbers(seed).field(4 * n * n, -1, 1)) {
    for (double& value : values_) value *= coupling / std::sqrt(2.0 * double(n));
    for (std::size_t k = 0; k < 2 * n; ++k) values_[k * (2 * n + 1)] += 1;
  }
  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override {
    ++products_;
    for (std::size_t row = 0; row < 2 * n_; ++row) {
      double sum = 0;
      for (std::size_t k = 0; k < n_; ++k)
        sum += values_[row * 2 * n_ + k] * px[k] + values_[row * 2 * n_ + n_ + k] * py[k];
      (row < n_ ? sx[row] : sy[row - n_]) = sum;
    }
  }
  double diagonal() const override { return 1; }
  long products() const override { return products_; }

private:
  std::size_t n_;
  Field values_;
  long products_ = 0;
};

/// c + D p, with the constants found.
PlaneFields slip(SlipOperator& response, const FrictionProblem& problem, const FrictionSolution& s) {
  PlaneFields slip{Field(s.traction.x.size()), Field(s.traction.x.size())};
  response.apply(s.traction.x, s.traction.y, slip.x, slip.y);
  for (std::size_t k = 0; k < s.traction.x.size(); ++k) {
    const double share = problem.constant_share.empty() ? 1 : problem.constant_share[k];
    slip.x[k] += problem.cx[k] + share * s.constants.x;
    slip.y[k] += problem.cy[k] + share * s.constants.y;
  }
  return slip;
}

/// The returned tractions differ from the iterate by the residual, their slip by D times that.
constexpr double projected = 10;

void expect_solved(SlipOperator& response, const FrictionProblem& problem, const FrictionSolution& s,
                   double tolerance) {
  ASSERT_EQ(s.report.status, Status::ok);
  EXPECT_LE(s.report.residual, tolerance);
  const PlaneFields w = slip(response, problem, s);
  expect_friction_conditions({problem.bound, s.traction.x, s.traction.y, w.x, w.y, response.diagonal()}, s.sliding,
                             projected * tolerance);
  for (std::size_t k = 0; k < s.traction.x.size(); ++k) {
    if (problem.bound[k] > 0) {
      EXPECT_NEAR(s.slip.x[k], w.x[k], projected * tolerance * norm(problem.bound) * response.diagonal());
      continue;
    }
    EXPECT_EQ(s.traction.x[k], 0);
    EXPECT_EQ(s.traction.y[k], 0);
    EXPECT_EQ(s.slip.x[k], 0);
    EXPECT_EQ(s.slip.y[k], 0);
    EXPECT_EQ(s.sliding[k], 0);
  }
}

/// Springs: each element sticks with p = -c/flexibility while that is below g, and slides otherwise.
TEST(FrictionNewton, SpringsInClosedForm) {
  const double flexibility = 2.5e-3;
  SpringOperator springs(flexibility);
  RandomNumbers random(1);
  const std::size_t n = 60;
  const Field g = random.field(n, 0, 3), cx = random.field(n, -8e-3, 8e-3), cy = random.field(n, -8e-3, 8e-3);
  const FrictionSolution s = FrictionNewton().solve({springs, g, cx, cy, 1}, {.tolerance = 1e-12});
  ASSERT_EQ(s.report.status, Status::ok);
  int sliding = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double c = std::hypot(cx[k], cy[k]);
    const bool slides = c > flexibility * g[k];
    EXPECT_EQ(s.sliding[k], slides);
    const double p = slides ? g[k] / c : 1 / flexibility, left = slides ? 1 - flexibility * g[k] / c : 0;
    EXPECT_NEAR(s.traction.x[k], -p * cx[k], 1e-10);
    EXPECT_NEAR(s.traction.y[k], -p * cy[k], 1e-10);
    EXPECT_NEAR(s.slip.x[k], left * cx[k], 1e-10 * flexibility);
    EXPECT_NEAR(s.slip.y[k], left * cy[k], 1e-10 * flexibility);
    sliding += slides;
  }
  EXPECT_GT(sliding, 10);
  EXPECT_LT(sliding, 50);
}

TEST(FrictionNewton, RandomSystemsToAnyTolerance) {
  FrictionNewton newton;
  for (unsigned seed = 0; seed < 12; ++seed)
    for (const double tolerance : {1e-3, 1e-6, 1e-10, 1e-13}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", tolerance " + std::to_string(tolerance));
      const std::size_t n = 30;
      RandomNumbers random(seed);
      MatrixOperator response(n, 0.9, seed);
      Field g = random.field(n, 0, 2), cx = random.field(n, -3, 3), cy = random.field(n, -3, 3);
      for (std::size_t k = 0; k < n; k += 7) g[k] = 0;
      const FrictionProblem problem{response, g, cx, cy, 1};
      expect_solved(response, problem, newton.solve(problem, {.tolerance = tolerance}), tolerance);
    }
}

/// With x.Dx > 0 there is one solution, wherever the iteration begins.
TEST(FrictionNewton, TheStartDoesNotMatter) {
  const std::size_t n = 25;
  RandomNumbers random(5);
  MatrixOperator response(n, 0.8, 5);
  const Field g = random.field(n, 0.1, 2), cx = random.field(n, -3, 3), cy = random.field(n, -3, 3);
  const FrictionProblem problem{response, g, cx, cy, 1};
  const FrictionSolution s = FrictionNewton().solve(problem, {.tolerance = 1e-12});
  for (const double size : {0.1, 1.0, 30.0}) {
    const Field px = random.field(n, -size, size), py = random.field(n, -size, size);
    const FrictionSolution other = FrictionNewton().solve(problem, {.tolerance = 1e-12}, {.px = px, .py = py});
    ASSERT_EQ(other.report.status, Status::ok);
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_NEAR(other.traction.x[k], s.traction.x[k], 1e-10);
      EXPECT_NEAR(other.traction.y[k], s.traction.y[k], 1e-10);
    }
  }
}

TEST(FrictionNewton, ASolutionTakesNoStep) {
  const std::size_t n = 25;
  RandomNumbers random(6);
  MatrixOperator response(n, 0.8, 6);
  const Field g = random.field(n, 0.1, 2), cx = random.field(n, -3, 3), cy = random.field(n, -3, 3), none(n, 0.0);
  const FrictionProblem problem{response, g, cx, cy, 1};
  const FrictionSolution s = FrictionNewton().solve(problem, {.tolerance = 1e-9});
  EXPECT_GT(s.report.newton_steps, 1);
  const FrictionSolution again =
      FrictionNewton().solve(problem, {.tolerance = 1e-8}, {.px = s.traction.x, .py = s.traction.y});
  EXPECT_EQ(again.report.newton_steps, 0);
  EXPECT_EQ(again.report.products, 1);
  const FrictionSolution still = FrictionNewton().solve({response, g, none, none, 1}, {});
  EXPECT_EQ(still.report.newton_steps, 0);
  EXPECT_EQ(still.traction.x, none);
  EXPECT_EQ(still.traction.y, none);
  EXPECT_EQ(still.report.residual, 0);
}

/// Everything sticks: a linear system, solved in a few steps.
TEST(FrictionNewton, FullAdhesionIsALinearSystem) {
  const std::size_t n = 25;
  RandomNumbers random(7);
  MatrixOperator response(n, 0.8, 7);
  const Field g(n, 1e3), cx = random.field(n, -3, 3), cy = random.field(n, -3, 3);
  const FrictionSolution s = FrictionNewton().solve({response, g, cx, cy, 1}, {.tolerance = 1e-13});
  EXPECT_EQ(s.report.status, Status::ok);
  PlaneFields left{Field(n), Field(n)};
  response.apply(s.traction.x, s.traction.y, left.x, left.y);
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_FALSE(s.sliding[k]);
    EXPECT_NEAR(left.x[k], -cx[k], 1e-8);
    EXPECT_NEAR(left.y[k], -cy[k], 1e-8);
  }
}

TEST(FrictionNewton, ReversedAndTurnedWithTheSlip) {
  const std::size_t n = 40;
  RandomNumbers random(8);
  SpringOperator springs(0.7);
  MatrixOperator matrix(n, 0.8, 8);
  const Field g = random.field(n, 0.1, 2), cx = random.field(n, -3, 3), cy = random.field(n, -3, 3);
  Field minus_x = cx, minus_y = cy, turned_x(n), turned_y(n);
  const double angle = 0.7, c = std::cos(angle), sine = std::sin(angle);
  for (std::size_t k = 0; k < n; ++k) {
    minus_x[k] = -cx[k];
    minus_y[k] = -cy[k];
    turned_x[k] = c * cx[k] - sine * cy[k];
    turned_y[k] = sine * cx[k] + c * cy[k];
  }
  const FrictionNewton::Options options{.tolerance = 1e-12};
  const FrictionSolution s = FrictionNewton().solve({matrix, g, cx, cy, 1}, options);
  const FrictionSolution minus = FrictionNewton().solve({matrix, g, minus_x, minus_y, 1}, options);
  const FrictionSolution straight = FrictionNewton().solve({springs, g, cx, cy, 1}, options);
  const FrictionSolution turned = FrictionNewton().solve({springs, g, turned_x, turned_y, 1}, options);
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_NEAR(minus.traction.x[k], -s.traction.x[k], 1e-10);
    EXPECT_NEAR(minus.traction.y[k], -s.traction.y[k], 1e-10);
    EXPECT_NEAR(turned.traction.x[k], c * straight.traction.x[k] - sine * straight.traction.y[k], 1e-10);
    EXPECT_NEAR(turned.traction.y[k], sine * straight.traction.x[k] + c * straight.traction.y[k], 1e-10);
  }
}

/// Bound and slip k times as large: tractions k times as large.
TEST(FrictionNewton, IsHomogeneous) {
  const std::size_t n = 30;
  RandomNumbers random(9);
  MatrixOperator response(n, 0.8, 9);
  const Field g = random.field(n, 0.1, 2), cx = random.field(n, -3, 3), cy = random.field(n, -3, 3);
  const FrictionSolution s = FrictionNewton().solve({response, g, cx, cy, 1}, {});
  for (const double factor : {0x1p-40, 0x1p30}) {
    Field kg = g, kx = cx, ky = cy;
    for (Field* field : {&kg, &kx, &ky})
      for (double& value : *field) value *= factor;
    const FrictionSolution other = FrictionNewton().solve({response, kg, kx, ky, 1}, {});
    EXPECT_EQ(other.report.newton_steps, s.report.newton_steps);
    for (std::size_t k = 0; k < n; ++k) EXPECT_EQ(other.traction.x[k], factor * s.traction.x[k]);
  }
}

/// Springs under a common constant slip xi: below the smallest g all stick, and F = -n area xi/flexibility.
TEST(FrictionNewton, ForceGivenInClosedForm) {
  const double flexibility = 0.02, area = 0.3;
  SpringOperator springs(flexibility);
  const std::size_t n = 50;
  const Field g(n, 2.0), none(n, 0.0);
  for (const double share : {0.0, 0.1, -0.5, 0.9, -0.999}) {
    SCOPED_TRACE(share);
    const double force = share * area * 2.0 * double(n);
    const FrictionSolution s =
        FrictionNewton().solve({springs, g, none, none, area, force, std::nullopt}, {.tolerance = 1e-10});
    ASSERT_EQ(s.report.status, Status::ok);
    EXPECT_NEAR(sum(s.traction.x) * area, force, 1e-8);
    EXPECT_NEAR(s.constants.x, -flexibility * force / (area * double(n)), 1e-9);
    EXPECT_EQ(s.constants.y, 0);
  }
}

TEST(FrictionNewton, ForcesGivenOnRandomSystems) {
  FrictionNewton newton;
  for (unsigned seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    const std::size_t n = 30;
    const double area = 1e-4;
    RandomNumbers random(seed);
    MatrixOperator response(n, 0.7, seed);
    const Field g = random.field(n, 0.2, 2), cx = random.field(n, -1, 1), cy = random.field(n, -1, 1);
    const Field share = random.field(n, 0.5, 1);
    const double capacity = sum(g) * area, angle = random.between(0, 6.28), size = random.between(0, 0.95) * capacity;
    FrictionProblem problem{response, g, cx, cy, area, size * std::cos(angle), size * std::sin(angle)};
    if (seed % 3 == 1) problem.force_x.reset();
    if (seed % 3 == 2) problem.force_y.reset();
    if (seed % 2 == 1) problem.constant_share = share;
    const FrictionSolution s = newton.solve(problem, {.tolerance = 1e-10});
    expect_solved(response, problem, s, 1e-10);
    if (problem.force_x) {
      EXPECT_NEAR(sum(s.traction.x) * area, *problem.force_x, 1e-8 * capacity);
    } else {
      EXPECT_EQ(s.constants.x, 0);
    }
    if (problem.force_y) {
      EXPECT_NEAR(sum(s.traction.y) * area, *problem.force_y, 1e-8 * capacity);
    } else {
      EXPECT_EQ(s.constants.y, 0);
    }
  }
}

/// The force of a solution with given constants leads back to these.
TEST(FrictionNewton, ForceLeadsBackToTheConstant) {
  const std::size_t n = 30;
  RandomNumbers random(3);
  MatrixOperator response(n, 0.7, 3);
  const Field g = random.field(n, 0.2, 2), cx = random.field(n, -1, 1), cy = random.field(n, -1, 1);
  Field shifted = cx;
  for (double& value : shifted) value += 0.4;
  const FrictionSolution given = FrictionNewton().solve({response, g, shifted, cy, 1}, {.tolerance = 1e-13});
  const FrictionSolution found =
      FrictionNewton().solve({response, g, cx, cy, 1, sum(given.traction.x), std::nullopt}, {.tolerance = 1e-13});
  EXPECT_NEAR(found.constants.x, 0.4, 1e-10);
  for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(found.traction.x[k], given.traction.x[k], 1e-10);
}

TEST(FrictionNewton, NoContactAnywhere) {
  SpringOperator springs(1);
  const Field none(5, 0.0), c(5, 1.0);
  const FrictionSolution s = FrictionNewton().solve({springs, none, c, c, 1}, {});
  EXPECT_EQ(s.report.status, Status::ok);
  EXPECT_EQ(s.report.residual, 0);
  EXPECT_EQ(s.traction.x, none);
  EXPECT_EQ(s.slip.y, none);
  EXPECT_EQ(s.report.newton_steps, 0);
}

/// Ended before its goal: the status says so, the residual is that of the tractions, which still obey the bound.
TEST(FrictionNewton, NotConvergedIsAStatus) {
  const std::size_t n = 60;
  RandomNumbers random(11);
  MatrixOperator response(n, 0.9, 11);
  const Field g = random.field(n, 0.1, 1), cx = random.field(n, -2, 2), cy = random.field(n, -2, 2);
  const FrictionProblem problem{response, g, cx, cy, 1};
  for (const int calls : {1, 8, 20}) { // before a product or after a step
    int left = calls;
    const auto end_after_calls = [&](double) { return --left > 0; };
    const FrictionSolution s = FrictionNewton().solve(problem, {.tolerance = 1e-12, .progress = end_after_calls});
    EXPECT_EQ(s.report.status, Status::not_converged);
    EXPECT_GT(s.report.residual, 1e-12);
    EXPECT_TRUE(std::isfinite(s.report.residual));
    for (std::size_t k = 0; k < n; ++k) EXPECT_LE(std::hypot(s.traction.x[k], s.traction.y[k]), g[k] * (1 + 1e-15));
    const PlaneFields w = slip(response, problem, s);
    const double honest = complementarity_residual({g, s.traction.x, s.traction.y, w.x, w.y, 1});
    EXPECT_LT(honest, projected * s.report.residual);
  }
}

TEST(FrictionNewton, OneObjectForManyProblems) {
  FrictionNewton newton;
  for (const std::size_t n : {40U, 1U, 17U}) {
    RandomNumbers random(static_cast<unsigned>(n));
    MatrixOperator response(n, 0.5, 3);
    const Field g = random.field(n, 0.2, 2), cx = random.field(n, -3, 3), cy = random.field(n, -3, 3);
    const FrictionProblem problem{response, g, cx, cy, 1};
    const FrictionSolution s = newton.solve(problem, {}), fresh = FrictionNewton().solve(problem, {});
    EXPECT_EQ(s.traction.x, fresh.traction.x);
    EXPECT_EQ(s.traction.y, fresh.traction.y);
    EXPECT_EQ(s.report.products, fresh.report.products);
    EXPECT_GT(s.report.products, s.report.newton_steps);
  }
}

} // namespace
} // namespace microslip
