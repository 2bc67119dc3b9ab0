#include "microslip/railway/vehicle/wheelset_on_track.hpp"

#include "microslip/railway/geometry/wheelset_contact.hpp"
#include "microslip/railway/vehicle/wheelset_quantities.hpp"

#include "tests/support/numbers.hpp"
#include "tests/support/s1002_on_60e1.hpp"
#include "tests/support/steel.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace microslip {
namespace {

const WheelRailMethod accurate{.tolerance = 1e-10};

/// Cones on round heads of 0.3 m whose tops are 0.75 m from the track's centre.
WheelRailBodies cones(double conicity, double friction = 0.3) {
  const Profile cone(ProfileRole::wheel, std::vector<ProfilePoint>{{-0.06, -0.06 * conicity}, {0.06, 0.06 * conicity}});
  WheelRailBodies bodies{round_head(0.3, 0.06), cone, {}, {}, TrackSide::left, steel, {{0, friction}}};
  bodies.track.rail_origin = ProfilePoint{0.75, 0};
  bodies.wheelset = {
      .flange_back_distance = 1.36, .flange_back_position = -0.07, .nominal_radius = 0.46, .tape_circle = {}};
  return bodies;
}

WheelsetState running(double lateral, double yaw, double speed = 20) {
  WheelsetState s;
  s.left = microslip::running(lateral, yaw, 0, speed);
  return s;
}

WheelsetLoad axle_load(double force, double moment = 0, std::optional<double> torque = 0.0) {
  return {AxleLoad{force, moment}, torque};
}

/// The state at what a solution has found.
WheelsetState at(WheelsetState state, const WheelsetSolution& found) {
  state.left.vertical = found.vertical, state.left.roll = found.roll, state.left.pitch_velocity = found.pitch_velocity;
  return state;
}

TEST(WheelsetOnTrack, StandsSymmetricallyInTheMiddle) {
  WheelsetOnTrack wheelset(s1002_on_60e1(), accurate);
  const WheelsetSolution s = wheelset.solve(running(0, 0), axle_load(120e3));
  ASSERT_EQ(s.status, Status::ok);
  EXPECT_NEAR(s.roll, 0, 1e-13);
  EXPECT_NEAR(s.left.force.z, 60e3, 1e-9 * 60e3);
  EXPECT_NEAR(s.left.force.y, -s.right.force.y, 1e-8 * 60e3);
  EXPECT_NEAR(s.moment.z, 0, 1e-8 * 60e3);
}

TEST(WheelsetOnTrack, BalancesTheForcesThatItIsGiven) {
  WheelsetOnTrack wheelset(s1002_on_60e1(), accurate);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int k = 0; k < 40; ++k) {
    WheelsetState state = running(6e-3 * any(random), 5e-3 * any(random));
    state.left.lateral_velocity = 0.05 * any(random), state.left.curvature = 2e-3 * any(random);
    const double load = 80e3 + 40e3 * any(random), moment = 0.2 * load * any(random), torque = 1e3 * any(random);
    const WheelsetSolution s = wheelset.solve(state, axle_load(load, moment, torque));
    ASSERT_EQ(s.status, Status::ok) << state.left.lateral;
    EXPECT_LE(s.residual, 1e-10);
    EXPECT_NEAR(s.force.z, load, 1e-9 * load);
    EXPECT_NEAR(s.moment.x, moment, 1e-9 * load);
    // About the axle, which yaw and roll have turned.
    const double cy = std::cos(state.left.yaw), sy = std::sin(state.left.yaw), cr = std::cos(s.roll),
                 sr = std::sin(s.roll);
    EXPECT_NEAR(-sy * s.moment.x + cy * cr * s.moment.y + cy * sr * s.moment.z, -torque, 1e-9 * load);
    // Summed over patches: each force at its point.
    double force_z = 0, moment_x = 0;
    for (const WheelRailSolution* wheel : {&s.left, &s.right})
      for (const WheelRailPatch& p : wheel->patches) {
        const double fy = p.fs * std::cos(p.angle) - p.normal_force * std::sin(p.angle),
                     fz = p.fs * std::sin(p.angle) + p.normal_force * std::cos(p.angle);
        force_z += fz;
        moment_x += (p.place.y - state.left.lateral) * fz - (p.place.z - 0.46 - s.vertical) * fy;
      }
    EXPECT_NEAR(force_z, load, 1e-9 * load);
    EXPECT_NEAR(moment_x, moment, 1e-3 * load); // patches are not points
    // What was found, given again.
    wheelset.reset();
    const WheelsetSolution again = wheelset.solve(at(state, s));
    EXPECT_EQ(again.force.z, s.force.z);
    EXPECT_EQ(again.moment.y, s.moment.y);
  }
}

