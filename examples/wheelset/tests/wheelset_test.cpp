#include "hunting.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace {

WheelsetParameters at_speed(double speed) {
  WheelsetParameters parameters;
  parameters.speed = speed;
  return parameters;
}

TEST(Wheelset, RunsStraightOnInTheMiddle) {
  Wheelset wheelset(at_speed(40));
  Wheelset::State rate;
  Wheelset::Jacobian jacobian;
  wheelset.rates({}, rate, jacobian);
  for (const double r : rate) EXPECT_NEAR(r, 0, 1e-10);
}

TEST(Wheelset, TurnsTowardsTheMiddleAndRunsWhereItPoints) {
  Wheelset wheelset(at_speed(40));
  Wheelset::State rate;
  Wheelset::Jacobian jacobian;
  wheelset.rates({1e-4, 0, 0, 0, 0}, rate, jacobian); // to the left: the larger left radius turns it to the right
  EXPECT_LT(rate[Wheelset::yaw_rate], 0);
  wheelset.rates({0, 1e-4, 0, 0, 0}, rate, jacobian); // yawed to the left: is driven to the left
  EXPECT_GT(rate[Wheelset::lateral_rate], 0);
}

TEST(Wheelset, LeftAndRightAreMirrorImages) {
  Wheelset wheelset(at_speed(40));
  Wheelset::State one, other;
  Wheelset::Jacobian jacobian;
  wheelset.rates({2e-3, 1e-3, 0.02, -0.01, 0.005}, one, jacobian);
  wheelset.rates({-2e-3, -1e-3, -0.02, 0.01, 0.005}, other, jacobian);
  for (const auto row : {Wheelset::lateral_rate, Wheelset::yaw_rate}) EXPECT_NEAR(one[row], -other[row], 1e-9 * 100);
  EXPECT_NEAR(one[Wheelset::rotation], other[Wheelset::rotation], 1e-9 * 100);
}

TEST(Wheelset, JacobianIsThatOfTheRates) {
  const Wheelset::State steps = {1e-8, 1e-8, 1e-7, 1e-7, 1e-7};
  Wheelset wheelset(at_speed(40));
  for (const Wheelset::State& z :
       {Wheelset::State{3e-3, 5e-4, 0.01, 0.005, 0.01}, Wheelset::State{-7.5e-3, 0, 0.1, 0, 0}}) {
    Wheelset::State rate, above, below;
    Wheelset::Jacobian jacobian, unused;
    wheelset.rates(z, rate, jacobian);
    for (std::size_t j = 0; j < Wheelset::states; ++j) {
      Wheelset::State left = z, right = z;
      left[j] -= steps[j], right[j] += steps[j];
      wheelset.rates(left, below, unused);
      wheelset.rates(right, above, unused);
      for (std::size_t i = 0; i < Wheelset::states; ++i) {
        const double difference = (above[i] - below[i]) / (2 * steps[j]);
        EXPECT_NEAR(jacobian[i][j], difference, 1e-3 * std::abs(difference) + 0.05) << i << ", " << j;
      }
    }
  }
}

TEST(Wheelset, CriticalSpeedIsNearWickens) {
  // Creep forces without slip make the wheelset follow Klingel's wave; where its frequency V sqrt(lambda/(r0 l)) is
  // that of the wheelset on its springs in the same shape of motion, nothing feeds or damps it.
  const WheelsetParameters p;
  const double l = p.half_gauge, stiffness = p.lateral_stiffness * l * l + p.yaw_stiffness;
  const double estimate = std::sqrt(p.radius * l / p.conicity * stiffness / (p.mass * l * l + p.yaw_inertia));
  EXPECT_NEAR(critical_speed(p), estimate, 0.01 * estimate);
  EXPECT_THROW(critical_speed(p, 5, 40), std::runtime_error);
}

TEST(Wheelset, GrowsAsTheEigenvaluesSay) {
  const double critical = critical_speed({});
  for (const double ratio : {0.8, 1.1}) {
    const auto small = run(at_speed(ratio * critical), 1e-6, 2);
    EXPECT_NEAR(small.growth_rate(1), linear_growth({}, ratio * critical).rate, 1e-3);
    const auto peaks = small.peaks();
    const double period = (peaks.back().time - peaks.front().time) / static_cast<double>(peaks.size() - 1) * 2;
    EXPECT_NEAR(2 * std::acos(-1.0) / period, linear_growth({}, ratio * critical).frequency, 0.05);
  }
}

TEST(Wheelset, BothCriticalSpeedsAgree) {
  const double critical = critical_speed({});
  EXPECT_NEAR(critical_speed_of_runs({}), critical, 1e-3 * critical);
}

TEST(Wheelset, DecaysBelowTheCriticalSpeed) {
  const double speed = 0.85 * critical_speed({});
  const auto below = run(at_speed(speed), 4e-3, 8);
  const double linear = 4e-3 * std::exp(7 * linear_growth({}, speed).rate); // when the last second begins
  EXPECT_LT(linear, 0.01 * 4e-3);
  EXPECT_NEAR(below.amplitude(1), linear, 0.3 * linear);
}

TEST(Wheelset, HuntsInALimitCycleAboveTheCriticalSpeed) {
  const WheelsetParameters parameters = at_speed(1.2 * critical_speed({}));
  const auto small = run(parameters, 0.1e-3, 8), large = run(parameters, 9e-3, 8);
  const double amplitude = small.amplitude(1);
  EXPECT_GT(amplitude, parameters.flange_clearance);
  EXPECT_LT(amplitude, parameters.flange_clearance + 3e-3);
  EXPECT_NEAR(large.amplitude(1), amplitude, 1e-3 * amplitude);
  EXPECT_NEAR(small.amplitude(2), amplitude, 1e-3 * amplitude);
}

} // namespace
