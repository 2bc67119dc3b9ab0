#include "microslip/error.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "tests/support/s1002_on_60e1.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double load = 80e3;

WheelRailMethod exact(int elements = 16) {
  WheelRailMethod method;
  method.theory = Theory::exact;
  method.elements = elements;
  return method;
}

/// With other creepages the patch keeps its pressures, so that forces change by the responses at k = 0.
TEST(WheelResponse, IsTheDerivativeByCreepagesWhereNothingOscillates) {
  WheelRail solver(s1002_on_60e1(), exact());
  WheelRailSolution solution;
  const auto responses = solver.respond(running(1e-3, 0, 1e-3), load, std::array{0.0, 200.0}, solution);
  ASSERT_EQ(solution.status, Status::ok);
  ASSERT_EQ(responses.size(), solution.patches.size());
  const WheelRailSolution less = solver.solve(running(1e-3, 0, 0.98e-3), load),
                          more = solver.solve(running(1e-3, 0, 1.02e-3), load);
  for (std::size_t k = 0; k < responses.size(); ++k) {
    ASSERT_EQ(responses[k].at.size(), 2u);
    const double xi = more.patches[k].creepage.longitudinal - less.patches[k].creepage.longitudinal;
    const double by_xi = (more.patches[k].fx - less.patches[k].fx) / xi;
    const std::complex<double> still = responses[k].at[0].by_creepage[0][0],
                               waves = responses[k].at[1].by_creepage[0][0];
    EXPECT_NEAR(still.real(), by_xi, 0.03 * std::abs(by_xi)) << k;
    EXPECT_LT(std::abs(waves), std::abs(still));
    EXPECT_NEAR(responses[k].at[0].load_by_roughness.real() / responses[k].normal_stiffness, 1, 0.02);
    EXPECT_NEAR(responses[k].solution.totals.fx, solution.patches[k].fx, 1e-3 * std::abs(solution.patches[k].fx));
  }
}

/// A right wheel is the mirror image of a left one.
TEST(WheelResponse, OfARightWheelIsMirrored) {
  WheelRailBodies bodies = s1002_on_60e1();
  WheelRail left(bodies, exact());
  bodies.side = TrackSide::right;
  WheelRail right(bodies, exact());
  WheelRailSolution solution;
  const std::array k = {200.0};
  const auto of_left = left.respond(running(1e-3, 0, 1e-3), load, k, solution),
             of_right = right.respond(running(1e-3, 0, 1e-3).mirrored(), load, k, solution);
  ASSERT_EQ(of_left.size(), of_right.size());
  ASSERT_FALSE(of_left.empty());
  const ForceResponse &a = of_left[0].at.at(0), b = mirrored_across(of_right[0].at.at(0));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_EQ(a.by_creepage[i][j], b.by_creepage[i][j]) << i << j;
    EXPECT_EQ(a.by_roughness[i], b.by_roughness[i]) << i;
  }
}

TEST(WheelResponse, IsByTheExactTheory) {
  WheelRail fast(s1002_on_60e1(), {});
  WheelRailSolution solution;
  EXPECT_THROW(fast.respond(running(0), load, std::array{1.0}, solution), Error);
  WheelRail solver(s1002_on_60e1(), exact(8));
  EXPECT_THROW(solver.respond(running(0), load, std::array{-1.0}, solution), Error);
  WheelState<double> high = running(0);
  high.vertical = 0.1;
  EXPECT_TRUE(solver.respond(high, {}, std::array{1.0}, solution).empty());
  EXPECT_EQ(solution.status, Status::no_contact);
}

} // namespace
} // namespace microslip