TEST(WheelsetOnTrack, LoadsEachWheelAsPrescribed) {
  WheelsetOnTrack wheelset(s1002_on_60e1(), accurate);
  for (const double lateral : {-6e-3, 0.0, 2e-3}) {
    const WheelsetSolution s = wheelset.solve(running(lateral, 1e-3), {WheelLoads{70e3, 40e3}, {}});
    ASSERT_EQ(s.status, Status::ok);
    EXPECT_NEAR(s.left.force.z, 70e3, 1e-9 * 110e3);
    EXPECT_NEAR(s.right.force.z, 40e3, 1e-9 * 110e3);
    EXPECT_EQ(s.pitch_velocity, 20 / 0.46);
    // The moment of these loads gives the same.
    const WheelsetSolution same = wheelset.solve(running(lateral, 1e-3), axle_load(110e3, s.moment.x, {}));
    EXPECT_NEAR(same.roll, s.roll, 1e-9 * 1e-3);
    EXPECT_NEAR(same.vertical, s.vertical, 1e-13);
  }
}

TEST(WheelsetOnTrack, IsTheSameInAMirror) {
  WheelRailBodies worn = s1002_on_60e1();
  worn.friction = {{0, 0.2}};
  WheelsetOnTrack one(s1002_on_60e1(), worn, accurate), other(worn, s1002_on_60e1(), accurate);
  WheelsetState state = running(5.5e-3, 2e-3);
  state.left.deflection.lateral = 3e-4, state.right_rail.vertical = 1e-3;
  WheelsetState image = state;
  image.left = state.right().mirrored();
  image.right_deflection = state.left.mirrored().deflection, image.right_rail = state.left.mirrored().rail;
  const WheelsetSolution a = one.solve(state, axle_load(100e3, 5e3)), b = other.solve(image, axle_load(100e3, -5e3));
  ASSERT_EQ(a.status, Status::ok);
  EXPECT_NEAR(a.roll, -b.roll, 1e-14);
  EXPECT_NEAR(a.vertical, b.vertical, 1e-14);
  EXPECT_NEAR(a.pitch_velocity, b.pitch_velocity, 1e-10);
  EXPECT_NEAR(a.force.y, -b.force.y, 1e-4);
  EXPECT_NEAR(a.moment.z, -b.moment.z, 1e-4);
  EXPECT_NEAR(a.left.force.x, b.right.force.x, 1e-4);
}

TEST(WheelsetOnTrack, IsTheRigidOneAsLoadsGoToZero) {
  // Contacts yield as the 2/3rd power of the load.
  WheelsetOnTrack wheelset(cones(0.05, 0), accurate);
  WheelRailBodies bodies = cones(0.05);
  WheelsetSearch rigid(bodies.track, bodies.wheelset, {bodies.rail, bodies.wheel}, {bodies.rail, bodies.wheel});
  const WheelsetContact touch = rigid.solve(4e-3, 1e-3);
  double before = 0;
  for (const double load : {8e3, 1e3, 125.0}) {
    const WheelsetSolution s = wheelset.solve(running(4e-3, 1e-3), {WheelLoads{load, load}, {}});
    ASSERT_EQ(s.status, Status::ok);
    EXPECT_NEAR(s.roll, touch.roll, 2e-2 * std::abs(s.vertical - touch.vertical));
    const double sinks = touch.vertical - s.vertical;
    EXPECT_GT(sinks, 0);
    if (before > 0) {
      EXPECT_NEAR(sinks / before, 0.25, 2e-3);
    }
    before = sinks;
    EXPECT_NEAR(s.left.patches.at(0).rolling_radius, touch.left.radius, 0.2 * sinks);
  }
}

