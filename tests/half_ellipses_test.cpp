// Two half ellipses of contact.

#include "microslip/elasticity/half_ellipses.hpp"

#include "microslip/friction/traction_bound.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr HalfEllipses contact = {.a = 2e-3, .b_negative = 1e-3, .b_positive = 4e-3, .normal_force = 5000};

TEST(HalfEllipses, EqualHalvesAreHertzs) {
  constexpr HalfEllipses even = {.a = 2e-3, .b_negative = 3e-3, .b_positive = 3e-3, .normal_force = 5000};
  for (const double x : {0.0, 1e-3, -1.9e-3})
    for (const double y : {0.0, -2e-3, 2.9e-3})
      EXPECT_NEAR(even.pressure(x, y), traction_bound(TractionBound::elliptic, 2e-3, 3e-3, 5000, 1, x, y), 1e-3);
}

TEST(HalfEllipses, PressureAddsUpToTheForce) {
  constexpr int n = 1000;
  double sum = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) sum += contact.pressure((2. * i + 1 - n) / n * 2e-3, (2. * j + 1 - n) / n * 2.5e-3);
  EXPECT_NEAR(sum * 4e-3 * 5e-3 / (n * n), 5000, 0.1);
}

TEST(HalfEllipses, AreaIsCentredAndLongestBesideTheMiddle) {
  const double peak = 3 * 5000 / (2 * std::numbers::pi * 2e-3 * 2.5e-3);
  EXPECT_NEAR(contact.pressure(0, -1.5e-3), peak, 1e-6 * peak);
  EXPECT_GT(contact.pressure(1.999e-3, -1.5e-3), 0);
  EXPECT_EQ(contact.pressure(2.001e-3, -1.5e-3), 0);
  EXPECT_GT(contact.pressure(0, -2.499e-3), 0);
  EXPECT_GT(contact.pressure(0, 2.499e-3), 0);
  EXPECT_EQ(contact.pressure(0, -2.501e-3), 0);
  EXPECT_EQ(contact.pressure(0, 2.501e-3), 0);
}

} // namespace
} // namespace microslip
