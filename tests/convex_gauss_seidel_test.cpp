#include "tests/oracles/convex_gauss_seidel.hpp"

#include "friction_cases.hpp"
#include "friction_conditions.hpp"
#include "tests/oracles/direct_operator.hpp"
#include "tests/support/expect_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace microslip {
namespace {

GaussSeidelSolution sweep(const FrictionCase& c, const GaussSeidelOptions& options) {
  const TangentialKernel kernel = c.kernel();
  DirectOperator response(kernel);
  const PlaneFields free = c.free_slip();
  return solve_convex_gauss_seidel(c.problem(response, free), kernel, options);
}

/// The other algorithm, other sums, another treatment of forces: the same solution.
TEST(ConvexGaussSeidel, FindsWhatNewtonFinds) {
  for (const FrictionCase& c : friction_cases(9)) {
    SCOPED_TRACE(c.name);
    const GaussSeidelSolution s = sweep(c, {.tolerance = 1e-9});
    ASSERT_EQ(s.report.status, Status::ok) << s.report.residual;
    EXPECT_LE(s.report.residual, 1e-9);
    const PlaneFields w = slip(c, s);
    expect_friction_conditions({c.bound, s.traction.x, s.traction.y, w.x, w.y, c.kernel().diagonal()}, s.sliding, 1e-8);

    expect_newtons(c, s);
  }
}

TEST(ConvexGaussSeidel, ThreadsDoNotChangeABit) {
  const FrictionCase c = elliptic_case("", 12, 1.5, rolling(6e-4, 5e-4, 0.2));
  const GaussSeidelSolution one = sweep(c, {.most_sweeps = 12});
  for (const int threads : {2, 3, 7}) {
    const GaussSeidelSolution s = sweep(c, {.most_sweeps = 12, .threads = threads});
    EXPECT_EQ(s.traction.x, one.traction.x);
    EXPECT_EQ(s.traction.y, one.traction.y);
    EXPECT_EQ(s.report.residual, one.report.residual);
  }
}

/// A single element: p = -(D + lambda)^-1 c, with lambda = 0 in adhesion and |p| = g in slip.
TEST(ConvexGaussSeidel, OneElementInClosedForm) {
  FrictionCase c{.name = "", .grid = {1, 1, 0, 0, 1e-3, 4e-3, false}, .bound = {1e8}, .input = rolling(0, 0, 0)};
  c.input.motion = ContactMotion::shift;
  const double dxx = c.kernel().xx.at(0, 0), dyy = c.kernel().yy.at(0, 0), g = c.bound[0];
  ASSERT_GT(std::abs(dxx - dyy), 0.1 * dxx);
  for (int k = 0; k < 48; ++k)
    for (const double size : {0.5, 0.99, 1.2, 3.0, 1e6}) {
      const double angle = k * std::numbers::pi / 24;
      c.input.creepage.longitudinal = size * g * dxx * std::cos(angle);
      c.input.creepage.lateral = size * g * dxx * std::sin(angle);
      const GaussSeidelSolution s = sweep(c, {.tolerance = 1e-13});
      ASSERT_EQ(s.report.status, Status::ok);
      const auto traction = [&](double lambda) {
        return Vec2{-c.input.creepage.longitudinal / (dxx + lambda), -c.input.creepage.lateral / (dyy + lambda)};
      };
      const auto too_large = [&](double lambda) { return std::hypot(traction(lambda).x, traction(lambda).y) > g; };
      double low = 0, high = 2e6 * dxx;
      EXPECT_EQ(s.sliding[0], too_large(0));
      for (int halving = 0; halving < 200 && too_large(0); ++halving)
        (too_large((low + high) / 2) ? low : high) = (low + high) / 2;
      EXPECT_NEAR(s.traction.x[0], traction(low).x, 1e-9 * g);
      EXPECT_NEAR(s.traction.y[0], traction(low).y, 1e-9 * g);
    }
}

TEST(ConvexGaussSeidel, NothingMoves) {
  const FrictionCase c = elliptic_case("", 6, 1, rolling(0, 0, 0));
  const GaussSeidelSolution s = sweep(c, {});
  EXPECT_EQ(s.report.status, Status::ok);
  EXPECT_EQ(s.sweeps, 1);
  EXPECT_EQ(s.report.residual, 0);
  EXPECT_EQ(s.traction.x, Field(c.bound.size(), 0.0));
}

TEST(ConvexGaussSeidel, NoContactAnywhere) {
  FrictionCase c = elliptic_case("", 6, 1, rolling(1e-3, 0, 0));
  std::fill(c.bound.begin(), c.bound.end(), 0.0);
  const GaussSeidelSolution s = sweep(c, {});
  EXPECT_EQ(s.report.status, Status::ok);
  EXPECT_EQ(s.report.residual, 0);
  EXPECT_EQ(s.slip.x, Field(c.bound.size(), 0.0));
}

/// Tractions obey the bound after every sweep; the status is honest, and so is the residual.
TEST(ConvexGaussSeidel, NotConvergedIsAStatus) {
  const FrictionCase c = elliptic_case("", 9, 1.5, rolling(6e-4, 5e-4, 0.2));
  double before = 1e9;
  for (const int sweeps : {1, 2, 4, 8, 16}) {
    const GaussSeidelSolution s = sweep(c, {.tolerance = 1e-12, .most_sweeps = sweeps});
    EXPECT_EQ(s.report.status, Status::not_converged);
    EXPECT_EQ(s.sweeps, sweeps);
    const PlaneFields w = slip(c, s);
    EXPECT_NEAR(s.report.residual,
                complementarity_residual({c.bound, s.traction.x, s.traction.y, w.x, w.y, c.kernel().diagonal()}),
                1e-10 * s.report.residual);
    EXPECT_LT(s.report.residual, before);
    before = s.report.residual;
    for (std::size_t k = 0; k < c.bound.size(); ++k)
      EXPECT_LE(std::hypot(s.traction.x[k], s.traction.y[k]), c.bound[k] * (1 + 1e-15));
  }
}

TEST(ConvexGaussSeidel, ASolutionTakesOneSweep) {
  const FrictionCase c = elliptic_case("", 9, 1, rolling(6e-4, 5e-4, 0.2));
  const TangentialKernel kernel = c.kernel();
  DirectOperator response(kernel);
  const PlaneFields free = c.free_slip();
  const FrictionProblem problem = c.problem(response, free);
  const GaussSeidelSolution s = solve_convex_gauss_seidel(problem, kernel, {.tolerance = 1e-10});
  EXPECT_GT(s.sweeps, 10);
  EXPECT_EQ(solve_convex_gauss_seidel(problem, kernel, {.tolerance = 1e-8}, s.traction.x, s.traction.y).sweeps, 1);
}

/// The iterates depend on the relaxation, the solution does not.
TEST(ConvexGaussSeidel, AnyRelaxationThatConvergesFindsTheSame) {
  const FrictionCase c = elliptic_case("", 8, 1, rolling(6e-4, 5e-4, 0.2));
  const GaussSeidelSolution s = sweep(c, {.tolerance = 1e-9});
  const double most = *std::max_element(c.bound.begin(), c.bound.end());
  for (const Relaxation relaxation : {Relaxation{1, 1}, Relaxation{0.5, 0.5}, Relaxation{0.3, 1}, Relaxation{1, 0.3}}) {
    const GaussSeidelSolution other = sweep(c, {.tolerance = 1e-9, .relaxation = relaxation});
    ASSERT_EQ(other.report.status, Status::ok);
    EXPECT_NE(other.sweeps, s.sweeps);
    for (std::size_t k = 0; k < c.bound.size(); ++k) {
      ASSERT_NEAR(other.traction.x[k], s.traction.x[k], 1e-6 * most);
      ASSERT_NEAR(other.traction.y[k], s.traction.y[k], 1e-6 * most);
    }
  }
}

/// Small steps need small relaxation: that of the kernel converges where a fixed one does not.
TEST(ConvexGaussSeidel, RelaxationFollowsTheStep) {
  FrictionCase c = elliptic_case("", 9, 1, rolling(6e-4, 5e-4, 0.2));
  double before = 0;
  for (const double step : {0.1, 0.2, 0.5, 1.0, 5.0}) {
    SCOPED_TRACE(step);
    c.input.step = step * c.grid.dx;
    const Relaxation relaxation = Relaxation::of(c.kernel());
    EXPECT_GT(relaxation.adhesion, before);
    EXPECT_EQ(relaxation.adhesion, relaxation.slip);
    before = relaxation.adhesion;
    EXPECT_EQ(sweep(c, {}).report.status, Status::ok);
    if (step < 0.4) {
      EXPECT_EQ(sweep(c, {.most_sweeps = 2000, .relaxation = Relaxation{0.9, 0.9}}).report.status,
                Status::not_converged);
    }
    TangentialInput turned = c.input;
    turned.direction = RollingDirection::backward;
    const FrictionCase back = elliptic_case("", 9, 1, turned);
    EXPECT_NEAR(Relaxation::of(back.kernel()).slip, relaxation.slip, 1e-10);
  }
  EXPECT_EQ(before, 0.9);
}

TEST(ConvexGaussSeidel, RefusesOptionsOutOfRange) {
  const FrictionCase c = elliptic_case("", 4, 1, rolling(1e-3, 0, 0));
  expect_error([&] { sweep(c, {.tolerance = 0}); }, "tolerance", "[-]: must be positive");
  expect_error([&] { sweep(c, {.most_sweeps = 0}); }, "most_sweeps", "must be");
  expect_error([&] { sweep(c, {.threads = 0}); }, "threads", "must be");
  for (const double omega : {0.0, 2.0, -1.0}) {
    expect_error([&] { sweep(c, {.relaxation = Relaxation{omega, 1}}); }, "relaxation", "[-]: must be");
    expect_error([&] { sweep(c, {.relaxation = Relaxation{1, omega}}); }, "relaxation", "[-]: must be");
  }
}

} // namespace
} // namespace microslip
