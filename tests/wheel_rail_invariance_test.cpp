// What a wheel on a rail must keep with both theories: mirrors, moves of the whole, scales of velocity, the energy that
// friction takes, and friction of the inclination row by row on curved patches.

#include "microslip/railway/geometry/contact_search.hpp"
#include "microslip/railway/wheel_rail.hpp"

#include "tests/support/s1002_on_60e1.hpp"
#include "tests/support/steel.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace microslip {
namespace {

constexpr double friction = 0.3;

/// Both theories, the exact one with few elements, since what is kept does not depend on them.
const WheelRailMethod methods[] = {{}, {.theory = Theory::exact, .elements = 10}};

/// Running states with all motions, one of them with contact on tread and flange.
std::vector<WheelState<double>> states(double height_below) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<WheelState<double>> all;
  for (const double y : {-3e-3, 0.2e-3, 4e-3, 6.1e-3}) {
    WheelState<double> s;
    s.lateral = y, s.vertical = -height_below, s.yaw = 4e-3 * any(random), s.roll = 1e-3 * any(random);
    s.forward_velocity = 20, s.pitch_velocity = 20 / 0.46 * (1 + 2e-3 * any(random));
    s.lateral_velocity = 0.02 * any(random), s.roll_velocity = 0.02 * any(random), s.yaw_velocity = 0.02 * any(random);
    all.push_back(s);
  }
  return all;
}

double size(const Vec3<double>& v) {
  return std::sqrt(dot(v, v));
}

TEST(WheelRailInvariance, InAMirrorAcrossTheTrackTravelTurnsRound) {
  // x, the velocities along it, pitch and yaw change their signs; forces along x and moments about y and z do.
  for (const WheelRailMethod& method : methods) {
    WheelRail contact(s1002_on_60e1(), method);
    for (const WheelState<double>& forward : states(0)) {
      WheelState<double> backward = forward;
      for (double* odd : {&backward.yaw, &backward.forward_velocity, &backward.pitch_velocity, &backward.yaw_velocity})
        *odd = -*odd;
      contact.reset();
      const auto f = contact.solve(forward, 50e3);
      contact.reset();
      const auto b = contact.solve(backward, 50e3);
      ASSERT_EQ(f.status, Status::ok);
      ASSERT_EQ(b.status, Status::ok);
      // The exact theory's elements begin at one end of a patch: mirrored they are others.
      const bool exact = method.theory == Theory::exact;
      const double tolerance = exact ? 2e-3 * friction * 50e3 : 1e-9 * 50e3;
      EXPECT_NEAR(b.force.x, -f.force.x, tolerance);
      EXPECT_NEAR(b.force.y, f.force.y, tolerance);
      EXPECT_NEAR(b.force.z, f.force.z, 1e-5 * 50e3);
      EXPECT_NEAR(b.moment.x, f.moment.x, tolerance);
      EXPECT_NEAR(b.moment.y, -f.moment.y, tolerance);
      EXPECT_NEAR(b.moment.z, -f.moment.z, tolerance);
      EXPECT_NEAR(b.vertical, f.vertical, exact ? 2e-8 : 1e-12);
      ASSERT_EQ(b.patches.size(), f.patches.size());
      for (std::size_t k = 0; k < f.patches.size(); ++k) {
        EXPECT_NEAR(b.patches[k].creepage.longitudinal, -f.patches[k].creepage.longitudinal, 1e-12);
        EXPECT_NEAR(b.patches[k].creepage.lateral, f.patches[k].creepage.lateral, 1e-12);
        EXPECT_NEAR(b.patches[k].frictional_power, f.patches[k].frictional_power, 20 * 3e-3 * tolerance);
      }
    }
  }
}

/// The state with rail and wheelset turned by the same angle about the x axis, then moved.
WheelState<double> moved(const WheelState<double>& state, double angle, const Vec3<double>& way) {
  const NominalPlacement nominal =
      nominal_placement(s1002_on_60e1().track, s1002_on_60e1().rail, {}, s1002_on_60e1().wheel);
  const auto turn = rotation_about_x(angle);
  const auto there = [&](const Vec3<double>& place) { return turn * place + way; };
  const Vec3<double> rail = nominal.rail.origin, rail_there = there(rail);
  const Vec3<double> centre = there({0, state.lateral, nominal.nominal_radius + state.vertical});
  const Vec3<double> velocity =
      turn * Vec3<double>{state.forward_velocity, state.lateral_velocity, state.vertical_velocity};
  WheelState<double> other = state;
  other.rail.roll = angle, other.rail.lateral = rail_there.y - rail.y, other.rail.vertical = rail_there.z - rail.z;
  other.roll += angle, other.lateral = centre.y, other.vertical = centre.z - nominal.nominal_radius;
  other.lateral_velocity = velocity.y, other.vertical_velocity = velocity.z;
  return other;
}

