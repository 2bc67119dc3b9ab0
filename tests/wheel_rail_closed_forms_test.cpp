// Loads and contact points of ellipsoidal wheels in closed form, under yaw and roll.

#include "microslip/elasticity/hertz.hpp"
#include "microslip/railway/wheel_rail.hpp"

#include "tests/support/steel.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace microslip {
namespace {

/// A crowned right wheel on a rail at y = 0.2 m, which is plane or a cylinder along the track.
WheelRailBodies bodies(double crown, double radius, double rail_curvature) {
  WheelRailBodies all{rail_curvature > 0 ? round_head(1 / rail_curvature)
                                         : profile_of(ProfileRole::rail, -0.06, 0.06, 1201, [](double) { return 0.0; }),
                      spherical_wheel(crown, 0.05),
                      {},
                      {},
                      TrackSide::right,
                      steel,
                      {{0, 0.3}}};
  all.track.rail_origin = ProfilePoint{0.2, 0};
  all.wheelset = {
      .flange_back_distance = 0.2, .flange_back_position = -0.1, .nominal_radius = radius, .tape_circle = {}};
  return all;
}

TEST(WheelRailClosedForms, AYawedSphereTouchesThePlaneWhereItsCentreIs) {
  const HertzContact hertz = hertz_from_approach({5, 5}, steel, 0.16e-3);
  WheelRail contact(bodies(0.1, 0.1, 0), {.theory = Theory::exact, .elements = 32});
  for (const double yaw : {0.0, 0.3, -0.1}) {
    WheelState<double> state;
    state.yaw = yaw, state.vertical = -0.16e-3;
    // Rolls along its plane: no creepage.
    state.pitch_velocity = 1, state.forward_velocity = 0.1 * std::cos(yaw),
    state.lateral_velocity = 0.1 * std::sin(yaw);
    const auto s = contact.solve(state);
    ASSERT_EQ(s.patches.size(), 1U);
    const WheelRailPatch& patch = s.patches[0];
    EXPECT_NEAR(patch.place.x, 0.2 * std::sin(yaw), 1e-12);
    EXPECT_NEAR(patch.place.y, -0.2 * std::cos(yaw), 1e-12);
    EXPECT_NEAR(patch.normal_force, hertz.normal_force, 1e-3 * hertz.normal_force);
    EXPECT_NEAR(patch.peak_pressure, hertz.peak_pressure, 2e-3 * hertz.peak_pressure);
    // The greatest overlap is that of an element's centre: a few percent less than 1.6e-3 of the radius.
    EXPECT_NEAR(patch.creepage.longitudinal, 0, 5e-5);
    EXPECT_NEAR(patch.creepage.lateral, 0, 5e-5);
    EXPECT_NEAR(patch.creepage.spin, 0, 1e-12);
  }
}

TEST(WheelRailClosedForms, PrincipalDirectionsOfTheGapNeedNotBeThoseOfTheTrack) {
  // Curvatures of an ellipsoid turned by the yaw angle, and of a cylinder along the track.
  const double crown = 0.4, radius = 0.1, rail = 7.5, yaw = 0.3, c = std::cos(yaw), s = std::sin(yaw);
  const double xx = c * c / radius + s * s / crown, xy = (1 / radius - 1 / crown) * c * s,
               yy = s * s / radius + c * c / crown + rail;
  const double mean = (xx + yy) / 2, half = std::hypot((xx - yy) / 2, xy);
  const HertzContact hertz = hertz_from_approach({(mean - half) / 2, (mean + half) / 2}, steel, 0.16e-3);
  for (const Theory theory : {Theory::fastsim2, Theory::exact}) {
    WheelRail contact(bodies(crown, radius, rail), {.theory = theory, .elements = 32});
    WheelState<double> state;
    state.vertical = -0.16e-3, state.deflection.yaw = yaw;
    const auto found = contact.solve(state);
    ASSERT_EQ(found.patches.size(), 1U);
    const double tolerance = theory == Theory::exact ? 1e-3 : 5e-3;
    EXPECT_NEAR(found.patches[0].normal_force, hertz.normal_force, tolerance * hertz.normal_force);
    EXPECT_NEAR(found.patches[0].peak_pressure, hertz.peak_pressure, 4 * tolerance * hertz.peak_pressure);
  }
}

} // namespace
} // namespace microslip
