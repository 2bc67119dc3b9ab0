// Rails that vary along the track, wheels that are not round, rollers.

#include "microslip/elasticity/hertz.hpp"
#include "microslip/railway/geometry/equivalent_rail.hpp"
#include "microslip/railway/wheel_rail.hpp"

#include "tests/support/expect_close.hpp"
#include "tests/support/numbers.hpp"
#include "tests/support/steel.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

namespace microslip {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 0.1; // of wheels and heads [m]

/// Slices of a profile, each with what `moved` makes of its points.
std::shared_ptr<const ProfileSurface> slices(const Profile& profile, const std::vector<double>& u,
                                             const std::function<ProfilePoint(double u, ProfilePoint)>& moved) {
  std::vector<SurfaceSlice> all;
  for (const double at : u) {
    SurfaceSlice& slice = all.emplace_back(SurfaceSlice{at, 0, {}});
    for (const ProfilePiece& piece : profile.pieces()) slice.points.push_back(moved(at, piece.c[0]));
    slice.points.push_back(moved(at, profile.at(profile.length()).value));
  }
  SurfaceOptions options;
  options.is_wheel = profile.role() == ProfileRole::wheel;
  return std::make_shared<const ProfileSurface>(std::move(all), options);
}

/// A sphere on a round head along the track.
WheelRailBodies sphere_on_cylinder() {
  WheelRailBodies bodies{profile_of(ProfileRole::rail, -0.03, 0.03, 241,
                                    [](double y) { return std::sqrt(radius * radius - y * y) - radius; }),
                         profile_of(ProfileRole::wheel, -0.03, 0.03, 241,
                                    [](double y) { return radius - std::sqrt(radius * radius - y * y); }),
                         {},
                         {},
                         TrackSide::left,
                         steel,
                         {{0, 0.3}}};
  bodies.track.rail_origin = ProfilePoint{0.7, 0};
  bodies.wheelset = {
      .flange_back_distance = 1.4, .flange_back_position = 0, .nominal_radius = radius, .tape_circle = {}};
  return bodies;
}

/// A sphere on a roller that is part of a sphere with the radius `roller` [m].
WheelRailBodies sphere_on_roller(double roller) {
  WheelRailBodies bodies = sphere_on_cylinder();
  bodies.rail = profile_of(ProfileRole::rail, -0.06, 0.06, 481,
                           [=](double y) { return std::sqrt(roller * roller - y * y) - roller; });
  bodies.track.roller_radius = roller;
  return bodies;
}

WheelState<double> rolling(double lateral, double yaw = 0) {
  WheelState<double> s;
  s.lateral = lateral, s.yaw = yaw;
  s.forward_velocity = 10, s.pitch_velocity = 10 / radius * 1.001;
  return s;
}

const std::vector<double> along_track = equal_steps(-0.5, 0.5, 11), around_wheel = equal_steps(-pi, pi, 41);

class GeneralSurfaces : public testing::TestWithParam<Theory> {
protected:
  WheelRail solver(const WheelRailBodies& bodies) const { return WheelRail(bodies, {.theory = GetParam()}); }
};
INSTANTIATE_TEST_SUITE_P(Levels, GeneralSurfaces, testing::Values(Theory::fastsim2, Theory::exact),
                         [](const auto& level) { return level.param == Theory::exact ? "exact" : "fastsim2"; });

void expect_alike(const WheelRailSolution& a, const WheelRailSolution& b, double tolerance, double of_place = 1e-6) {
  ASSERT_EQ(a.status, Status::ok);
  ASSERT_EQ(b.status, Status::ok);
  ASSERT_EQ(a.patches.size(), b.patches.size());
  expect_near(a.force, b.force, tolerance * b.force.z);
  EXPECT_NEAR(a.patches[0].peak_pressure, b.patches[0].peak_pressure, tolerance * b.patches[0].peak_pressure);
  EXPECT_NEAR(a.patches[0].place.x, b.patches[0].place.x, of_place);
}

TEST_P(GeneralSurfaces, OfEqualSlicesAreTheFixedProfiles) {
  const WheelRailBodies fixed = sphere_on_cylinder();
  WheelRailBodies sliced = fixed;
  const auto same = [](double, ProfilePoint p) { return p; };
  sliced.rail_surface = slices(fixed.rail, along_track, same);
  sliced.wheel_surface = slices(fixed.wheel, around_wheel, same);
  for (const double lateral : {0.0, 0.01}) {
    const WheelState<double> state = rolling(lateral, 0.02);
    const auto a = solver(sliced).solve(state, 5e3), b = solver(fixed).solve(state, 5e3);
    expect_alike(a, b, 2e-4);
    EXPECT_NEAR(a.vertical, b.vertical, 1e-8);
  }
}

TEST_P(GeneralSurfaces, OfAWheelOfAnotherRadiusAreThatWheel) {
  constexpr double larger = 1e-3;
  WheelRailBodies sliced = sphere_on_cylinder(), fixed = sliced;
  sliced.wheel_surface = slices(fixed.wheel, around_wheel, [](double, ProfilePoint p) {
    return ProfilePoint{p.y, p.z - larger};
  });
  fixed.wheelset.nominal_radius += larger;
  const WheelState<double> state = rolling(0.004, 0.01);
  const auto a = solver(sliced).solve(state, 5e3), b = solver(fixed).solve(state, 5e3);
  expect_alike(a, b, 2e-4);
  EXPECT_NEAR(a.vertical, b.vertical + larger, 1e-8);
  EXPECT_NEAR(a.patches[0].rolling_radius, b.patches[0].rolling_radius, 1e-8);
}

TEST_P(GeneralSurfaces, OfAnEccentricWheelCarryItUpAndDown) {
  constexpr double off = 2e-4; // of the wheel's centre from the axle [m]
  WheelRailBodies bodies = sphere_on_cylinder();
  const Profile wheel = bodies.wheel;
  // The circle of radius rho about a point at the distance `off` from the axle, towards theta = 0.
  bodies.wheel_surface = slices(wheel, around_wheel, [](double theta, ProfilePoint p) {
    const double rho = radius - p.z, s = off * std::sin(theta);
    return ProfilePoint{p.y, radius - (off * std::cos(theta) + std::sqrt(rho * rho - s * s))};
  });
  const WheelRailBodies fixed = sphere_on_cylinder();
  for (const double pitch : {0.0, 1.0, -2.5, 7.0}) {
    WheelState<double> state = rolling(0);
    const auto round = solver(fixed).solve(state, 5e3);
    state.pitch = pitch;
    WheelRailSolution found;
    WheelRailDerivatives d;
    WheelRail contact = solver(bodies);
    contact.differentiate(state, 5e3, found, d);
    ASSERT_EQ(found.status, Status::ok);
    EXPECT_NEAR(found.vertical, round.vertical + off * std::cos(pitch), 2e-8) << pitch;
    EXPECT_NEAR(d.vertical(pitch_number), -off * std::sin(pitch), 1e-2 * off) << pitch;
    EXPECT_NEAR(d.vertical(longitudinal_number), 0, 1e-5);
    EXPECT_NEAR(found.patches[0].place.x, -off * std::sin(pitch), 2e-7);
  }
}

TEST_P(GeneralSurfaces, OfARampLiftTheWheel) {
  constexpr double slope = 0.02;
  WheelRailBodies bodies = sphere_on_cylinder();
  const auto level = solver(bodies).solve(rolling(0), 5e3);
  bodies.rail_surface = slices(bodies.rail, along_track, [](double u, ProfilePoint p) {
    return ProfilePoint{p.y, p.z + slope * u};
  });
  WheelRail contact = solver(bodies);
  for (const double place : {-0.3, 0.1}) {
    WheelState<double> state = rolling(0);
    state.longitudinal = place;
    WheelRailSolution found;
    WheelRailDerivatives d;
    contact.differentiate(state, 5e3, found, d);
    ASSERT_EQ(found.status, Status::ok);
    // a circle on a straight line
    EXPECT_NEAR(found.vertical, level.vertical + slope * place + radius * (std::hypot(1, slope) - 1), 3e-8);
    EXPECT_NEAR(found.patches[0].place.x, radius * slope, 1e-2 * radius * slope);
    EXPECT_NEAR(d.vertical(longitudinal_number), slope, 1e-3 * slope);
    EXPECT_NEAR(d.vertical(static_cast<std::size_t>(WheelVariable::deflection_longitudinal)), slope, 1e-3 * slope);
    EXPECT_NEAR(d.force(longitudinal_number).y, 0, 1);
    // At rest the force passes through the axle.
    state.forward_velocity = state.pitch_velocity = 0;
    const auto resting = contact.solve(state, 5e3);
    EXPECT_NEAR(resting.force.x / resting.force.z, -slope, 1e-2 * slope);
    EXPECT_NEAR(resting.moment.y, 0, 1e-2 * slope * radius * 5e3);
  }
}

TEST_P(GeneralSurfaces, OfARailThatMovesAsideAreADeviation) {
  constexpr double aside = 0.01, rise = 0.004; // of a metre of track
  WheelRailBodies bodies = sphere_on_cylinder();
  WheelRail fixed = solver(bodies);
  bodies.rail_surface = slices(bodies.rail, {-1, 0, 1, 2}, [](double u, ProfilePoint p) {
    const double t = u * u; // level at u = 0
    return ProfilePoint{p.y + aside * t, p.z + rise * t};
  });
  WheelState<double> state = rolling(0.003);
  const auto there = fixed.solve(state, 5e3);
  expect_alike(solver(bodies).solve(state, 5e3), there, 3e-3);
}

TEST_P(GeneralSurfaces, OfRollersAreThoseOfHertz) {
  // A sphere on a roller that is part of a sphere: no yaw matters.
  constexpr double roller = 0.2;
  WheelRail contact = solver(sphere_on_roller(roller));
  const HertzContact hertz = hertz_from_load(gap_curvatures({radius, roller, radius, roller}), steel, 5e3);
  for (const double yaw : {0.0, 0.03})
    for (const double lateral : {0.0, 0.015}) {
      WheelState<double> state; // at rest
      state.lateral = lateral + 0.7 * (1 - std::cos(yaw)), state.yaw = yaw;
      state.longitudinal = 0.7 * std::sin(yaw); // so that the sphere's centre is over the roller's
      const double angle = -std::asin(lateral / (radius + roller)), fine = GetParam() == Theory::exact ? 1 : 8;
      const auto s = contact.solve(state, 5e3 * std::cos(angle));
      ASSERT_EQ(s.status, Status::ok);
      ASSERT_EQ(s.patches.size(), 1u);
      const double height = std::sqrt(std::pow(radius + roller, 2) - lateral * lateral) - radius - roller;
      EXPECT_NEAR((height - s.vertical) * std::cos(angle) / hertz.approach, 1, 4e-3 * fine) << yaw << " " << lateral;
      EXPECT_NEAR(s.patches[0].peak_pressure / hertz.peak_pressure, 1, 0.01 * fine);
      EXPECT_NEAR(s.patches[0].place.x, 0, 2e-6);
      EXPECT_NEAR(s.patches[0].angle, angle, 3e-4);
    }
}

TEST(GeneralSurfaces, OfRollersHaveTheDerivativesOfSpheres) {
  // With the load held the force stays on the line from the sphere's centre to the roller's.
  constexpr double roller = 0.2;
  WheelRail contact(sphere_on_roller(roller));
  constexpr auto lateral = static_cast<std::size_t>(WheelVariable::lateral);
  for (const auto& [load, accuracy] : {std::pair{100.0, 0.03}, std::pair{5e3, 1e-3}, std::pair{5e4, 1e-3}})
    for (const double y : {0.003, 0.015}) {
      WheelState<double> state; // at rest
      state.lateral = y;
      WheelRailSolution found;
      WheelRailDerivatives d;
      contact.differentiate(state, load, found, d);
      ASSERT_EQ(found.status, Status::ok);
      const double sine = y / (radius + roller), cosine = std::sqrt(1 - sine * sine);
      EXPECT_NEAR(found.force.y / load, sine / cosine, 1e-3 * sine);
      EXPECT_NEAR(d.force(lateral).y / load, 1 / (radius + roller) / std::pow(cosine, 3), accuracy / (radius + roller));
      EXPECT_NEAR(d.vertical(lateral), -sine / cosine, 3e-3 * sine);
    }
}

/// Least height of a wheel's points over a roller's head [m], z up: sampled around the wheel, finer about the least
/// one. The head is where its z is a function of y.
double height_over_roller(const WheelRailBodies& bodies, const WheelState<double>& state) {
  const WheelPlacement<double> placed =
      place(nominal_placement(bodies.track, bodies.rail, bodies.wheelset, bodies.wheel), state);
  const double roller = bodies.track.roller_radius;
  std::vector<ProfilePoint> head;
  for (const double s : equal_steps(0, bodies.rail.length(), 20001)) {
    const ProfilePoint p = bodies.rail.at(s).value;
    if (head.empty() || p.y > head.back().y) head.push_back(p);
  }
  const auto height = [&](double s, double tau) {
    const ProfilePoint on_wheel = bodies.wheel.at(s).value;
    const Vec3<double> q = placed.rail.frame.inner(placed.wheel_point(tau, on_wheel.y, on_wheel.z));
    const auto next =
        std::lower_bound(head.begin(), head.end(), q.y, [](const ProfilePoint& p, double y) { return p.y < y; });
    if (next == head.begin() || next == head.end() || std::abs(q.x) >= std::abs(roller) / 2) return infinity;
    const ProfilePoint &a = next[-1], &b = next[0];
    const double z = a.z + (b.z - a.z) * (q.y - a.y) / (b.y - a.y);
    return q.z - (std::copysign(std::sqrt(std::pow(roller + z, 2) - q.x * q.x), roller) - roller);
  };
  double least = infinity, s0 = bodies.wheel.length() / 2, tau0 = 0, reach_s = s0, reach_tau = 0.4;
  for (int count = 301; reach_s > 1e-6; count = 21) {
    double best_s = s0, best_tau = tau0;
    for (const double ds : equal_steps(-reach_s, reach_s, count))
      for (const double dtau : equal_steps(-reach_tau, reach_tau, count)) {
        const double s = std::clamp(s0 + ds, 0.0, bodies.wheel.length()), h = height(s, tau0 + dtau);
        if (h < least) least = h, best_s = s, best_tau = tau0 + dtau;
      }
    s0 = best_s, tau0 = best_tau, reach_s *= 4.0 / (count - 1), reach_tau *= 4.0 / (count - 1);
  }
  return least;
}

TEST(GeneralSurfaces, StandOnRollersAtAnyYaw) {
  // Beneath the fillet of its flange a yawed wheel is near a rail in two places along the track; on a roller neither is
  // where the other is nearest.
  struct Case {
    double lateral, yaw, roll; // [m], [rad], [rad]
  };
  std::vector<Case> cases = {{4.84e-3, -0.08144, 1.1e-4}, {-4.9e-4, -0.08077, 2.42e-3}, {-3.63e-3, -0.08815, 1.02e-3}};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int k = 0; k < 5; ++k) cases.push_back({8e-3 * share(random), 0.1 * share(random), 3e-3 * share(random)});
  WheelRailBodies bodies = sphere_on_cylinder();
  bodies.rail = example_profile("60e1.prr"), bodies.wheel = example_profile("s1002.prw");
  bodies.track = {}, bodies.wheelset = {};
  bodies.track.cant = 0.025;
  for (const double roller : {0.5, 0.1, -1.0}) {
    bodies.track.roller_radius = roller;
    WheelRail contact(bodies);
    for (const auto& [lateral, yaw, roll] : cases) {
      WheelState<double> state;
      state.lateral = lateral, state.yaw = yaw, state.roll = roll;
      const WheelRailSolution found = contact.solve(state, 1e3);
      ASSERT_EQ(found.status, Status::ok) << roller << " " << lateral << " " << yaw;
      state.vertical = found.vertical;
      const double height = height_over_roller(bodies, state);
      EXPECT_LT(height, 0) << roller << " " << lateral << " " << yaw;
      EXPECT_GT(height, -1e-4) << roller << " " << lateral << " " << yaw; // what 1 kN presses into it
    }
  }
}