TEST(WheelRailInvariance, MovedAsAWholeItsForcesAreTheSame) {
  for (const WheelRailMethod& method : methods) {
    WheelRail contact(s1002_on_60e1(), method);
    for (WheelState<double> state : states(0)) {
      state.vertical = contact.solve(state, 60e3).vertical;
      const auto a = contact.solve(state), b = contact.solve(moved(state, 0, {0, 3e-3, -2e-3}));
      ASSERT_EQ(b.status, Status::ok);
      // Positions of some metres are rounded by 1e-16 m, which is 1e-11 of overlaps. With the exact theory rounding may
      // decide whether there is one element more.
      const double tolerance = method.theory == Theory::exact ? 1e-3 : 1e-9;
      EXPECT_LT(size(b.force - a.force), tolerance * size(a.force));
      EXPECT_LT(size(b.moment - a.moment), 2 * tolerance * size(a.moment) + 1e-9);
      ASSERT_EQ(b.patches.size(), a.patches.size());
      for (std::size_t k = 0; k < a.patches.size(); ++k) {
        EXPECT_NEAR(b.patches[k].rolling_radius, a.patches[k].rolling_radius, 1e-12);
        EXPECT_NEAR(b.patches[k].angle, a.patches[k].angle, 1e-11);
        EXPECT_NEAR(b.patches[k].place.y, a.patches[k].place.y + 3e-3, 1e-12);
      }
    }
  }
}

TEST(WheelRailInvariance, TurnedAsAWholeItsForcesTurnWithIt) {
  // Almost: where a patch has its frame, and its rows, depends on the overlap along the vertical, which does not turn.
  for (const WheelRailMethod& method : methods) {
    WheelRail contact(s1002_on_60e1(), method);
    for (WheelState<double> state : states(0)) {
      state.vertical = contact.solve(state, 60e3).vertical;
      const double angle = 0.02;
      const auto a = contact.solve(state), b = contact.solve(moved(state, angle, {}));
      ASSERT_EQ(b.status, Status::ok);
      ASSERT_EQ(b.patches.size(), a.patches.size());
      const double tolerance = method.theory == Theory::exact ? 5e-4 : 3e-3;
      EXPECT_LT(size(b.force - rotation_about_x(angle) * a.force), tolerance * size(a.force));
      for (std::size_t k = 0; k < a.patches.size(); ++k)
        EXPECT_NEAR(b.patches[k].angle, a.patches[k].angle + angle, 2e-4);
    }
  }
}

TEST(WheelRailInvariance, TheHeightThatBearsAForceGivesThatForce) {
  // Also where two lobes are about to become one patch, with a load that is hard to share out.
  for (const PatchShape shape : {PatchShape::flat, PatchShape::curved}) {
    WheelRail contact(s1002_on_60e1(), {.theory = Theory::exact, .shape = shape, .elements = 16});
    int solved = 0;
    for (const double y : {1e-3, 4.94e-3, 4.9505e-3, 4.95108e-3, 4.9525e-3, 4.97e-3, 6e-3}) {
      WheelState<double> state;
      state.lateral = y, state.yaw = 2e-3, state.forward_velocity = 20, state.pitch_velocity = 20 / 0.46;
      const auto s = contact.solve(state, 50e3);
      if (s.status != Status::ok) continue;
      state.vertical = s.vertical;
      EXPECT_NEAR(contact.solve(state).force.z, 50e3, 2e-3 * 50e3) << y;
      ++solved;
    }
    EXPECT_GE(solved, 3);
  }
}

TEST(WheelRailInvariance, OnlyRatiosOfVelocitiesMatter) {
  for (const WheelRailMethod& method : methods) {
    WheelRail contact(s1002_on_60e1(), method);
    for (const WheelState<double>& slow : states(0)) {
      WheelState<double> fast = slow;
      for (double* velocity : {&fast.forward_velocity, &fast.lateral_velocity, &fast.vertical_velocity,
                               &fast.roll_velocity, &fast.pitch_velocity, &fast.yaw_velocity})
        *velocity *= 4; // without rounding
      contact.reset();
      const auto s = contact.solve(slow, 50e3);
      contact.reset();
      const auto f = contact.solve(fast, 50e3);
      EXPECT_EQ(f.force.x, s.force.x);
      EXPECT_EQ(f.force.y, s.force.y);
      EXPECT_EQ(f.vertical, s.vertical);
      EXPECT_NEAR(f.patches[0].frictional_power, 4 * s.patches[0].frictional_power,
                  1e-12 * f.patches[0].frictional_power);
    }
  }
}

