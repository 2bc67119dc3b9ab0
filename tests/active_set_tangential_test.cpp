#include "tests/oracles/active_set_tangential.hpp"

#include "friction_cases.hpp"
#include "friction_conditions.hpp"
#include "tests/oracles/direct_operator.hpp"
#include "tests/support/expect_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

/// Another algorithm, other sums, another treatment of forces: the same solution.
TEST(ActiveSetTangential, FindsWhatNewtonFinds) {
  for (const FrictionCase& c : friction_cases(9)) {
    SCOPED_TRACE(c.name);
    DirectOperator response(c.kernel());
    const PlaneFields free = c.free_slip();
    const TangSolution s = solve_tang(c.problem(response, free), {.tolerance = 1e-9});
    ASSERT_EQ(s.report.status, Status::ok) << s.report.residual;
    EXPECT_LE(s.report.residual, 1e-9);
    EXPECT_GE(s.divisions, 1);
    const PlaneFields w = slip(c, s);
    expect_friction_conditions({c.bound, s.traction.x, s.traction.y, w.x, w.y, response.diagonal()}, s.sliding, 1e-8);
    expect_newtons(c, s);
  }
}

/// For other maps than block Toeplitz ones too: the leading edge's correction.
TEST(ActiveSetTangential, LeadingEdgeCorrected) {
  FrictionCase c = elliptic_case("", 9, 1, rolling(6e-4, -5e-4, 0.2));
  c.input.step = 2.5 * c.grid.dx;
  c.input.leading_edge = LeadingEdge{};
  const auto entering = entering_elements(c.grid, c.bound, c.input.step, *c.input.leading_edge);
  TangentialOperator difference = TangentialOperator::difference(c.material, c.grid, c.input.step);
  TangentialOperator displacement = TangentialOperator::displacement(c.material, c.grid);
  LeadingEdgeOperator response(difference, displacement, c.input.step, entering);
  PlaneFields free = c.free_slip();
  for (const EnteringElement& e : entering) free.x[e.element] *= e.share, free.y[e.element] *= e.share;
  const TangSolution s = solve_tang(c.problem(response, free), {.tolerance = 1e-9});
  ASSERT_EQ(s.report.status, Status::ok);
  expect_newtons(c, s);
  c.input.leading_edge.reset();
  const ContactSolution plain = c.by_newton();
  double change = 0;
  for (std::size_t k = 0; k < c.bound.size(); ++k)
    change = std::max(change, std::abs(s.traction.x[k] - plain.fields.traction.x[k]));
  EXPECT_GT(change, 0.01 * *std::max_element(c.bound.begin(), c.bound.end()));
}

/// With a bound that is never reached the first division is the last; s = 0 is a linear system, of one Newton step.
TEST(ActiveSetTangential, FullAdhesionIsOneDivision) {
  FrictionCase c = elliptic_case("", 7, 1, rolling(6e-4, 5e-4, 0.2));
  for (double& g : c.bound) g *= 1e3;
  DirectOperator response(c.kernel());
  const PlaneFields free = c.free_slip();
  const TangSolution s = solve_tang(c.problem(response, free), {.tolerance = 1e-4});
  EXPECT_EQ(s.report.status, Status::ok);
  EXPECT_EQ(s.divisions, 1);
  EXPECT_EQ(s.report.newton_steps, 1);
  EXPECT_EQ(std::count(s.sliding.begin(), s.sliding.end(), 1), 0);
}

TEST(ActiveSetTangential, ASolutionIsItsOwnDivision) {
  const FrictionCase c = elliptic_case("", 9, 1, rolling(6e-4, 5e-4, 0.2));
  DirectOperator response(c.kernel());
  const PlaneFields free = c.free_slip();
  const FrictionProblem problem = c.problem(response, free);
  const TangSolution s = solve_tang(problem, {.tolerance = 1e-10});
  EXPECT_GT(s.divisions, 2);
  const TangSolution again = solve_tang(problem, {}, s.traction.x, s.traction.y);
  EXPECT_EQ(again.divisions, 1);
  EXPECT_EQ(again.report.newton_steps, 0);
  EXPECT_EQ(again.sliding, s.sliding);
}

TEST(ActiveSetTangential, NothingMovesAndNoContact) {
  FrictionCase c = elliptic_case("", 6, 1, rolling(0, 0, 0));
  DirectOperator response(c.kernel());
  PlaneFields free = c.free_slip();
  const TangSolution still = solve_tang(c.problem(response, free), {});
  EXPECT_EQ(still.report.status, Status::ok);
  EXPECT_EQ(still.report.newton_steps, 0);
  EXPECT_EQ(still.traction.x, Field(c.bound.size(), 0.0));
  std::fill(c.bound.begin(), c.bound.end(), 0.0);
  free.x.assign(free.x.size(), 1.0);
  const TangSolution none = solve_tang(c.problem(response, free), {});
  EXPECT_EQ(none.report.status, Status::ok);
  EXPECT_EQ(none.slip.x, Field(c.bound.size(), 0.0));
}

/// The residual is that of the tractions, which obey the bound.
TEST(ActiveSetTangential, NotConvergedIsAStatus) {
  const FrictionCase c = elliptic_case("", 9, 1, rolling(6e-4, 5e-4, 0.2));
  DirectOperator response(c.kernel());
  const PlaneFields free = c.free_slip();
  for (const int divisions : {1, 2}) {
    const TangSolution s = solve_tang(c.problem(response, free), {.most_divisions = divisions});
    EXPECT_EQ(s.report.status, Status::not_converged);
    EXPECT_EQ(s.divisions, divisions);
    EXPECT_GT(s.report.residual, 1e-6);
    EXPECT_NEAR(
        s.report.residual,
        complementarity_residual({c.bound, s.traction.x, s.traction.y, s.slip.x, s.slip.y, response.diagonal()}),
        1e-10 * s.report.residual);
    for (std::size_t k = 0; k < c.bound.size(); ++k)
      EXPECT_LE(std::hypot(s.traction.x[k], s.traction.y[k]), c.bound[k] * (1 + 1e-15));
  }
}

TEST(ActiveSetTangential, RefusesOptionsOutOfRange) {
  const FrictionCase c = elliptic_case("", 4, 1, rolling(1e-3, 0, 0));
  DirectOperator response(c.kernel());
  const PlaneFields free = c.free_slip();
  expect_error([&] { solve_tang(c.problem(response, free), {.tolerance = 0}); }, "tolerance", "[-]: must be positive");
  expect_error([&] { solve_tang(c.problem(response, free), {.most_divisions = 0}); }, "most_divisions", "must be");
}

} // namespace
} // namespace microslip
