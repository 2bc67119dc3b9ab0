#include "microslip/friction/line_traction_bound.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double a = 2e-3, load = 1e6, mu = 0.3;

TEST(LineTractionBound, IntegratesToTheSlidingForce) {
  for (const auto shape : {TractionBound::parabolic, TractionBound::elliptic}) {
    constexpr int n = 100000;
    double sum = 0;
    for (int k = 0; k < n; ++k) sum += line_traction_bound(shape, a, load, mu, a * ((2 * k + 1.0) / n - 1)) * 2 * a / n;
    EXPECT_NEAR(sum / (mu * load), 1, 1e-7);
  }
}

TEST(LineTractionBound, EllipticBoundIsFrictionTimesHertzsPressure) {
  const LineContact line = line_contact_from_load(1, steel, load);
  for (int i = -12; i <= 12; ++i) {
    const double x = 0.1 * i * line.half_width;
    EXPECT_NEAR(line_traction_bound(TractionBound::elliptic, line.half_width, load, mu, x), mu * line.pressure(x),
                1e-14 * line.peak_pressure);
  }
}

TEST(LineTractionBound, VanishesOnAndBeyondTheEdge) {
  for (const auto shape : {TractionBound::parabolic, TractionBound::elliptic})
    for (const double x : {a, -a, 1.5 * a}) EXPECT_EQ(line_traction_bound(shape, a, load, mu, x), 0);
  EXPECT_DOUBLE_EQ(line_traction_bound(TractionBound::parabolic, a, load, mu, 0), 0.75 * mu * load / a);
}

TEST(LineTractionBound, RefusesWhatMakesNoSense) {
  EXPECT_THROW(line_traction_bound(TractionBound::elliptic, 0, load, mu, 0), Error);
  EXPECT_THROW(line_traction_bound(TractionBound::elliptic, a, -1, mu, 0), Error);
  EXPECT_THROW(line_traction_bound(TractionBound::elliptic, a, load, 11, 0), Error);
}

} // namespace
} // namespace microslip