TEST(WheelsetOnTrack, RollsFreelyAtTheSpeedOfItsRadii) {
  // The longitudinal forces of two cones are opposite, and so are their creepages: V = omega (rL + rR)/2, but for some
  // tenths of the overlap over the radius.
  for (const double conicity : {0.02, 0.05, 0.1}) {
    const WheelRailBodies bodies = cones(conicity);
    WheelsetOnTrack wheelset(bodies, accurate);
    WheelsetSearch rigid(bodies.track, bodies.wheelset, {bodies.rail, bodies.wheel}, {bodies.rail, bodies.wheel});
    for (const double lateral : {0.0, 2e-3}) {
      const WheelsetSolution s = wheelset.solve(running(lateral, 0), axle_load(100e3));
      ASSERT_EQ(s.status, Status::ok);
      const WheelRailPatch &left = s.left.patches.at(0), &right = s.right.patches.at(0);
      EXPECT_NEAR(left.rolling_radius - right.rolling_radius, rigid.solve(lateral).rolling_radius_difference(),
                  0.1 * conicity * lateral + 1e-12);
      EXPECT_NEAR(s.pitch_velocity * (left.rolling_radius + right.rolling_radius) / 40, 1, 0.3 * left.approach / 0.46);
      // The moments about the normals, which lean towards the axle, count as well.
      const auto torque = [](const WheelRailPatch& p) {
        return p.fx * p.rolling_radius + p.moment * std::sin(p.angle);
      };
      EXPECT_NEAR(torque(left) + torque(right), 0, 1e-2);
      EXPECT_NEAR(left.fx / (0.3 * 50e3), lateral > 0 ? 3 * conicity : 0, conicity); // the larger radius drives
    }
  }
}

TEST(WheelsetOnTrack, IsDrivenAndBrakedByATorque) {
  WheelsetOnTrack wheelset(s1002_on_60e1(), accurate);
  const WheelsetSolution free = wheelset.solve(running(1e-3, 0), axle_load(100e3, 0, 0.0)),
                         driven = wheelset.solve(running(1e-3, 0), axle_load(100e3, 0, 3e3)),
                         braked = wheelset.solve(running(1e-3, 0), axle_load(100e3, 0, -3e3));
  EXPECT_GT(driven.pitch_velocity, free.pitch_velocity);
  EXPECT_LT(braked.pitch_velocity, free.pitch_velocity);
  EXPECT_NEAR(driven.force.x, 3e3 / 0.46, 0.01 * 3e3 / 0.46);
  EXPECT_NEAR(braked.force.x, -3e3 / 0.46, 0.01 * 3e3 / 0.46);
  // More than friction bears: mu Q r = 13.8 kN m.
  EXPECT_EQ(wheelset.solve(running(1e-3, 0), axle_load(100e3, 0, 20e3)).status, Status::no_solution);
}

