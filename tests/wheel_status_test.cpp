// Status, reason and numbers of a wheel on a rail agree, whatever the state is; no number makes a solve throw.

#include "microslip/railway/problem/wheel_status.hpp"

#include "io/creep_table_file.hpp"
#include "io/creep_tables.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "tests/support/numbers.hpp"
#include "validation/random_wheels.hpp"
#include "validation/worn_profiles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace microslip {
namespace {

using validation::contradiction;
using validation::LoadedState;
using validation::ProfilePair;
using validation::random_state;

constexpr double tolerance = 1e-6;

const std::vector<ProfilePair>& pairs() {
  static const std::vector<ProfilePair> all = validation::worn_pairs();
  return all;
}

WheelRail wheel_of(const ProfilePair& pair, Theory theory, double friction) {
  static const auto table = std::make_shared<const CreepForceTable>(io::read_creep_table(io::shipped_creep_table()),
                                                                    pairs().front().bodies.material.poisson_ratio);
  WheelRailBodies bodies = pair.bodies;
  bodies.friction = {{0, friction}};
  return WheelRail(bodies, {.theory = theory, .elements = 12, .table = table});
}

constexpr Theory theories[] = {Theory::fastsim2, Theory::table, Theory::exact};

/// A solved state of one patch.
WheelRailSolution solved() {
  WheelRailSolution s;
  s.force = {100, 200, 50e3}, s.residual = 1e-8, s.vertical = -1e-4;
  s.patches.emplace_back().normal_force = 50e3;
  return s;
}

TEST(WheelStatus, OkIsFiniteAndBelowTheTolerance) {
  WheelRailSolution s = solved();
  conclude(s, 0, tolerance);
  EXPECT_EQ(s.status, Status::ok);
  EXPECT_EQ(s.reason, Unsolved::none);

  s = solved(), s.residual = 2e-6;
  conclude(s, 0, tolerance);
  EXPECT_EQ(s.status, Status::not_converged);
  EXPECT_EQ(s.reason, Unsolved::residual);

  s = solved(), s.patches[0].status = Status::not_converged;
  conclude(s, 0, tolerance);
  EXPECT_EQ(s.status, Status::not_converged);
  EXPECT_EQ(s.reason, Unsolved::tractions);
  EXPECT_GT(s.residual, tolerance) << "a residual below the tolerance is that of a solution";

  for (double WheelRailPatch::*number : {&WheelRailPatch::peak_pressure, &WheelRailPatch::fx, &WheelRailPatch::angle}) {
    s = solved(), s.patches[0].*number = nan;
    conclude(s, 0.01, tolerance);
    EXPECT_EQ(s.status, Status::not_converged);
    EXPECT_EQ(s.reason, Unsolved::numbers);
    EXPECT_TRUE(s.patches.empty());
    EXPECT_EQ(s.force.x, 0);
    EXPECT_EQ(s.vertical, 0.01);
  }
}

TEST(WheelStatus, WithoutContactThereAreNoForces) {
  WheelRailSolution s = solved();
  s.status = Status::no_contact;
  conclude(s, 0, tolerance);
  EXPECT_TRUE(s.patches.empty());
  EXPECT_EQ(s.force.x, 0);
  EXPECT_EQ(s.force.z, 0);
  EXPECT_EQ(s.reason, Unsolved::apart);
}

TEST(WheelStatus, WhateverIsNotOkHasAReason) {
  for (const Status status :
       {Status::invalid_input, Status::not_converged, Status::no_contact, Status::no_solution, Status::implausible}) {
    WheelRailSolution s = solved();
    s.status = status;
    conclude(s, 0, tolerance);
    EXPECT_EQ(s.status, status);
    EXPECT_NE(s.reason, Unsolved::none) << to_string(status);
    EXPECT_FALSE(to_string(s.reason).empty());
  }
}

/// Up to flange climbing on steep flanks, where friction pulls the wheel down: states on whose flanks an earlier
/// version gave up with an error, for all states of a call.
TEST(WheelStatus, FlanksWithMuchFrictionGiveAStatus) {
  LoadedState one;
  one.state.lateral = 0.006577823564, one.state.yaw = 0.02717795, one.state.forward_velocity = -30, one.force = 7863.4;
  for (const Theory theory : theories) {
    WheelRail level_track = wheel_of(pairs().front(), theory, 0.5);
    WheelRailSolution s;
    ASSERT_NO_THROW(level_track.solve(one.state, one.force, s));
    EXPECT_EQ(contradiction(s, one.force), "");
    WheelRailDerivatives derivatives;
    ASSERT_NO_THROW(level_track.differentiate(one.state, one.force, s, derivatives));
  }
  for (const double friction : {0.4, 0.6}) {
    WheelRail wheel = wheel_of(pairs().front(), Theory::fastsim2, friction);
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
      LoadedState s = random_state(seed);
      s.state.lateral = 5.5e-3 + 0.15 * std::abs(s.state.lateral), s.state.yaw = std::abs(s.state.yaw);
      WheelRailSolution out;
      ASSERT_NO_THROW(wheel.solve(s.state, s.force, out)) << seed;
      EXPECT_EQ(contradiction(out, s.force), "") << seed;
    }
  }
}

