// Forces of a wheel by its rows are continuous functions of the state, wherever contacts come, merge and split.

#include "microslip/railway/wheel_rail.hpp"
#include "tests/support/s1002_on_60e1.hpp"
#include "validation/worn_profiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

/// The horizontal force over mu times the load.
Vec3<double> share(WheelRail& wheel, double y, double yaw, double force) {
  const WheelRailSolution s = wheel.solve(running(y, yaw), force);
  EXPECT_EQ(s.status, Status::ok) << y;
  double load = 0;
  for (const WheelRailPatch& patch : s.patches) load += patch.normal_force;
  return 1 / (0.3 * load) * Vec3<double>{s.force.x, s.force.y, 0};
}

double change(const Vec3<double>& a, const Vec3<double>& b) {
  return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
}

/// What is left of the largest change within 20 um about y when the interval is halved towards it.
double jump_near(WheelRail& wheel, double y, double yaw, double force) {
  constexpr int steps = 40, halvings = 30;
  constexpr double step = 0.5e-6;
  double low = y, largest = 0;
  Vec3<double> before = share(wheel, y - steps / 2 * step, yaw, force);
  for (int k = 1 - steps / 2; k <= steps / 2; ++k) {
    const Vec3<double> here = share(wheel, y + k * step, yaw, force);
    if (change(before, here) > largest) largest = change(before, here), low = y + (k - 1) * step;
    before = here;
  }
  double high = low + step;
  Vec3<double> at_low = share(wheel, low, yaw, force), at_high = share(wheel, high, yaw, force);
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    const Vec3<double> there = share(wheel, middle, yaw, force);
    if (change(at_low, there) > change(there, at_high))
      high = middle, at_high = there;
    else
      low = middle, at_low = there;
  }
  return change(at_low, at_high);
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