/// The derivatives beside central differences.
void expect_derivatives(WheelsetOnTrack& wheelset, const WheelsetState& state, const PrescribedWheelsetForces& forces) {
  WheelsetSolution found;
  WheelsetDerivatives d;
  wheelset.differentiate(state, forces.load(), found, d);
  ASSERT_EQ(found.status, Status::ok);
  const std::size_t states = static_cast<std::size_t>(WheelsetVariable::vertical_force);
  for (std::size_t k = 0; k < wheelset_variables; ++k) {
    WheelsetState low = state, high = state;
    PrescribedWheelsetForces less = forces, more = forces;
    double step = k >= states ? 10 : k >= 4 ? 2e-5 : 1e-8; // [N], [N m]; [m/s], [rad/s]; [m], [rad]
    const auto which = static_cast<WheelsetVariable>(k);
    const bool is_found = which == WheelsetVariable::pitch_velocity
                              ? forces.axle_torque.has_value()
                              : (k == 1 || k == 2) && forces.load().vertical.has_value();
    if (k < states) {
      const auto& q = wheelset_state_quantities()[k];
      q.set(low, q.value(low) - step), q.set(high, q.value(high) + step);
    } else if (const auto of = prescribed_forces()[k - states].of; forces.*of) {
      *(less.*of) -= step, *(more.*of) += step;
    }
    const WheelsetSolution a = wheelset.solve(low, less.load()), b = wheelset.solve(high, more.load());
    ASSERT_EQ(a.status, Status::ok);
    ASSERT_EQ(b.status, Status::ok);
    const auto slope = [&](double above, double below) { return is_found ? 0 : (above - below) / (2 * step); };
    const auto expect_near = [&](double got, double expected, double size) {
      EXPECT_NEAR(got, expected, 2e-4 * size + 1e-4 * std::abs(expected)) << "by variable " << k;
    };
    const Vec3<double> force = {slope(b.force.x, a.force.x), slope(b.force.y, a.force.y), slope(b.force.z, a.force.z)},
                       moment = {slope(b.moment.x, a.moment.x), slope(b.moment.y, a.moment.y),
                                 slope(b.moment.z, a.moment.z)};
    // By the forward velocity alone terms of 5e5 N/(m/s) cancel where the pitch velocity follows it.
    const double cancelled = which == WheelsetVariable::forward_velocity ? 1e3 : 1e-3 / step;
    const double size = std::sqrt(dot(force, force)) + std::sqrt(dot(moment, moment)) + cancelled;
    expect_near(d.force(k).x, force.x, size), expect_near(d.force(k).y, force.y, size);
    expect_near(d.force(k).z, force.z, size), expect_near(d.moment(k).x, moment.x, size);
    expect_near(d.moment(k).y, moment.y, size), expect_near(d.moment(k).z, moment.z, size);
    if (forces.load().vertical) {
      const double z = slope(b.vertical, a.vertical), roll = slope(b.roll, a.roll);
      const double change = std::abs(z) + std::abs(roll) + std::max(1e-12 / step, 1e-9 * cancelled);
      expect_near(d.vertical(k), z, change), expect_near(d.roll(k), roll, change);
    } else {
      EXPECT_EQ(d.vertical(k), 0);
    }
    if (forces.axle_torque) {
      const double pitch = slope(b.pitch_velocity, a.pitch_velocity);
      expect_near(d.pitch_velocity(k), pitch, std::abs(pitch) + 1e-8 / step);
    }
  }
}

TEST(WheelsetOnTrack, HasTheDerivativesOfItsForces) {
  WheelsetOnTrack wheelset(s1002_on_60e1(), accurate);
  PrescribedWheelsetForces axle, turning, wheels;
  axle.vertical_force = 100e3, axle.roll_moment = 2e3, axle.axle_torque = 0;
  turning.vertical_force = 100e3, turning.roll_moment = 0;
  wheels.vertical_force_left = 60e3, wheels.vertical_force_right = 40e3, wheels.axle_torque = 500;
  const WheelsetState state = running(1.9e-3, 2e-3);
  for (const PrescribedWheelsetForces& forces : {axle, turning, wheels}) expect_derivatives(wheelset, state, forces);
  expect_derivatives(wheelset, at(state, wheelset.solve(state, axle.load())), {});
}

TEST(WheelsetOnTrack, FindsItsWayThroughContactJumps) {
  WheelsetOnTrack wheelset(s1002_on_60e1());
  WheelsetSolution s;
  const auto solve = [&](double lateral, const WheelsetLoad& load) {
    wheelset.solve(running(lateral, 2e-3), load, s);
    return s.status;
  };
  // Through all contacts of the tread and onto both flanges: few iterations, as contacts jump and merge.
  long iterations = 0;
  for (int k = -62; k <= 62; ++k) {
    ASSERT_EQ(solve(k * 1e-4, axle_load(100e3)), Status::ok) << k;
    EXPECT_LE(s.residual, 1e-6);
    iterations += s.iterations;
  }
  EXPECT_LT(iterations, 8 * 125);
  // With both loads given also where the flange climbs.
  for (int k = -16; k <= 16; ++k) {
    EXPECT_EQ(solve(k * 5e-4, {WheelLoads{50e3, 50e3}, 0.0}), Status::ok) << k;
    EXPECT_LE(s.residual, 1e-6);
  }
  // On flanges as steep as 68 degrees the axle's load alone cannot hold the wheelset aside: the other wheel would lift.
  EXPECT_EQ(solve(-6.8e-3, axle_load(100e3)), Status::no_solution);
  EXPECT_GT(s.residual, 1e-2);
  EXPECT_EQ(solve(-7.5e-3, axle_load(100e3)), Status::ok);
}

