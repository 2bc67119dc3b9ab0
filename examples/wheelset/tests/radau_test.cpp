#include "radau.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace {

/// Error at t = 1 of the pendulum y'' = -sin y from y = 1 at rest, against a fine solution.
Vector<2> pendulum(int steps) {
  Radau<2> integrator({1, 1});
  Vector<2> z = {1, 0};
  for (int k = 0; k < steps; ++k)
    integrator.advance(z, 1.0 / steps, [](const auto& at, auto& rate, auto&... jacobian) {
      rate = {at[1], -std::sin(at[0])};
      ((jacobian = {{{0, 1}, {-std::cos(at[0]), 0}}}), ...);
    });
  return z;
}

TEST(Radau, IsOfThirdOrder) {
  const double exact = pendulum(4000)[0];
  const double coarse = std::abs(pendulum(10)[0] - exact), fine = std::abs(pendulum(40)[0] - exact);
  EXPECT_NEAR(std::log2(coarse / fine) / 2, 3, 0.1);
}

TEST(Radau, KeepsItsJacobianWhereItServes) {
  Radau<2> integrator({1, 1});
  Vector<2> z = {1, 0};
  for (int k = 0; k < 1000; ++k)
    integrator.advance(z, 1e-3, [](const auto& at, auto& rate, auto&... jacobian) {
      rate = {at[1], -std::sin(at[0])};
      ((jacobian = {{{0, 1}, {-std::cos(at[0]), 0}}}), ...);
    });
  EXPECT_LE(integrator.jacobians(), 5);
  EXPECT_LE(integrator.iterations(), 3000);
}

TEST(Radau, DampsWhatIsTooFastForTheStep) {
  // z' = -1e6 (z - cos t): the start's deviation is gone after a few steps of 0.1.
  Radau<2> integrator({1, 1});
  Vector<2> z = {5, 0};
  for (int k = 0; k < 10; ++k)
    integrator.advance(z, 0.1, [](const auto& at, auto& rate, auto&... jacobian) {
      rate = {-1e6 * (at[0] - std::cos(at[1])), 1};
      ((jacobian = {{{-1e6, -1e6 * std::sin(at[1])}, {0, 0}}}), ...);
    });
  EXPECT_NEAR(z[0], std::cos(1.0), 1e-5);
}

TEST(Radau, ReproducesItsStabilityFunction) {
  // R(s) = (1 + s/3)/(1 - 2 s/3 + s^2/6) for z' = s z.
  Radau<1> integrator({1});
  Vector<1> z = {1};
  const double s = -0.7;
  integrator.advance(z, 1, [&](const auto& at, auto& rate, auto&... jacobian) {
    rate = {s * at[0]};
    ((jacobian = {{{s}}}), ...);
  });
  EXPECT_NEAR(z[0], (1 + s / 3) / (1 - 2 * s / 3 + s * s / 6), 1e-15);
}

TEST(Radau, CrossesJumps) {
  // z' = 1, from z = 0.33 on 3.
  Radau<1> integrator({1});
  Vector<1> z = {0};
  for (int k = 0; k < 10; ++k)
    integrator.advance(z, 0.1, [](const auto& at, auto& rate, auto&... jacobian) {
      rate = {at[0] < 0.33 ? 1.0 : 3.0};
      ((jacobian = {{{0}}}), ...);
    });
  EXPECT_NEAR(z[0], 0.33 + 0.67 * 3, 0.1);
}

TEST(Radau, StaysOnAJumpThatItCannotLeave) {
  // z' = 1 below 0, -2 above.
  Radau<1> integrator({1});
  Vector<1> z = {-0.25};
  for (int k = 0; k < 10; ++k)
    integrator.advance(z, 0.1, [](const auto& at, auto& rate, auto&... jacobian) {
      rate = {at[0] > 0 ? -2.0 : 1.0};
      ((jacobian = {{{0}}}), ...);
    });
  EXPECT_NEAR(z[0], 0, 0.01);
  EXPECT_GT(integrator.jumps(), 0);
}

TEST(Radau, SaysWhenNewtonsMethodFails) {
  Radau<1> integrator({1e-3});
  Vector<1> z = {0};
  const auto no_solution = [](const auto& at, auto& rate, auto&... jacobian) {
    rate = {at[0] > 0 ? -1.0 : 1.0};
    ((jacobian = {{{0}}}), ...);
  };
  EXPECT_THROW(integrator.advance(z, 1, no_solution), std::runtime_error);
  EXPECT_EQ(integrator.halvings(), 5);
}

} // namespace
