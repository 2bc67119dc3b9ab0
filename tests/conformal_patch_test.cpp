// Conformal patches with the theory exact: planes, small patches, mirror images, work and convergence.

#include "microslip/railway/wheel_rail.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/steel.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double friction = 0.3;

/// A wheel's groove of 13.5 mm over a rail's arc of 13 mm.
WheelRailBodies groove() {
  const auto arc = [](double radius) { return [=](double y) { return std::sqrt(radius * radius - y * y) - radius; }; };
  return {
      .rail = profile_of(ProfileRole::rail, -0.0115, 0.0115, 461, arc(0.013)),
      .wheel = profile_of(ProfileRole::wheel, -0.0115, 0.0115, 461, arc(0.0135)),
      .track = {.rail_origin = ProfilePoint{0.7, 0}},
      .wheelset = {.flange_back_distance = 1.4, .flange_back_position = 0, .nominal_radius = 0.46, .tape_circle = {}},
      .material = steel,
      .friction = {{0, friction}}};
}

/// Creeps by `xi` along and by `eta` across the track, m/s over the speed.
WheelState<double> creeping(double xi, double eta = 0) {
  WheelState<double> s;
  s.forward_velocity = 20, s.pitch_velocity = 20 * (1 - xi) / 0.46, s.lateral_velocity = 20 * eta;
  return s;
}

WheelRailSolution solve(const WheelRailBodies& bodies, PatchShape shape, const WheelState<double>& state, double force,
                        int elements = 20) {
  WheelRail contact(bodies, {.theory = Theory::exact, .shape = shape, .elements = elements});
  return contact.solve(state, force);
}

/// By how much the tangential force differs, of mu Fz.
double difference(const WheelRailSolution& a, const WheelRailSolution& b) {
  return std::hypot(a.force.x - b.force.x, a.force.y - b.force.y) / (friction * a.force.z);
}

TEST(ConformalPatch, RowsInOnePlaneAreACurvedPatchBitForBit) {
  WheelRailBodies bodies = groove();
  bodies.rail = profile_of(ProfileRole::rail, -0.03, 0.03, 61, [](double) { return 0; });
  bodies.wheel = spherical_wheel(0.46);
  const auto curved = solve(bodies, PatchShape::curved, creeping(1e-3, 5e-4), 50e3);
  const auto conformal = solve(bodies, PatchShape::conformal, creeping(1e-3, 5e-4), 50e3);
  ASSERT_EQ(conformal.status, Status::ok);
  EXPECT_EQ(curved.force.x, conformal.force.x);
  EXPECT_EQ(curved.force.y, conformal.force.y);
  EXPECT_EQ(curved.vertical, conformal.vertical);
}

/// The square of the angle over which a patch turns falls with the load to the power 2/3.
TEST(ConformalPatch, SmallPatchesAreCurvedOnes) {
  double before = 1;
  for (const double force : {8e3, 1e3, 125.0}) {
    const auto curved = solve(groove(), PatchShape::curved, creeping(1e-3), force);
    const auto conformal = solve(groove(), PatchShape::conformal, creeping(1e-3), force);
    ASSERT_EQ(conformal.status, Status::ok);
    const double p = curved.patches.at(0).peak_pressure;
    const double change = std::abs(conformal.patches.at(0).peak_pressure - p) / p;
    EXPECT_LT(change, 0.5 * before) << force;
    before = change;
  }
  EXPECT_LT(before, 1e-3);
}

/// Rows that are turned against one another move less under each other's pressures than half-spaces would: under the
/// same load the wheel sinks in less, and more rows bear it.
TEST(ConformalPatch, TheWheelSinksInLess) {
  const auto curved = solve(groove(), PatchShape::curved, creeping(1e-3), 20e3);
  const auto conformal = solve(groove(), PatchShape::conformal, creeping(1e-3), 20e3);
  ASSERT_EQ(conformal.status, Status::ok);
  EXPECT_NEAR(conformal.force.z, 20e3, 0.1);
  EXPECT_GT(conformal.vertical, curved.vertical);
  EXPECT_NEAR(conformal.vertical, curved.vertical, 0.1 * curved.patches.at(0).approach);
  EXPECT_LT(conformal.patches.at(0).peak_pressure, curved.patches.at(0).peak_pressure);
}

TEST(ConformalPatch, MirrorImagesHaveMirroredForces) {
  WheelState<double> state = creeping(5e-4, 2e-3);
  state.lateral = 1e-4;
  const auto right = solve(groove(), PatchShape::conformal, state, 15e3);
  state.lateral *= -1, state.lateral_velocity *= -1;
  const auto left = solve(groove(), PatchShape::conformal, state, 15e3);
  ASSERT_EQ(right.status, Status::ok);
  ASSERT_EQ(left.status, Status::ok);
  EXPECT_GT(std::abs(right.force.y), 100);
  EXPECT_NEAR(right.force.x, left.force.x, 2e-6 * 15e3);
  EXPECT_NEAR(right.force.y, -left.force.y, 2e-6 * 15e3);
  EXPECT_NEAR(right.vertical, left.vertical, 1e-10);
}

/// What the wheel's forces lose is what friction takes: elastic bodies give back what they store, since their influence
/// is reciprocal.
TEST(ConformalPatch, FrictionTakesTheWorkOfTheWheel) {
  for (const PatchShape shape : {PatchShape::curved, PatchShape::conformal}) {
    const WheelState<double> state = creeping(8e-3);
    const auto s = solve(groove(), shape, state, 20e3, 32);
    ASSERT_EQ(s.status, Status::ok);
    const double work = s.force.x * state.forward_velocity + s.moment.y * state.pitch_velocity;
    double lost = 0;
    for (const WheelRailPatch& patch : s.patches) lost += patch.frictional_power;
    EXPECT_NEAR(-work / lost, 1, 0.02);
  }
}

TEST(ConformalPatch, ConvergesWithTheElements) {
  const auto with = [](int elements) { return solve(groove(), PatchShape::conformal, creeping(1e-3), 10e3, elements); };
  const auto coarse = with(12), middle = with(24), fine = with(48);
  ASSERT_EQ(fine.status, Status::ok);
  EXPECT_LT(difference(middle, fine), 0.45 * difference(coarse, middle) + 1e-4);
  EXPECT_LT(difference(middle, fine), 5e-3);
  EXPECT_NEAR(middle.vertical, fine.vertical, 5e-3 * fine.patches.at(0).approach);
}

/// Elements are fitted anew where tractions have changed the pressure's shape, and stay where they have not.
TEST(ConformalPatch, PressuresAreSmoothInTheLoad) {
  WheelRailBodies bodies = groove();
  const auto arc = [](double y) { return std::sqrt(0.0132 * 0.0132 - y * y) - 0.0132; };
  bodies.wheel = profile_of(ProfileRole::wheel, -0.0115, 0.0115, 461, arc);
  const auto peak = [&](double force) {
    return solve(bodies, PatchShape::conformal, creeping(1e-3), force, 24).patches.at(0).peak_pressure;
  };
  for (const double force : {36e3, 37e3, 38e3})
    EXPECT_NEAR((peak(force - 1e3) + peak(force + 1e3)) / 2 / peak(force), 1, 5e-4) << force;
}

TEST(ConformalPatch, NeedsTheLevelExact) {
  EXPECT_EQ(error_of([] { WheelRail(groove(), {.shape = PatchShape::conformal}); }),
            "shape: the rows of fastsim2 follow the surface: curved, or left out");
}

} // namespace
} // namespace microslip
