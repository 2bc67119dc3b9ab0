// Forces of a wheel by its rows are continuous functions of the state, wherever contacts come, merge and split.

#include "microslip/railway/wheel_rail.hpp"
#include "tests/support/s1002_on_60e1.hpp"
#include "validation/jump.hpp"
#include "validation/worn_profiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace microslip {
namespace {

double change(const Vec3<double>& a, const Vec3<double>& b) {
  return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
}

/// The largest jump within 10 um about y of the horizontal force over mu times the load. FASTSIM2's march jumps a
/// little where sticking ends at a grid point: between both sides no height has the vertical force to rounding.
double jump_near(WheelRail& wheel, double y, double yaw, double force, int steps = 20) {
  constexpr int halvings = 30;
  const double step = 2e-5 / steps;
  const auto share = [&](double at) -> std::optional<Vec3<double>> {
    const WheelRailSolution s = wheel.solve(running(at, yaw), force);
    EXPECT_TRUE(s.status == Status::ok || s.reason == Unsolved::force_jumps) << at;
    EXPECT_LT(s.residual, 2e-5) << at;
    if (s.status != Status::ok) return {};
    double load = 0;
    for (const WheelRailPatch& patch : s.patches) load += patch.normal_force;
    return 1 / (0.3 * load) * Vec3<double>{s.force.x, s.force.y, 0};
  };
  double largest = 0;
  for (int k = -steps / 2; k < steps / 2; ++k)
    largest = std::max(largest, validation::jump_between(y + k * step, y + (k + 1) * step, halvings, share, change));
  return largest;
}

/// Where minima of the gap are equally deep, regions merge and a second lobe comes into contact.
TEST(WheelContinuity, ForcesDoNotJumpWhereLobesComeAndMerge) {
  const auto pairs = validation::worn_pairs();
  struct Place {
    std::size_t pair;
    double y, yaw, force;
  };
  for (const Place& p : {Place{0, 5.1708e-3, 2e-3, 80e3}, Place{0, 4.952e-3, 6e-3, 50e3}, Place{1, -3.284e-3, 0, 80e3},
                         Place{1, -3.272e-3, 0, 10e3}, Place{2, -4.28e-3, 0, 80e3}, Place{2, 4.768e-3, 2e-3, 150e3}}) {
    WheelRail wheel(pairs[p.pair].bodies, {});
    EXPECT_LT(jump_near(wheel, p.y, p.yaw, p.force), 2e-4) << pairs[p.pair].name << ", y = " << p.y;
  }
}

/// Elements come into contact with every micrometre or so, at 0.83 and 0.86 mm at a leading edge; at 4.762 mm a lobe
/// that the rows of the fast theory bear nothing on; at 5.05 and 5.63 mm on a flank whose frame turns with the height.
TEST(WheelContinuity, ForcesOfTheExactLevelDoNotJumpWhereElementsComeAndGo) {
  struct Place {
    double y, yaw, force;
  };
  WheelRail wheel(s1002_on_60e1(), {.theory = Theory::exact});
  for (const Place& p : {Place{0.835e-3, 2e-3, 80e3}, Place{0.865e-3, 2e-3, 80e3}, Place{4.762e-3, 2e-3, 80e3},
                         Place{5.055e-3, 2e-3, 80e3}, Place{5.63e-3, 0, 50e3}}) {
    EXPECT_LT(jump_near(wheel, p.y, p.yaw, p.force, 4), 5e-4) << "y = " << p.y;
  }
}

/// Between two patches a third one loses its load there: without it the others' loads must not depend on its stiffness.
TEST(WheelContinuity, APatchBetweenOthersThatLosesItsLoadLeavesThemAlone) {
  WheelRailBodies bodies = s1002_on_60e1();
  bodies.track.cant = 1.0 / 20;
  WheelRail wheel(bodies, {.theory = Theory::exact});
  EXPECT_LT(jump_near(wheel, 6.4635e-3, 2e-3, 150e3, 2), 1e-3);
}

/// The flange of a hollow wheel just touches, and the gap between it and the tread is deeper than the search reaches.
TEST(WheelContinuity, ContactsWithADeepHoleBetweenThemAreTwoPatches) {
  WheelRail wheel(validation::worn_pairs()[1].bodies, {});
  const WheelRailSolution s = wheel.solve(running(-3.45e-3, 0), 50e3);
  ASSERT_EQ(s.patches.size(), 2U);
  EXPECT_LT(std::abs(s.patches[0].place.y - s.patches[1].place.y), 0.06);
  EXPECT_GT(std::abs(s.patches[0].place.y - s.patches[1].place.y), 0.02);
}

} // namespace
} // namespace microslip
