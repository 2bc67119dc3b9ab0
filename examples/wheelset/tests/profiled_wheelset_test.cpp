#include "profiled_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using State = ProfiledWheelset::State;

const microslip::WheelRailBodies& bodies() {
  static const microslip::WheelRailBodies read = bodies_from(PROFILES);
  return read;
}

ProfiledParameters at_speed(double speed) {
  ProfiledParameters parameters;
  parameters.speed = speed;
  return parameters;
}

TEST(ProfiledWheelset, ReadsProfiles) {
  // The top of the rail's head and the wheel's tape circle at (0, 0), a flange of 28 mm.
  EXPECT_NEAR(bodies().rail.at(bodies().rail.length() / 2).value.z, 0, 1e-5);
  double highest = 0, lowest = 0;
  for (double s = 0; s < bodies().wheel.length(); s += 1e-4) {
    const auto at = bodies().wheel.at(s).value;
    highest = std::max(highest, at.z), lowest = std::min(lowest, at.z);
  }
  EXPECT_NEAR(lowest, -0.028, 1e-4);
  EXPECT_LT(highest, 0.01);
  EXPECT_THROW(read_profile("nowhere.prr", microslip::ProfileRole::rail), std::runtime_error);
}

TEST(ProfiledWheelset, RunsStraightOnInTheMiddle) {
  ProfiledWheelset wheelset(bodies(), at_speed(40));
  State rate;
  wheelset.rates(wheelset.standing(0), rate);
  for (const double r : rate) EXPECT_NEAR(r, 0, 2e-3);
}

TEST(ProfiledWheelset, LeftAndRightAreMirrorImages) {
  ProfiledWheelset wheelset(bodies(), at_speed(40));
  State z = wheelset.standing(3e-3);
  z[ProfiledWheelset::yaw] = 1e-3, z[ProfiledWheelset::lateral_rate] = 0.02, z[ProfiledWheelset::yaw_rate] = -0.01;
  State image = z, one, other;
  constexpr std::array odd = {ProfiledWheelset::lateral,      ProfiledWheelset::roll,      ProfiledWheelset::yaw,
                              ProfiledWheelset::lateral_rate, ProfiledWheelset::roll_rate, ProfiledWheelset::yaw_rate};
  for (const auto k : odd) image[k] = -z[k];
  wheelset.rates(z, one);
  wheelset.rates(image, other);
  for (const auto k : odd) other[k] = -other[k];
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_NEAR(one[k], other[k], 1e-9 * 100) << k;
}

TEST(ProfiledWheelset, JacobianIsThatOfTheRates) {
  const State steps = {1e-8, 1e-8, 1e-8, 1e-7, 1e-6, 1e-6, 1e-6, 1e-6, 1e-6};
  ProfiledParameters curve = in_curve(400, 0.1);
  for (const double displacement : {2e-3, -6.2e-3}) { // on the tread; on tread and flange
    ProfiledWheelset wheelset(bodies(), curve);
    State z = wheelset.standing(displacement);
    z[ProfiledWheelset::yaw] = 5e-4, z[ProfiledWheelset::lateral_rate] = 0.01, z[ProfiledWheelset::roll_rate] = 0.01;
    State rate, above, below;
    ProfiledWheelset::Jacobian jacobian;
    wheelset.rates(z, rate, jacobian);
    for (std::size_t j = 0; j < z.size(); ++j) {
      State left = z, right = z;
      left[j] -= steps[j], right[j] += steps[j];
      wheelset.rates(left, below);
      wheelset.rates(right, above);
      double largest = 0;
      State difference;
      for (std::size_t i = 0; i < z.size(); ++i) {
        difference[i] = (above[i] - below[i]) / (2 * steps[j]);
        largest = std::max(largest, std::abs(difference[i]));
      }
      for (std::size_t i = 0; i < z.size(); ++i)
        EXPECT_NEAR(jacobian[i][j], difference[i], 5e-3 * largest) << i << ", " << j;
    }
  }
}

TEST(ProfiledWheelset, GrowsAsTheEigenvaluesSay) {
  const auto [rate, frequency] = small_motion(bodies(), {}, 66);
  const ProfiledHistory small = run(bodies(), at_speed(66), 1e-6, 1);
  EXPECT_NEAR(small.growth_rate(0.2), rate, 0.01);
  const auto peaks = small.peaks();
  const double period = (peaks.back().time - peaks[2].time) / static_cast<double>(peaks.size() - 3) * 2;
  EXPECT_NEAR(2 * std::acos(-1.0) / period, frequency, 0.05);
  EXPECT_LT(small.newton_iterations, 3 * 1000);
  EXPECT_LT(small.jacobians, 10);
  EXPECT_LT(small_motion(bodies(), {}, 50).rate, 0);
  EXPECT_THROW(critical_speed(bodies(), {}, 20, 40), std::runtime_error);
}

TEST(ProfiledWheelset, HuntsBetweenTheFlanges) {
  ProfiledWheelset wheelset(bodies(), at_speed(68));
  const ProfiledHistory hunting = run(bodies(), at_speed(68), 6e-3, 0.8);
  EXPECT_GT(hunting.amplitude(0.4), 6e-3);
  EXPECT_LT(hunting.amplitude(0.4), 7e-3);
  double steepest = 0;
  for (std::size_t k = 400; k < hunting.states.size(); k += 2)
    for (const auto& patch : wheelset.contacts_in(hunting.states[k]).left.patches)
      steepest = std::max(steepest, patch.angle);
  EXPECT_GT(steepest, 0.4); // the root of the flange
  EXPECT_LT(hunting.halvings, 20);
}

TEST(ProfiledWheelset, RunsIntoTheOuterFlangeInACurve) {
  const ProfiledParameters parameters = in_curve(400, 0.1);
  const State z = enter_curve(bodies(), parameters, 3, 2e-3).states.back();
  EXPECT_LT(z[ProfiledWheelset::lateral], -4e-3); // a curve to the left: outwards is to the right
  ProfiledWheelset wheelset(bodies(), parameters);
  State rate;
  wheelset.rates(z, rate);
  for (std::size_t k = 0; k < rate.size(); ++k) EXPECT_NEAR(rate[k], 0, 0.01) << k;
  const auto contact = wheelset.contacts_in(z);
  EXPECT_NEAR(contact.force.z, parameters.axle_load, 1e-4 * parameters.axle_load);
  // The rails carry the unbalanced force and the spring's.
  EXPECT_NEAR(contact.force.y, parameters.axle_load * 0.1 / 1.5 + parameters.lateral_stiffness * z[0], 10);
  EXPECT_GT(flange_ratio(contact.right, -1), flange_ratio(contact.left, 1));
}

} // namespace