TEST_P(GeneralSurfaces, OfALargeRollerAreThoseOfARail) {
  WheelRailBodies bodies = sphere_on_cylinder();
  const WheelState<double> state = rolling(0.005, 0.01);
  const auto rail = solver(bodies).solve(state, 5e3);
  bodies.track.roller_radius = 90;
  const auto roller = solver(bodies).solve(state, 5e3);
  bodies.track.roller_radius = -90;
  const auto raceway = solver(bodies).solve(state, 5e3);
  expect_alike(roller, rail, 5e-3, 1e-5);
  expect_alike(raceway, rail, 5e-3, 1e-5);
  // On the line from the sphere's centre to the axle.
  const double x = rail.patches[0].place.x;
  EXPECT_NEAR(roller.patches[0].place.x, x * 90 / (90 + radius), 1e-8);
  EXPECT_NEAR(raceway.patches[0].place.x, x * 90 / (90 - radius), 1e-8);
  // Curvatures are those of the rail plus or minus a ninetieth.
  EXPECT_NEAR(roller.vertical + raceway.vertical, 2 * rail.vertical, 2e-9);
}

TEST(EquivalentRail, OfFixedProfilesIsTheRail) {
  const WheelRailBodies bodies = sphere_on_cylinder();
  const NominalPlacement nominal = nominal_placement(bodies.track, bodies.rail, bodies.wheelset, bodies.wheel);
  const EquivalentRail rail({{&bodies.rail, nullptr}, {&bodies.wheel, nullptr}}, place(nominal, rolling(0.01, 0.05)));
  for (double s = 0; s < bodies.rail.length(); s += 1e-3) {
    EXPECT_NEAR(rail.rail().at(s).value.z, bodies.rail.at(s).value.z, 1e-11);
    EXPECT_NEAR(rail.at(s).rise, 0, 1e-11);
  }
}

