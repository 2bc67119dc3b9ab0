#include "microslip/railway/geometry/wheel_placement.hpp"

#include "microslip/error.hpp"

#include "tests/support/expect_close.hpp"
#include "tests/support/expect_error.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace microslip {
namespace {

/// A rail whose head is a circle, from `from` to `to` [rad] off its top; its profile's origin is anywhere.
Profile round_rail(double radius, double from, double to, ProfilePoint origin = {}) {
  std::vector<ProfilePoint> points;
  for (int k = 0; k <= 400; ++k) {
    const double angle = from + (to - from) * k / 400;
    points.push_back({origin.y + radius * std::sin(angle), origin.z + radius * (std::cos(angle) - 1)});
  }
  return Profile(ProfileRole::rail, points);
}

Profile conical_wheel(double inclination) {
  std::vector<ProfilePoint> points;
  for (int k = 0; k <= 10; ++k) points.push_back({-0.07 + 0.0135 * k, inclination * (-0.07 + 0.0135 * k)});
  return Profile(ProfileRole::wheel, points);
}

/// Where the gauge point of the placed rail is in track axes, half the gauge from the middle.
TEST(Track, PlacesTheGaugePointOfARoundRail) {
  const double r = 0.05, h = 0.014, y = std::sqrt(r * r - (r - h) * (r - h));
  for (const double cant : {0.0, 0.025, -0.05}) {
    Track track;
    track.cant = cant;
    track.gauge_height = h;
    const Frame<double> frame = place_rail(track, round_rail(r, -1.3, 1.2));
    // the circle's centre lies r below the profile's origin, its gauge point y beside it and its top r above it
    const Vec3<double> centre = frame.outer({0, 0, -r});
    EXPECT_NEAR(centre.y, track.gauge / 2 + y, 1e-9);
    EXPECT_NEAR(centre.z, -r, 1e-10);
  }
}

TEST(Track, GaugePointOfAnUndercutRailLiesAboveTheGaugeHeight) {
  const double r = 0.013;
  Track track;
  track.gauge_height = 0.016;
  EXPECT_NEAR(place_rail(track, round_rail(r, -2, 1.2)).origin.y, track.gauge / 2 + r, 1e-9);
}

TEST(Track, PlacesTheRailIndependentlyOfItsProfilesOrigin) {
  Track track;
  track.cant = 0.025;
  const Profile rail = round_rail(0.05, -1.2, 1.2), moved = round_rail(0.05, -1.2, 1.2, {0.3, -0.02});
  const Frame<double> a = place_rail(track, rail), b = place_rail(track, moved);
  for (const double s : {0.01, 0.05, 0.1}) {
    const ProfilePoint p = rail.at(s).value, q = moved.at(s).value;
    const Vec3<double> u = a.outer({0, p.y, p.z}), v = b.outer({0, q.y, q.z});
    EXPECT_NEAR(u.y, v.y, 1e-14);
    EXPECT_NEAR(u.z, v.z, 1e-14);
  }
}

TEST(Track, RefusesWhatItCannotPlace) {
  Track track;
  expect_error([&] { place_rail(track, round_rail(0.05, -0.3, 1.2)); }, "gauge_height", "at most");
  EXPECT_THROW(place_rail(track, round_rail(0.05, 0, 1.2)), Error);
  track.gauge = -1.435;
  expect_error([&] { place_rail(track, round_rail(0.05, -1.2, 1.2)); }, "gauge", "[m]");
}

TEST(Wheelset, HasItsRadiusOnTheTapeCircle) {
  Wheelset wheelset;
  const Profile wheel = conical_wheel(0.025);
  EXPECT_DOUBLE_EQ(place_wheel(wheelset, wheel).lateral, 0.75);
  EXPECT_DOUBLE_EQ(place_wheel(wheelset, wheel).radius, 0.46);
  wheelset.tape_circle = 0.01;
  const WheelPlace place = place_wheel(wheelset, wheel);
  EXPECT_NEAR(place.radius - 0.025 * 0.01, 0.46, 1e-15);
  wheelset.tape_circle = 0.1;
  expect_error([&] { place_wheel(wheelset, wheel); }, "tape_circle", "within");
  wheelset = {};
  wheelset.nominal_radius = 1e-3;
  expect_error([&] { place_wheel(wheelset, wheel); }, "nominal_radius", "more than");
}

WheelState<double> some_state() {
  WheelState<double> s;
  s.lateral = 4e-3, s.vertical = -1e-3, s.roll = 0.02, s.yaw = 0.03;
  s.forward_velocity = 20, s.lateral_velocity = 0.1, s.vertical_velocity = -0.2;
  s.roll_velocity = 0.3, s.pitch_velocity = 43, s.yaw_velocity = -0.5;
  s.curvature = 1 / 300.0;
  s.deflection = {1e-3, 2e-3, -1e-3, 3e-3, -2e-3, 0.1, 0.2, -0.1, 0.3, 0.2, 0.1};
  s.rail = {1e-3, -2e-3, 0.01, 0.05, -0.02, 0.04};
  return s;
}

NominalPlacement some_placement() {
  return {{{0, 0.76, 0.001}, rotation_about_x(0.025)}, {0.75, 0.4602}, 0.46};
}

/// Of the right side, with the axes of the track.
NominalPlacement right_placement() {
  NominalPlacement p = some_placement();
  p.rail.origin.y *= -1;
  p.rail.axes = rotation_about_x(-0.025);
  p.wheel.lateral *= -1;
  return p;
}

TEST(WheelPlacement, ARightWheelIsTheMirrorImageOfALeftOne) {
  const auto right = place(right_placement(), some_state());
  const auto left = place(some_placement(), some_state().mirrored());
  const auto mirror = [](const Vec3<double>& v) { return Vec3<double>{v.x, -v.y, v.z}; };
  const auto turn = [](const Vec3<double>& v) { return Vec3<double>{-v.x, v.y, -v.z}; };
  const auto compare = [&](const MovingFrame<double>& a, const MovingFrame<double>& b) {
    expect_near(a.frame.origin, mirror(b.frame.origin), 1e-15);
    expect_near(a.frame.axes.ex, mirror(b.frame.axes.ex), 1e-15);
    expect_near(a.frame.axes.ez, mirror(b.frame.axes.ez), 1e-15);
    expect_near(a.velocity, mirror(b.velocity), 1e-13);
    expect_near(a.angular_velocity, turn(b.angular_velocity), 1e-13);
  };
  compare(right.rail, left.rail);
  compare(right.wheel, left.wheel);
}

TEST(WheelPlacement, VelocitiesAreRatesOfPositions) {
  // At angles of zero the rates of roll and yaw are the angular velocities; a particle's tau falls as the wheel rolls
  // on.
  using Number = Dual<double, 1>;
  const Number t = Number::variable(0.0, 0);
  WheelState<double> s = some_state();
  s.roll = s.yaw = s.deflection.roll = s.deflection.yaw = s.rail.roll = s.curvature = 0;
  WheelState<Number> moving;
  moving.lateral = s.lateral + s.lateral_velocity * t;
  moving.vertical = s.vertical + s.vertical_velocity * t;
  moving.roll = s.roll_velocity * t;
  moving.yaw = s.yaw_velocity * t;
  const auto& flex = s.deflection;
  moving.deflection.longitudinal = flex.longitudinal + flex.longitudinal_velocity * t;
  moving.deflection.lateral = flex.lateral + flex.lateral_velocity * t;
  moving.deflection.vertical = flex.vertical + flex.vertical_velocity * t;
  moving.deflection.roll = flex.roll_velocity * t;
  moving.deflection.yaw = flex.yaw_velocity * t;
  moving.rail.lateral = s.rail.lateral + s.rail.lateral_velocity * t;
  moving.rail.vertical = s.rail.vertical + s.rail.vertical_velocity * t;
  moving.rail.roll = s.rail.roll_velocity * t;

  const auto at_rest = place(some_placement(), moving);
  const auto still = place(some_placement(), s);
  const double tau = 0.2, y = -0.03, z = -0.01;
  const Number spin = s.pitch_velocity + flex.pitch_velocity;
  const auto wheel = at_rest.wheel_point(Number(tau) - spin * t, y, z);
  Vec3<double> expected = still.wheel.velocity_at(still.wheel_point(tau, y, z));
  expected.x -= s.forward_velocity;
  expect_near({wheel.x.partial[0], wheel.y.partial[0], wheel.z.partial[0]}, expected, 1e-12);

  const auto rail = at_rest.rail_point(Number(0.01), Number(y), Number(z));
  expect_near({rail.x.partial[0], rail.y.partial[0], rail.z.partial[0]},
              still.rail.velocity_at(still.rail_point(0.01, y, z)), 1e-13);
}

TEST(WheelPlacement, InACurveTheOuterRailRunsFasterUnderTheWheel) {
  WheelState<double> s;
  s.forward_velocity = 10;
  s.curvature = 0.01; // to the left: the left rail is the inner one
  const auto placed = place(some_placement(), s);
  expect_near(placed.rail.velocity_at({0.2, 0.75, 0}), {0.1 * 0.75, -0.1 * 0.2, 0}, 1e-15);
}

TEST(WheelPlacement, ALoweredWheelTouchesWhereItsRadiusSays) {
  WheelState<double> s;
  const auto placed = place(some_placement(), s);
  const Vec3<double> lowest = placed.wheel_point(0.0, 0.01, 0.003);
  expect_near(lowest, {0, 0.76, 0.46 - (0.4602 - 0.003)}, 1e-15);
}

} // namespace
} // namespace microslip
