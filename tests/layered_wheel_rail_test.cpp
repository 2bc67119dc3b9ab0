// Layers on wheel and rail by the theory exact.

#include "microslip/rolling/solver.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/s1002_on_60e1.hpp"
#include "tests/support/sphere_on_rail.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double radius = 0.46, head = 0.3, vertical_force = 60e3;
const Material steel_body = {82e9, 0.28};
const LayeredBody half_space = {{}, {steel_body}};
const WheelRailMethod flat = {.theory = Theory::exact, .shape = PatchShape::flat, .elements = 20};

WheelRailBodies with(const std::optional<LayeredBodies>& layered) {
  WheelRailBodies bodies = sphere_on_rail(radius, head);
  bodies.layered = layered;
  return bodies;
}

/// A wheel that brakes a little and yaws.
WheelState<double> braked() {
  WheelState<double> state;
  state.forward_velocity = 20, state.pitch_velocity = 20 / radius * 0.999, state.yaw = 0.5e-3;
  return state;
}

WheelRailSolution solve(const WheelRailBodies& bodies, const WheelRailMethod& method = flat) {
  WheelRailSolution s = WheelRail(bodies, method).solve(braked(), vertical_force);
  EXPECT_EQ(s.status, Status::ok);
  EXPECT_EQ(s.patches.size(), 1U);
  return s;
}

/// The same contact by curvatures, with the creepages that the patch has.
ContactSolution between_two_bodies(const LayeredBodies& layered, const WheelRailPatch& patch) {
  RollingProblem p;
  p.geometry = GapCurvatures{0.5 / radius, 0.5 / radius + 0.5 / head};
  p.layered = layered;
  p.load = {NormalLoad::Given::force, patch.normal_force};
  p.friction.law = FrictionLaw::coulomb(0.3);
  p.motion.creepage = patch.creepage;
  p.motion.rolling_speed = braked().forward_velocity;
  return Solver({.theory = Theory::exact, .mx = flat.elements, .my = flat.elements}).solve(p);
}

LayeredBodies with_layer(double thickness, const Material& material) {
  return {half_space, {{{thickness, {material}}}, {steel_body}}};
}

/// A layer of the rail's material changes nothing but the discretisation, which is classical: heights and pressures
/// stay, forces are 2 to 4 % larger on 20 elements.
TEST(LayeredWheelRail, ALayerOfTheSameMaterialIsNone) {
  const WheelRailSolution plain = solve(with({})), none = solve(with(LayeredBodies{half_space, half_space})),
                          equal = solve(with(with_layer(1e-3, steel_body)));
  EXPECT_NEAR(equal.force.x, none.force.x, 1e-6 * std::abs(none.force.x));
  EXPECT_NEAR(equal.force.y, none.force.y, 1e-6 * std::abs(none.force.x));
  EXPECT_NEAR(none.vertical, plain.vertical, 1e-5 * std::abs(plain.vertical));
  EXPECT_NEAR(none.patches[0].peak_pressure, plain.patches[0].peak_pressure, 5e-3 * plain.patches[0].peak_pressure);
  EXPECT_NEAR(none.force.x, plain.force.x, 0.05 * std::abs(plain.force.x));
  EXPECT_NEAR(none.force.y, plain.force.y, 0.05 * std::abs(plain.force.y));
}

/// A soft layer on the rail, or on the wheel, is that of the same two bodies: it halves the forces of small creepages.
TEST(LayeredWheelRail, IsTheContactOfTwoBodies) {
  const double without = solve(with({})).force.x;
  const LayeredBodies on_rail = with_layer(1e-4, {1e9, 0.4}), on_wheel = {on_rail.body2, on_rail.body1};
  for (const LayeredBodies& layered : {on_rail, on_wheel})
    for (const PatchShape shape : {PatchShape::flat, PatchShape::curved}) {
      WheelRailMethod method = flat;
      method.shape = shape;
      const WheelRailSolution s = solve(with(layered), method);
      const ContactSolution expected = between_two_bodies(layered, s.patches[0]);
      ASSERT_EQ(expected.report.status, Status::ok);
      const double force = std::hypot(expected.totals.fx, expected.totals.fy);
      EXPECT_NEAR(s.force.x, expected.totals.fx, 0.02 * force); // elements lie otherwise across the patch
      EXPECT_NEAR(s.force.y, expected.totals.fy, 0.02 * force);
      EXPECT_NEAR(s.force.z, vertical_force, 1e-5 * vertical_force);
      EXPECT_NEAR(-s.vertical, expected.approach, 1e-3 * expected.approach);
      EXPECT_NEAR(s.patches[0].peak_pressure, expected.totals.peak_pressure, 0.01 * expected.totals.peak_pressure);
      EXPECT_LT(std::abs(s.force.x), 0.6 * std::abs(without));
    }
}

/// On profiles the wheel sinks in further, with less pressure.
TEST(LayeredWheelRail, OnProfiles) {
  WheelRailBodies bodies = s1002_on_60e1(TrackSide::left);
  WheelRailMethod method = flat;
  method.shape = PatchShape::curved;
  method.elements = 12;
  WheelState<double> state;
  state.lateral = 5e-3, state.forward_velocity = 20, state.pitch_velocity = 20 / bodies.wheelset.nominal_radius * 0.999;
  const WheelRailSolution plain = WheelRail(bodies, method).solve(state, 80e3);
  bodies.layered = with_layer(5e-5, {1e9, 0.4});
  const WheelRailSolution soft = WheelRail(bodies, method).solve(state, 80e3);
  ASSERT_EQ(plain.status, Status::ok);
  ASSERT_EQ(soft.status, Status::ok);
  EXPECT_NEAR(soft.force.z, 80e3, 1e-5 * 80e3);
  EXPECT_LT(soft.vertical, plain.vertical); // z points upwards
  EXPECT_LT(soft.patches[0].peak_pressure, plain.patches[0].peak_pressure);
}

TEST(LayeredWheelRail, RefusesWhatItCannotHonour) {
  const WheelRailBodies soft = with(with_layer(1e-4, {1e9, 0.4}));
  const auto refusal = [](const WheelRailBodies& bodies, WheelRailMethod method) {
    return error_of([&] { WheelRail(bodies, method); });
  };
  WheelRailMethod method = flat;
  method.theory = Theory::fastsim2, method.shape.reset();
  EXPECT_NE(refusal(soft, method).find("theory exact"), std::string::npos);
  for (const std::optional<PatchShape> shape : {std::optional<PatchShape>{}, {PatchShape::conformal}}) {
    method = flat;
    method.shape = shape;
    EXPECT_NE(refusal(soft, method).find("curved or flat"), std::string::npos);
  }
  WheelRailBodies other = soft;
  other.layered->body2.layers[0].material.shear_relaxation = {{0.5, 1e-3}};
  EXPECT_NE(refusal(other, flat).find("elastic"), std::string::npos);
  other = soft;
  other.layered->body2.layers[0].thickness = -1;
  EXPECT_NE(refusal(other, flat).find("rail.layers[0].thickness"), std::string::npos) << refusal(other, flat);
}

} // namespace
} // namespace microslip