TEST(WheelStatus, RandomStatesOnWornAndMeasuredProfiles) {
  for (const ProfilePair& pair : pairs())
    for (const Theory theory : theories) {
      WheelRail wheel = wheel_of(pair, theory, 0.3);
      const std::uint64_t count = theory == Theory::exact ? 60 : 150;
      for (std::uint64_t seed = 0; seed < count; ++seed) {
        const LoadedState one = random_state(seed);
        WheelRailSolution s;
        ASSERT_NO_THROW(wheel.solve(one.state, one.force, s)) << pair.name << ", " << seed;
        EXPECT_EQ(contradiction(s, one.force), "") << pair.name << ", " << seed;
      }
    }
}

/// States whose vertical force is continuous in the height have a solution.
TEST(WheelStatus, ContinuousForcesAreFound) {
  WheelRailBodies bodies = pairs().front().bodies;
  WheelRail wheel(bodies);
  WheelState<double> state;
  state.lateral = 7.1330335e-3, state.yaw = 36.776778e-3, state.forward_velocity = -30;
  const auto s = wheel.solve(state, 142316.42);
  EXPECT_EQ(s.status, Status::ok) << to_string(s.reason);
  EXPECT_NEAR(s.force.z, 142316.42, 0.3);
}

TEST(WheelStatus, NumbersBeyondAllBoundsGiveAStatus) {
  const double extremes[] = {0, 1e-320, 1e-300, 1e-9, 1, 1e9, 1e150, 1e300, -1e300, HUGE_VAL, nan};
  for (const Theory theory : theories) {
    WheelRail wheel = wheel_of(pairs().front(), theory, 0.3);
    for (const StateQuantity& quantity : state_quantities())
      for (const double extreme : extremes) {
        WheelState<double> state;
        state.forward_velocity = 20, state.pitch_velocity = 20 / 0.46;
        quantity.of(state) = extreme;
        WheelRailSolution s;
        WheelRailDerivatives d;
        ASSERT_NO_THROW(wheel.differentiate(state, 50e3, s, d)) << quantity.name << " = " << extreme;
        if (s.status == Status::invalid_input) continue;
        EXPECT_EQ(contradiction(s, 50e3), "") << quantity.name << " = " << extreme;
        for (const double value : d.values) EXPECT_TRUE(std::isfinite(value)) << quantity.name;
      }
    for (const double force : extremes) {
      WheelRailSolution s;
      ASSERT_NO_THROW(wheel.solve({}, force, s)) << force;
      EXPECT_TRUE(s.status == Status::invalid_input || contradiction(s, force).empty()) << force;
    }
  }
}

/// Heavily loaded wheels on the gauge corner: patches in the throat and on the head of which one has the other's frame,
/// so that its elements are far from the frame's origin and turned against it.
TEST(WheelStatus, PatchesInTheFrameOfOthersAreSolved) {
  WheelRailBodies bodies = pairs().front().bodies;
  bodies.track.cant = 0.05, bodies.friction = {{0, 0.3}};
  WheelRail wheel(bodies, {.theory = Theory::exact});
  WheelState<double> state;
  state.yaw = 2e-3, state.forward_velocity = 20, state.pitch_velocity = 20 / 0.46;
  double lateral_force = 0;
  for (const double lateral : {0.00637, 0.0064, 0.00644, 0.0064575}) { // at the last one a third hardly bears load
    state.lateral = lateral;
    const WheelRailSolution s = wheel.solve(state, 150e3);
    EXPECT_EQ(s.status, Status::ok) << to_string(s.reason);
    EXPECT_GE(s.patches.size(), 2U);
    EXPECT_LT(s.force.y, lateral_force);
    EXPECT_EQ(contradiction(s, 150e3), "");
    lateral_force = s.force.y;
  }
}

/// The same at a large angle of attack with little friction.
TEST(WheelStatus, ThroatsAreSolvedOverAllOfTheirOverlap) {
  WheelRailBodies bodies = pairs().front().bodies;
  bodies.friction = {{0, 0.1}};
  WheelRail wheel(bodies, {.theory = Theory::exact});
  WheelState<double> state;
  state.lateral = 0.0073855, state.yaw = 0.0162745, state.roll = -0.0019794;
  state.forward_velocity = 20, state.pitch_velocity = 43.49095;
  state.lateral_velocity = -0.06368, state.yaw_velocity = -0.0064114;
  const WheelRailSolution s = wheel.solve(state, 140359.65);
  EXPECT_EQ(s.status, Status::ok) << to_string(s.reason);
  EXPECT_EQ(contradiction(s, 140359.65), "");
}

} // namespace
} // namespace microslip