TEST(WheelsetOnTrack, AgreesAtBothLevels) {
  WheelsetOnTrack fast(s1002_on_60e1()), exact(s1002_on_60e1(), {.theory = Theory::exact, .elements = 12});
  const WheelsetSolution a = fast.solve(running(-2e-3, 1e-3), axle_load(100e3)),
                         b = exact.solve(running(-2e-3, 1e-3), axle_load(100e3));
  ASSERT_EQ(b.status, Status::ok);
  EXPECT_LE(b.residual, 1e-5);
  EXPECT_NEAR(a.roll, b.roll, 2e-6);
  // By what a torque of 5 % of the friction does: so much the forces of a wheel may differ.
  const double torque = 0.05 * 0.3 * 100e3 * 0.46;
  const WheelsetSolution driven = fast.solve(running(-2e-3, 1e-3), axle_load(100e3, 0, torque));
  ASSERT_EQ(driven.status, Status::ok);
  EXPECT_NEAR(a.pitch_velocity, b.pitch_velocity, driven.pitch_velocity - a.pitch_velocity);
  EXPECT_NEAR(a.force.y, b.force.y, 0.02 * 0.3 * 100e3);
  EXPECT_EQ(b.left.fields.size(), b.left.patches.size());
}

TEST(WheelsetOnTrack, SaysWhatCannotBe) {
  WheelsetOnTrack wheelset(s1002_on_60e1());
  EXPECT_EQ(wheelset.solve(running(0.3, 0), axle_load(100e3)).status, Status::no_contact);
  // A moment that would lift a wheel.
  EXPECT_EQ(wheelset.solve(running(0, 0), axle_load(100e3, 90e3)).status, Status::no_solution);
  // Nothing prescribed: one wheel lifted, both lifted.
  WheelsetState state = running(0, 0);
  state.left.roll = 1e-3;
  EXPECT_EQ(wheelset.solve(state).status, Status::ok);
  EXPECT_EQ(wheelset.solve(state).left.status, Status::no_contact);
  EXPECT_GT(wheelset.solve(state).right.force.z, 0);
  state.left.vertical = 0.1;
  EXPECT_EQ(wheelset.solve(state).status, Status::no_contact);
  for (const WheelsetLoad& bad : {axle_load(0), axle_load(-1e3), axle_load(nan), axle_load(1e3, nan),
                                  axle_load(1e3, 0, nan), WheelsetLoad{WheelLoads{1e3, 0}, {}}})
    EXPECT_EQ(wheelset.solve(running(0, 0), bad).status, Status::invalid_input);
  state.right_rail.vertical = nan;
  EXPECT_EQ(wheelset.solve(state).status, Status::invalid_input);
}

/// With the exact theory a shape is that of the exact patches; rows, with which it begins, follow the surface.
TEST(WheelsetOnTrack, TakesAnyShapeAtTheExactLevel) {
  for (const PatchShape shape : {PatchShape::flat, PatchShape::curved, PatchShape::conformal}) {
    WheelsetOnTrack wheelset(s1002_on_60e1(), {.theory = Theory::exact, .shape = shape, .elements = 12});
    const auto s = wheelset.solve(running(1e-3, 1e-3), axle_load(100e3));
    EXPECT_EQ(s.status, Status::ok) << static_cast<int>(shape) << ": " << to_string(s.reason);
    EXPECT_NEAR(s.force.z, 100e3, 2);
  }
}

} // namespace
} // namespace microslip
