// What makes results of wheels on rails doubtful: each line of the table of warnings that concerns them, met and not.

#include "microslip/railway/wheel_warnings.hpp"

#include "microslip/railway/vehicle/wheelset_on_track.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "tests/support/s1002_on_60e1.hpp"
#include "validation/worn_profiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace microslip {
namespace {

WheelRailBodies pair() {
  static const WheelRailBodies new_profiles = validation::worn_pairs().front().bodies;
  return new_profiles;
}

WheelRailSolution solve(const WheelRailBodies& bodies, double lateral, double force,
                        const WheelRailMethod& method = {}) {
  return WheelRail(bodies, method).solve(running(lateral), force);
}

TEST(WheelWarnings, PlausibleWheelsHaveNone) {
  for (const double lateral : {-5e-3, 0.0, 3e-3, 5e-3})
    for (const double force : {1e3, 40e3, 100e3}) {
      const auto s = solve(pair(), lateral, force);
      EXPECT_EQ(s.status, Status::ok);
      EXPECT_EQ(s.warnings, Warnings()) << s.warnings.texts().at(0);
    }
}

TEST(WheelWarnings, PressuresBeyondYieldAndBeyondElasticity) {
  // By Hertz pressures grow like the cube root of the load; E = 210 GPa.
  EXPECT_FALSE(solve(pair(), 0, 300e3).warnings.has(Warning::high_pressure));
  const auto high = solve(pair(), 0, 8e6);
  EXPECT_TRUE(high.warnings.has(Warning::high_pressure));
  EXPECT_EQ(high.status, Status::ok);
  WheelRailBodies soft = pair();
  soft.material.shear_modulus = 1e6; // moduli in MPa: 80 kN on rubber
  const auto deep = solve(soft, 0, 80e3);
  EXPECT_TRUE(deep.warnings.has(Warning::soft_material));
  EXPECT_TRUE(deep.warnings.has(Warning::deep_approach));
}

/// Pressures that no steel bears are no result.
TEST(WheelWarnings, ExtremePressuresCannotBeMeant) {
  WheelRailBodies edged = pair();
  std::vector<ProfilePoint> points; // the columns of a file exchanged: the rail lies on its side
  for (const ProfilePiece& piece : edged.rail.pieces()) points.push_back({piece.c[0].z, piece.c[0].y});
  edged.rail = Profile(ProfileRole::rail, points);
  edged.track.rail_origin = ProfilePoint{0.75, 0};
  for (const Theory theory : {Theory::fastsim2, Theory::exact}) {
    const auto s = solve(edged, 0, 200e3, {.theory = theory, .elements = 12});
    EXPECT_EQ(s.status, Status::implausible) << to_string(s.status) << ", " << to_string(s.reason);
    EXPECT_TRUE(s.warnings.has(Warning::extreme_pressure));
    EXPECT_EQ(s.reason, Unsolved::implausible);
    EXPECT_NEAR(s.force.z, 200e3, 1) << "it is solved all the same";
  }
}

TEST(WheelWarnings, SurfacesThatYieldInEachPassage) {
  WheelRailBodies bodies = pair();
  bodies.strength.shear_yield_strength = 400e6;
  EXPECT_FALSE(solve(bodies, 0, 80e3).warnings.has(Warning::plastic_flow));
  bodies.strength.shear_yield_strength = 100e6;
  EXPECT_TRUE(solve(bodies, 0, 80e3).warnings.has(Warning::plastic_flow));
}

TEST(WheelWarnings, LoadsInKilonewtons) {
  EXPECT_TRUE(solve(pair(), 0, 80).warnings.has(Warning::light_load));
  EXPECT_FALSE(solve(pair(), 0, 600).warnings.has(Warning::light_load));
}

TEST(WheelWarnings, FlangesThatClimbAndWheelsThatHaveDerailed) {
  WheelState<double> climbing = running(8e-3);
  climbing.yaw = -30e-3;
  const auto on_flank = WheelRail(pair()).solve(climbing, 20e3);
  ASSERT_TRUE(on_flank.y_over_q && on_flank.nadal_limit);
  EXPECT_EQ(on_flank.warnings.has(Warning::flange_climbing), *on_flank.y_over_q > *on_flank.nadal_limit);
  EXPECT_TRUE(on_flank.warnings.has(Warning::flange_climbing)) << *on_flank.y_over_q << ", " << *on_flank.nadal_limit;
  EXPECT_FALSE(on_flank.warnings.has(Warning::derailed));
  const auto on_tip = solve(pair(), 30e-3, 50e3);
  EXPECT_TRUE(on_tip.warnings.has(Warning::derailed)) << to_string(on_tip.status);
}

TEST(WheelWarnings, AWheelThatHasLifted) {
  WheelsetOnTrack wheelset(pair());
  const auto loaded = [&](double moment) {
    WheelsetState state;
    state.left = running(0);
    return wheelset.solve(state, {.vertical = AxleLoad{100e3, moment}, .axle_torque = 0.0});
  };
  const auto even = loaded(0), lifted = loaded(100e3 * 0.75);
  EXPECT_FALSE(even.warnings.has(Warning::wheel_lifted));
  EXPECT_TRUE(is_solved(lifted.status)) << to_string(lifted.reason);
  EXPECT_TRUE(lifted.warnings.has(Warning::wheel_lifted)) << lifted.left.force.z << ", " << lifted.right.force.z;
}

/// Each as the other: a wheel's profile is higher outside than in the middle, a rail's lower.
TEST(WheelWarnings, ProfilesThatAreExchanged) {
  const auto as = [](ProfileRole role, const Profile& other) {
    std::vector<ProfilePoint> points;
    for (const ProfilePiece& piece : other.pieces()) points.push_back(piece.c[0]);
    if ((points.front().y > points.back().y) == (role == ProfileRole::rail)) std::reverse(points.begin(), points.end());
    return Profile(role, points);
  };
  EXPECT_EQ(warnings_of(pair()), Warnings());
  WheelRailBodies bodies = pair();
  bodies.rail = as(ProfileRole::rail, pair().wheel);
  EXPECT_TRUE(warnings_of(bodies).has(Warning::exchanged_profile));
  bodies = pair();
  bodies.wheel = as(ProfileRole::wheel, pair().rail);
  EXPECT_TRUE(warnings_of(bodies).has(Warning::exchanged_profile));
}

/// On a hollow wheel the rolling radius is far from linear across the patch; in small contacts on a new tread a plane
/// hardly matters.
TEST(WheelWarnings, FlatPatchesWhereTheSurfacesAreNot) {
  const WheelRailMethod flat{.theory = Theory::exact, .shape = PatchShape::flat, .elements = 12};
  auto true_surface = flat;
  true_surface.shape.reset();
  const auto all = validation::worn_pairs();
  const auto hollow = std::ranges::find(all, "hollow wheel", &validation::ProfilePair::name);
  ASSERT_NE(hollow, all.end());
  int needed = 0;
  for (const double lateral : {-3e-3, 0.0, 2e-3, 5e-3}) {
    const auto plane = solve(hollow->bodies, lateral, 100e3, flat),
               truth = solve(hollow->bodies, lateral, 100e3, true_surface);
    EXPECT_FALSE(truth.warnings.has(Warning::flat_surface));
    const double change = std::hypot(plane.force.x - truth.force.x, plane.force.y - truth.force.y) / (0.3 * 100e3);
    if (change <= 0.02) continue;
    ++needed;
    EXPECT_TRUE(plane.warnings.has(Warning::flat_surface)) << lateral << ": " << change;
  }
  EXPECT_GT(needed, 0);
  EXPECT_FALSE(solve(pair(), -3e-3, 2e3, flat).warnings.has(Warning::flat_surface));
}

} // namespace
} // namespace microslip
