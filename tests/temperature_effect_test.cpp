// What heat adds to friction, and friction that heats itself.

#include "microslip/friction/temperature_effect.hpp"

#include "tests/support/expect_error.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace microslip {
namespace {

TEST(TemperatureEffect, GrowsFromNothingToTheWholeChange) {
  const TemperatureEffect effect = {.change = -0.2, .begin = 100, .range = 400};
  EXPECT_EQ(effect.at(-50), 0);
  EXPECT_EQ(effect.at(100), 0);
  EXPECT_DOUBLE_EQ(effect.at(200), -0.05);
  EXPECT_DOUBLE_EQ(effect.at(500), -0.2);
  EXPECT_DOUBLE_EQ(effect.at(1e6), -0.2);
}

/// mu = base + share at(ahead + own mu), and no smaller mu between cold friction and this one does it.
TEST(TemperatureEffect, FrictionThatHeatsItselfSolvesItsEquation) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> any(0, 1);
  int on_ramp = 0, jumps = 0;
  for (int n = 0; n < 3000; ++n) {
    const double base = 0.05 + 0.5 * any(engine), share = any(engine);
    const TemperatureEffect effect = {
        .change = n % 2 == 0 ? -base * any(engine) : 2 * any(engine), .begin = 100, .range = 1 + 200 * any(engine)};
    const double ahead = 300 * any(engine), own = 1000 * any(engine) * any(engine);
    const auto excess = [&](double mu) { return base + share * effect.at(ahead + own * mu) - mu; };
    const double mu = effect.coefficient(base, share, ahead, own);
    EXPECT_NEAR(excess(mu), 0, 1e-12);
    const double towards = effect.change < 0 ? -1 : 1; // the excess has this sign until the first solution
    for (const double part : {0.0, 0.3, 0.9, 0.999})
      if (const double before = base + part * (mu - base); std::abs(mu - before) > 1e-9) {
        EXPECT_GT(towards * excess(before), 0) << n;
      }
    const bool between = std::abs(mu - base) > 1e-9 && std::abs(mu - base - share * effect.change) > 1e-9;
    on_ramp += between;
    jumps += share * effect.change * own > effect.range;
  }
  EXPECT_GT(on_ramp, 500);
  EXPECT_GT(jumps, 100);
}

TEST(TemperatureEffect, NamesWhatIsOutOfRange) {
  expect_error([] { check({.change = NAN, .begin = 0, .range = 1}); }, "temperature_effect.change", "[-]");
  expect_error([] { check({.change = 0, .begin = INFINITY, .range = 1}); }, "temperature_effect.begin", "[deg C]");
  expect_error([] { check({.change = 0, .begin = 0, .range = 0}); }, "temperature_effect.range", "[K]");
}

} // namespace
} // namespace microslip