TEST(GeneralSurfaces, AreTheSameInAMirror) {
  WheelRailBodies left = sphere_on_cylinder();
  left.rail_surface = slices(left.rail, along_track, [](double u, ProfilePoint p) {
    return ProfilePoint{p.y + 0.01 * u, p.z + 0.01 * u * p.y};
  });
  WheelRailBodies right = left;
  right.side = TrackSide::right;
  WheelState<double> state = rolling(0.005, 0.01);
  state.longitudinal = 0.2;
  const auto a = WheelRail(left).solve(state, 5e3), b = WheelRail(right).solve(state.mirrored(), 5e3);
  EXPECT_EQ(a.force.z, b.force.z);
  EXPECT_EQ(a.force.y, -b.force.y);
}

TEST(GeneralSurfaces, AreNotThereInAnInterruption) {
  WheelRailBodies bodies = sphere_on_cylinder();
  std::vector<SurfaceSlice> parts;
  for (const double u : {-0.2, -0.1, 0.1, 0.2}) {
    SurfaceSlice& slice = parts.emplace_back(SurfaceSlice{u, u < 0 ? 0U : 241U, {}});
    for (int k = 0; k <= 240; ++k) {
      const double y = -0.03 + 0.06 * k / 240;
      slice.points.push_back({y, std::sqrt(radius * radius - y * y) - radius});
    }
  }
  bodies.rail_surface = std::make_shared<const ProfileSurface>(parts);
  WheelRail contact(bodies);
  EXPECT_EQ(contact.solve(rolling(0), 5e3).status, Status::no_contact);
  WheelState<double> before = rolling(0);
  before.longitudinal = -0.15;
  EXPECT_EQ(contact.solve(before, 5e3).status, Status::ok);
}

} // namespace
} // namespace microslip