TEST(WheelRailInvariance, FrictionTakesWhatCreepagesPutIn) {
  // A row loses what its rigid slip does, since the body's displacement comes back at the trailing edge.
  const WheelRailMethod planes{.theory = Theory::exact, .shape = PatchShape::flat};
  for (const WheelRailMethod& method : {WheelRailMethod{}, WheelRailMethod{.theory = Theory::exact}, planes}) {
    WheelRail contact(s1002_on_60e1(), method);
    for (const WheelState<double>& state : states(0)) {
      const auto s = contact.solve(state, 50e3);
      for (const WheelRailPatch& p : s.patches) {
        const double put_in = -p.rolling_speed *
                              (p.creepage.longitudinal * p.fx + p.creepage.lateral * p.fs + p.creepage.spin * p.moment);
        // Rows on the true surfaces have different creepages.
        const double share = method.surface() == PatchShape::flat ? 0.03 : 0.06;
        EXPECT_NEAR(p.frictional_power, put_in, share * friction * p.normal_force * 20 * 1e-3);
        EXPECT_GE(p.frictional_power, 0);
      }
    }
  }
}

/// Inclination in track axes of the rail's surface at y [m] of its profile, which rises in y.
double inclination_at(const WheelRailBodies& bodies, double s) {
  const ProfilePoint slope = bodies.rail.at(s).first;
  return std::atan2(slope.z, slope.y) + bodies.track.cant;
}

double parameter_at(const Profile& rail, double y) {
  double low = 0, high = rail.length();
  while (high - low > 1e-12) {
    const double middle = (low + high) / 2;
    (rail.at(middle).value.y < y ? low : high) = middle;
  }
  return low;
}

TEST(WheelRailInvariance, RowsOfCurvedPatchesSlideAtTheFrictionOfTheirInclination) {
  WheelRailBodies bodies = s1002_on_60e1();
  const auto coefficient = [](double angle) { return 0.3 + 0.4 * angle; };
  bodies.friction = {{-0.5, coefficient(-0.5)}, {0.5, coefficient(0.5)}};
  WheelRail contact(bodies, {.theory = Theory::exact, .shape = PatchShape::curved, .elements = 16});
  for (const double y : {-2e-3, 5.5e-3}) {
    WheelState<double> state;
    state.lateral = y;
    state.forward_velocity = 20, state.pitch_velocity = 20 / 0.46 * 3; // slides everywhere
    const auto s = contact.solve(state, 60e3);
    ASSERT_EQ(s.status, Status::ok);
    double least = 1, most = 0;
    for (std::size_t k = 0; k < s.patches.size(); ++k) {
      const double origin = parameter_at(bodies.rail, s.patches[k].rail_y);
      const Elements& e = s.fields[k].elements;
      const SurfaceFields& f = s.fields[k].fields;
      for (std::size_t i = 0; i < e.size(); ++i) {
        if (!(f.pressure[i] > 1e-3 * s.patches[k].peak_pressure)) continue;
        const double mu = coefficient(inclination_at(bodies, origin + e.y[i]));
        EXPECT_NEAR(std::hypot(f.traction.x[i], f.traction.y[i]) / f.pressure[i], mu, 1e-9);
        least = std::min(least, mu), most = std::max(most, mu);
      }
    }
    EXPECT_GT(most - least, 0.015) << "the rows do not differ";
  }
}

TEST(WheelRailInvariance, BothLevelsSlideAtTheSameFrictionOnCurvedPatches) {
  WheelRailBodies bodies = s1002_on_60e1();
  bodies.friction = {{-0.5, 0.1}, {0.5, 0.5}};
  const auto sliding = [&](Theory theory, double direction) {
    WheelRail contact(bodies, {.theory = theory, .shape = PatchShape::curved, .elements = 20});
    WheelState<double> state;
    state.lateral = 2e-3;
    state.forward_velocity = 20 * direction, state.pitch_velocity = 20 / 0.46 * 3 * direction;
    return contact.solve(state, 60e3).force.x / 60e3;
  };
  const double exact = sliding(Theory::exact, 1), fast = sliding(Theory::fastsim2, 1);
  EXPECT_GT(exact, 0.25);
  EXPECT_NEAR(fast, exact, 3e-3);
  EXPECT_NEAR(sliding(Theory::exact, -1), -exact, 1e-6) << "backward";
}

} // namespace
} // namespace microslip
