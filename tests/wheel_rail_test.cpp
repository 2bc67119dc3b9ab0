#include "microslip/railway/wheel_rail.hpp"

#include "microslip/contact/quantities.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/railway/geometry/relative_motion.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/support/s1002_on_60e1.hpp"
#include "tests/support/sphere_on_rail.hpp"
#include "tests/support/steel.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace microslip {
namespace {

constexpr double friction = 0.3;

/// A sphere of 0.1 m on a rail that is a cylinder of 0.1 m along the track.
WheelRail sphere_on_cylinder(Theory theory, int elements = 24) {
  return WheelRail(sphere_on_rail(0.1, 0.1), {.theory = theory, .elements = elements});
}

TEST(WheelRail, HasHertzsForcesOnAnyInclination) {
  const GapCurvatures gap = gap_curvatures({0.1, std::numeric_limits<double>::infinity(), 0.1, 0.1});
  const HertzContact hertz = hertz_from_load(gap, steel, 5e3);
  for (const Theory theory : {Theory::fastsim2, Theory::exact}) {
    WheelRail contact = sphere_on_cylinder(theory);
    const double fine = theory == Theory::exact ? 1 : 8;
    for (const double lateral : {0.0, 0.02, -0.04}) {
      // Centres 0.2 m apart: the normal leans by asin(lateral/0.2). At rest, so that there is no friction.
      WheelState<double> state;
      state.lateral = lateral;
      const double angle = -std::asin(lateral / 0.2);
      const auto s = contact.solve(state, 5e3 * std::cos(angle));
      ASSERT_EQ(s.status, Status::ok);
      ASSERT_EQ(s.patches.size(), 1u);
      EXPECT_NEAR(s.patches[0].normal_force, 5e3, 2e-3 * fine * 5e3);
      EXPECT_NEAR(s.patches[0].angle, angle, 3e-4);
      EXPECT_NEAR(s.force.y, -5e3 * std::sin(angle), 3e-3 * fine * 5e3);
      EXPECT_NEAR(s.patches[0].peak_pressure / hertz.peak_pressure, 1, 0.01 * fine);
      const double height = std::sqrt(0.04 - lateral * lateral) - 0.2;
      EXPECT_NEAR((height - s.vertical) * std::cos(angle) / hertz.approach, 1, 4e-3 * fine);
    }
  }
}

/// All numbers of a table are the same, but for the sign of odd ones.
template <class Row, class Of> void expect_mirror_images(std::span<const Row> table, const Of& here, const Of& image) {
  for (const Row& q : table) {
    const double value = q.value(here), in_mirror = q.is_odd() ? -q.value(image) : q.value(image);
    EXPECT_TRUE(value == in_mirror || (std::isnan(value) && std::isnan(in_mirror))) << q.name;
  }
}

void expect_mirror_images(const ContactSolution& here, const ContactSolution& image) {
  EXPECT_EQ(here.totals.fy, -image.totals.fy);
  EXPECT_EQ(here.totals.mz, -image.totals.mz);
  const int mx = here.elements.mx(), my = here.elements.my();
  for (const FieldQuantity& field : field_quantities()) {
    const std::vector<double>&a = field.values(here), &b = field.values(image);
    ASSERT_EQ(a.size(), b.size()) << field.name;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const int i = static_cast<int>(k) % mx, j = static_cast<int>(k) / mx;
      const double in_mirror = b[static_cast<std::size_t>(my - 1 - j) * mx + i];
      EXPECT_EQ(a[k], field.is_odd ? -in_mirror : in_mirror) << field.name;
    }
  }
}

TEST(WheelRail, IsTheSameInAMirror) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const Theory theory : {Theory::fastsim2, Theory::exact}) {
    WheelRail left(s1002_on_60e1(), {.theory = theory, .elements = 8}),
        right(s1002_on_60e1(TrackSide::right), {.theory = theory, .elements = 8});
    for (int k = 0; k < (theory == Theory::exact ? 3 : 30); ++k) {
      WheelState<double> state = running(5e-3 * any(random), 5e-3 * any(random), 2e-3 * any(random));
      state.roll = 1e-3 * any(random), state.lateral_velocity = 0.02 * any(random);
      const auto a = left.solve(state, 50e3), b = right.solve(state.mirrored(), 50e3);
      expect_mirror_images(wheel_results(), a, b);
      ASSERT_EQ(a.patches.size(), b.patches.size());
      for (std::size_t i = 0; i < a.patches.size(); ++i)
        expect_mirror_images(patch_results(), a.patches[i], b.patches[i]);
      ASSERT_EQ(a.fields.size(), b.fields.size());
      for (std::size_t i = 0; i < a.fields.size(); ++i) expect_mirror_images(a.fields[i], b.fields[i]);
    }
  }
}

TEST(WheelRail, DoesNotDependOnWhereItsPartsHaveTheirOrigins) {
  const WheelRailBodies here_bodies = s1002_on_60e1();
  const Profile &rail = here_bodies.rail, &wheel = here_bodies.wheel;
  const auto moved = [](const Profile& profile, ProfilePoint by) {
    std::vector<ProfilePoint> points;
    for (const ProfilePiece& piece : profile.pieces()) points.push_back({piece.c[0].y + by.y, piece.c[0].z + by.z});
    const ProfilePoint last = profile.at(profile.length()).value;
    points.push_back({last.y + by.y, last.z + by.z});
    return Profile(profile.role(), points);
  };
  WheelRailBodies other = s1002_on_60e1();
  other.rail = moved(rail, {0.02, 0.1});
  other.wheel = moved(wheel, {0.013, 0});
  other.wheelset.flange_back_position += 0.013;
  WheelRail here(here_bodies), there(other);
  for (const double y : {-4e-3, 0.0, 3e-3, 6e-3}) {
    const auto a = here.solve(running(y, 3e-3, 1e-3), 60e3), b = there.solve(running(y, 3e-3, 1e-3), 60e3);
    EXPECT_NEAR(a.force.x, b.force.x, 1e-6 * 60e3);
    EXPECT_NEAR(a.force.y, b.force.y, 1e-6 * 60e3);
    EXPECT_NEAR(a.vertical, b.vertical, 1e-11);
  }
}

TEST(WheelRail, BearsTheVerticalForceThatItIsGiven) {
  WheelRail contact(s1002_on_60e1());
  WheelRailSolution found;
  for (const double force : {200.0, 10e3, 150e3})
    for (double y = -8e-3; y <= 8e-3; y += 1e-3) {
      contact.solve(running(y, 5e-3), force, found);
      ASSERT_EQ(found.status, Status::ok) << y;
      EXPECT_NEAR(found.force.z, force, 5e-6 * force);
      WheelState<double> there = running(y, 5e-3);
      there.vertical = found.vertical;
      const auto again = contact.solve(there);
      EXPECT_NEAR(again.force.z, force, 1e-5 * force);
    }
}

TEST(WheelRail, BearsTheVerticalForceOnCurvedPatches) {
  for (const Theory theory : {Theory::fastsim2, Theory::exact}) {
    WheelRail contact(s1002_on_60e1(), {.theory = theory, .shape = PatchShape::curved, .elements = 10});
    for (double y = -4e-3; y <= 8e-3; y += 2e-3) {
      const auto s = contact.solve(running(y, 3e-3, 1e-3), 80e3);
      EXPECT_EQ(s.status, Status::ok) << y;
      EXPECT_NEAR(s.force.z, 80e3, 1e-4 * 80e3) << y;
    }
  }
}

TEST(WheelRail, LosesInFrictionWhatItsCreepagesDo) {
  WheelRail contact(s1002_on_60e1(), {.theory = Theory::exact, .shape = PatchShape::flat, .elements = 24});
  for (const double y : {0.0, 5e-3}) {
    const auto s = contact.solve(running(y, 2e-3, 1e-3), 50e3);
    for (const WheelRailPatch& p : s.patches) {
      const double power =
          -p.rolling_speed * (p.creepage.longitudinal * p.fx + p.creepage.lateral * p.fs + p.creepage.spin * p.moment);
      EXPECT_NEAR(p.frictional_power, power, 0.02 * power);
      EXPECT_GT(p.frictional_power, 0);
    }
  }
}

/// On the true surfaces creepages differ from row to row; what the whole wheel puts in is lost all the same.
TEST(WheelRail, LosesInFrictionWhatTheWheelPutsIn) {
  WheelRail contact(s1002_on_60e1(), {.theory = Theory::exact, .elements = 24});
  for (const double y : {0.0, 5e-3}) {
    const WheelState<double> state = running(y, 2e-3, 1e-3);
    const auto s = contact.solve(state, 50e3);
    double lost = 0;
    for (const WheelRailPatch& p : s.patches) lost += p.frictional_power;
    const Vec3<double> turning = state.pitch_velocity * Vec3<double>{-std::sin(state.yaw), std::cos(state.yaw), 0};
    const double put_in = -(s.force.x * state.forward_velocity + dot(s.moment, turning));
    EXPECT_NEAR(lost, put_in, 0.05 * put_in);
  }
}

TEST(WheelRail, ChangesNothingAtOnceWherePatchesBecomeOne) {
  // At 4.948 mm two regions touch whose frames are 2 mm and 0.03 rad apart; at 3 mm one patch stays one.
  WheelRail contact(s1002_on_60e1(), {.theory = Theory::exact});
  for (const double middle : {4.9484e-3, 3e-3}) {
    Vec3<double> before;
    for (int k = -3; k <= 3; ++k) {
      const auto s = contact.solve(running(middle + k * 1e-6, 2e-3), 50e3);
      ASSERT_EQ(s.status, Status::ok);
      EXPECT_LE(s.residual, 1e-6);
      if (k > -3) {
        EXPECT_NEAR(s.force.x, before.x, 0.005 * friction * 50e3);
        EXPECT_NEAR(s.force.y, before.y, 0.005 * friction * 50e3);
      }
      before = s.force;
    }
  }
}

TEST(WheelRail, SharesTheLoadOfTwoPatchesAtTheExactLevel) {
  // Held in the height in which they bear a vertical force, the patches bear it again.
  WheelRail contact(s1002_on_60e1(), {.theory = Theory::exact});
  WheelState<double> state = running(5.2e-3, 2e-3);
  const auto s = contact.solve(state, 10e3);
  ASSERT_EQ(s.status, Status::ok);
  ASSERT_EQ(s.patches.size(), 2U);
  state.vertical = s.vertical;
  const auto held = contact.solve(state);
  ASSERT_EQ(held.patches.size(), 2U);
  EXPECT_NEAR(held.force.z, 10e3, 1e-3 * 10e3);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_NEAR(held.patches[k].normal_force, s.patches[k].normal_force, 2e-3 * s.patches[k].normal_force);
}

TEST(WheelRail, HasBothLevelsNearEachOther) {
  WheelRail fast(s1002_on_60e1()), exact(s1002_on_60e1(), {.theory = Theory::exact, .elements = 20});
  for (double y = -4e-3; y <= 4e-3; y += 2e-3) {
    const auto a = fast.solve(running(y, 1e-3, 5e-4), 50e3), b = exact.solve(running(y, 1e-3, 5e-4), 50e3);
    EXPECT_NEAR(a.force.x, b.force.x, 0.05 * friction * 50e3);
    EXPECT_NEAR(a.force.y, b.force.y, 0.05 * friction * 50e3);
    EXPECT_NEAR(a.vertical, b.vertical, 0.02 * b.patches[0].approach);
  }
}

TEST(WheelRail, TakesACurvedPatchForFlatWhereItTurnsLittle) {
  // The wheel's rolling radius varies over the patch by about its width squared over twice the rail's radius.
  WheelRail flat(s1002_on_60e1(), {.theory = Theory::exact, .shape = PatchShape::flat}),
      curved(s1002_on_60e1(), {.theory = Theory::exact, .shape = PatchShape::curved});
  double before = 1;
  for (const double force : {20e3, 2e3, 200.0}) {
    const auto a = flat.solve(running(0, 1e-3, 1e-3), force), b = curved.solve(running(0, 1e-3, 1e-3), force);
    const double difference = std::hypot(a.force.x - b.force.x, a.force.y - b.force.y) / (friction * force);
    EXPECT_LT(difference, 0.6 * before);
    before = difference;
  }
  EXPECT_LT(before, 0.01);
}

TEST(WheelRail, SlidesAtTheFrictionOfTheInclination) {
  WheelRailBodies bodies = s1002_on_60e1();
  bodies.friction = {{-0.1, 0.1}, {0.1, 0.5}};
  WheelRail contact(bodies);
  const auto s = contact.solve(running(0, 0, 1), 5e3); // a small patch, which has nearly one inclination
  const WheelRailPatch& p = s.patches.at(0);
  EXPECT_NEAR(std::hypot(p.fx, p.fs) / p.normal_force, 0.3 + 2 * p.angle, 2e-3);
}

/// A state in a curve with all that a state can have.
WheelState<double> in_a_curve(double lateral) {
  WheelState<double> s = running(lateral, 2e-3, 1e-3);
  s.roll = 1e-3, s.curvature = 1.0 / 500, s.roll_velocity = 0.03;
  s.deflection.lateral = 2e-4, s.deflection.roll = -1e-3, s.deflection.yaw = 1e-3, s.deflection.yaw_velocity = 0.02;
  s.rail.lateral = 1e-4, s.rail.roll = 3e-3, s.rail.lateral_velocity = 0.002, s.rail.roll_velocity = 0.1;
  return s;
}

/// Half a step of a difference by a number with this unit: as that of the derivatives except for yaw.
double half_step(const StateQuantity& q) {
  if (q.name == "deflection_longitudinal") return 1e-6;
  if (q.name == "yaw" || q.name == "deflection_yaw") return 2e-7;
  return q.unit == "m" || q.unit == "1/m" ? 1e-8 : q.unit == "rad" ? 2e-8 : q.unit == "m/s" ? 2e-5 : 4e-5;
}

/// The derivative by a number of the state as a difference, beside the one that was found.
struct Compared {
  Vec3<double> force, moment;
  double vertical;
};
Compared difference(WheelRail& contact, const WheelState<double>& state, std::optional<double> force,
                    const StateQuantity& quantity, double half) {
  WheelState<double> below = state, above = state;
  quantity.of(below) -= half, quantity.of(above) += half;
  contact.reset();
  const auto low = contact.solve(below, force);
  contact.reset();
  const auto high = contact.solve(above, force);
  return {0.5 / half * (high.force - low.force), 0.5 / half * (high.moment - low.moment),
          0.5 / half * (high.vertical - low.vertical)};
}

double size(const Vec3<double>& v) {
  return std::sqrt(dot(v, v));
}

/// With the force held they are small differences of large ones, by the motion and by the height; the load bends most
/// over the height where it is small.
TEST(WheelRail, HasDerivativesOfALightlyLoadedWheel) {
  constexpr double load = 1e3;
  WheelRail contact(s1002_on_60e1(), {.tolerance = 1e-11});
  const WheelState<double> state = running(2e-3, 2e-3);
  WheelRailSolution found;
  WheelRailDerivatives d;
  contact.differentiate(state, load, found, d);
  for (std::size_t k = 0; k < state_numbers; ++k) {
    const StateQuantity& q = state_quantities()[k];
    if (q.name != "lateral" && q.name != "yaw" && q.name != "roll" && q.name != "deviation_roll") continue;
    const Compared wanted = difference(contact, state, load, q, half_step(q));
    EXPECT_LT(size(d.force(k) - wanted.force), 2e-3 * size(wanted.force) + 1) << q.name;
    EXPECT_NEAR(d.vertical(k), wanted.vertical, 1e-4 * std::abs(wanted.vertical) + 1e-6) << q.name;
  }
}

TEST(WheelRail, HasDerivativesByAllNumbersOfItsState) {
  for (const TrackSide side : {TrackSide::left, TrackSide::right}) {
    WheelRail contact(s1002_on_60e1(side), {.tolerance = 1e-11});
    for (const double y : {-4e-3, -2e-3, 0.0, 1.5e-3, 5e-3})
      for (const bool held : {false, true}) {
        WheelState<double> state = in_a_curve(y);
        if (side == TrackSide::right) state = state.mirrored();
        const auto loaded = contact.solve(state, 50e3);
        if (y == 5e-3) {
          EXPECT_EQ(loaded.patches.size(), 2U);
        }
        state.vertical = loaded.vertical;
        const std::optional<double> force = held ? std::optional(50e3) : std::nullopt;
        WheelRailSolution found;
        WheelRailDerivatives d;
        contact.differentiate(state, force, found, d);
        ASSERT_EQ(found.status, Status::ok);
        int off = 0;
        for (std::size_t k = 0; k < state_numbers; ++k) {
          const StateQuantity& q = state_quantities()[k];
          SCOPED_TRACE(q.name);
          if (held && q.name == "vertical") {
            EXPECT_EQ(size(d.force(k)) + size(d.moment(k)) + d.vertical(k), 0);
            continue;
          }
          const Compared wanted = difference(contact, state, force, q, half_step(q));
          // What hardly moves the wheel against the rail has the errors of larger numbers, whose sum it is.
          const double errors = q.unit == "m" || q.unit == "rad" ? 1e-6 * 1e9 : 0.3;
          off += size(d.force(k) - wanted.force) > 1e-4 * size(wanted.force) + errors ||
                 size(d.moment(k) - wanted.moment) > 1e-4 * size(wanted.moment) + errors;
          // A roll's is a sum over arms of 0.75 m, along which differences over 1e-10 m err by some 5e-7.
          EXPECT_NEAR(d.vertical(k), wanted.vertical, 1e-4 * std::abs(wanted.vertical) + 4e-7);
        }
        EXPECT_LE(off, 1) << y; // forces have kinks, where a row comes into contact or a cell begins to slide
        if (held) {             // held by a force, the height changes with it as the stiffness says
          const auto low = contact.solve(state, 49.995e3), high = contact.solve(state, 50.005e3);
          EXPECT_LT(size(d.force(state_numbers) - 0.1 * (high.force - low.force)), 1e-4);
          EXPECT_NEAR(d.vertical(state_numbers) * 10 / (high.vertical - low.vertical), 1, 1e-4);
          EXPECT_NEAR(d.force(state_numbers).z, 1, 1e-12);
          EXPECT_NEAR(d.force(0).z, 0, 1e-6);
        } else {
          EXPECT_EQ(size(d.force(state_numbers)), 0);
          EXPECT_EQ(d.vertical(1), 1);
        }
      }
  }
}

TEST(WheelRail, MovesAsCombinationsOfTheBasicNumbersDo) {
  const WheelRailBodies bodies = s1002_on_60e1();
  WheelRail contact(bodies);
  WheelState<double> state = in_a_curve(2e-3);
  state.vertical = contact.solve(state, 50e3).vertical;
  const auto here = contact.solve(state);
  const auto motions =
      relative_motions(nominal_placement(bodies.track, bodies.rail, bodies.wheelset, bodies.wheel), state);
  for (std::size_t k = 0; k < state_numbers; ++k) {
    const StateQuantity& q = state_quantities()[k];
    SCOPED_TRACE(q.name);
    const RelativeMotion& motion = motions[k];
    if (k < basic_motions) {
      for (std::size_t i = 0; i < basic_motions; ++i) EXPECT_NEAR(motion.combination[i], i == k, 1e-9);
      EXPECT_EQ(size(motion.turn), 0);
      continue;
    }
    const double half = half_step(q);
    WheelState<double> below = state, above = state;
    for (std::size_t i = 0; i < basic_motions; ++i) {
      *below.numbers()[i] -= half * motion.combination[i];
      *above.numbers()[i] += half * motion.combination[i];
    }
    const auto low = contact.solve(below), high = contact.solve(above);
    const Vec3<double> force = 0.5 / half * (high.force - low.force) + cross(motion.turn, here.force);
    const Vec3<double> moment = 0.5 / half * (high.moment - low.moment) + cross(motion.turn, here.moment);
    const Compared wanted = difference(contact, state, {}, q, half);
    // Rows are laid along the track's lateral, so a little of a turned rail remains.
    const double part = q.name == "deviation_roll" ? 1e-4 : 2e-5;
    const double remainder = q.unit == "m" || q.unit == "rad" ? 5 : 1e-3;
    EXPECT_LT(size(force - wanted.force), part * size(wanted.force) + remainder);
    EXPECT_LT(size(moment - wanted.moment), part * size(wanted.moment) + remainder);
  }
}

/// As long as the derivatives' own with the exact theory, where elements that come and go leave kinks in the forces.
double exact_half_step(const StateQuantity& q, bool held) {
  const double place = held ? 5e-6 : 1.4e-6;
  if (q.name == "yaw" || q.name == "deflection_yaw") return 2e-5;
  return q.unit == "m" ? place : q.unit == "rad" ? 2 * place : q.unit == "1/m" ? 2e-5 : q.unit == "m/s" ? 2e-4 : 4e-4;
}

TEST(WheelRail, HasDerivativesAtTheExactLevel) {
  for (const TrackSide side : {TrackSide::left, TrackSide::right})
    for (const bool held : {false, true}) {
      WheelRail contact(s1002_on_60e1(side), {.theory = Theory::exact, .elements = 16});
      WheelState<double> state = in_a_curve(2e-3);
      if (side == TrackSide::right) state = state.mirrored();
      state.vertical = contact.solve(state, 50e3).vertical;
      const std::optional<double> force = held ? std::optional(50e3) : std::nullopt;
      WheelRailSolution found;
      WheelRailDerivatives d;
      contact.differentiate(state, force, found, d);
      for (std::size_t k = 0; k < state_numbers; ++k) {
        const StateQuantity& q = state_quantities()[k];
        SCOPED_TRACE(q.name);
        const Compared wanted = difference(contact, state, force, q, exact_half_step(q, held));
        // Rail and axle turned together move the contact hardly, by a sum of ways on which kinks differ.
        const bool is_sum = q.name == "deflection_roll" || q.name == "deviation_roll";
        const double of_ways = is_sum ? 0.02 : 0, errors = q.unit == "m" || q.unit == "rad" ? 1e-6 * 1e9 : 0.3;
        EXPECT_LT(size(d.force(k) - wanted.force), 1e-3 * size(wanted.force) + of_ways * size(d.force(0)) + errors);
        EXPECT_LT(size(d.moment(k) - wanted.moment), 1e-3 * size(wanted.moment) + of_ways * size(d.moment(0)) + errors);
        EXPECT_NEAR(d.vertical(k), wanted.vertical, 1e-4 * std::abs(wanted.vertical) + 6e-6);
      }
      EXPECT_NEAR(d.force(state_numbers).z, held ? 1 : 0, 2e-6);
    }
}

/// Beside a line through forces within 0.05 mm, over the slope or, where that is less, mu times the load in a
/// centimetre. Where elements come and go slopes differ by some hundredths, and at 4.76 mm a second lobe comes into
/// contact.
TEST(WheelRail, HasTheSlopesOfItsForcesAtTheExactLevel) {
  constexpr double load = 80e3, least = 0.3 * load / 0.01, spacing = 1e-5;
  constexpr int places = 20;
  WheelRail contact(s1002_on_60e1(), {.theory = Theory::exact});
  std::vector<double> errors;
  for (int k = 0; k < places; ++k) {
    const double y = -5.741e-3 + 0.7e-3 * k;
    WheelRailSolution found;
    WheelRailDerivatives d;
    contact.differentiate(running(y, 2e-3), load, found, d);
    double sum = 0, squares = 0;
    for (int i = -5; i <= 5; ++i) {
      sum += i * contact.solve(running(y + i * spacing, 2e-3), load).force.y;
      squares += i * i * spacing;
    }
    const double slope = sum / squares;
    errors.push_back(std::abs(d.force(0).y - slope) / (std::abs(slope) + least));
    EXPECT_GT(d.force(0).y * slope, 0) << y;
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[places / 2], 0.006);
  EXPECT_LT(errors[places * 9 / 10], 0.1);
}

TEST(WheelRail, VariablesOfDerivativesStandInTheOrderOfTheTable) {
  ASSERT_EQ(state_quantities().size(), state_numbers);
  WheelState<double> state;
  const auto numbers = state.numbers();
  for (std::size_t k = 0; k < state_numbers; ++k) EXPECT_EQ(&state_quantities()[k].of(state), numbers[k]);
  const std::pair<WheelVariable, std::string_view> some[] = {
      {WheelVariable::yaw, "yaw"},
      {WheelVariable::yaw_velocity, "yaw_velocity"},
      {WheelVariable::curvature, "curvature"},
      {WheelVariable::deflection_yaw, "deflection_yaw"},
      {WheelVariable::deviation_lateral, "deviation_lateral"},
      {WheelVariable::deviation_roll_velocity, "deviation_roll_velocity"}};
  for (const auto& [variable, name] : some)
    EXPECT_EQ(state_quantities()[static_cast<std::size_t>(variable)].name, name);
  EXPECT_EQ(static_cast<std::size_t>(WheelVariable::vertical_force), state_numbers);
}

TEST(WheelRail, SaysWhereThereIsNoContact) {
  WheelRail contact(s1002_on_60e1());
  EXPECT_EQ(contact.solve(running(0.3, 0), 10e3).status, Status::no_contact);
  WheelState<double> high = running(0, 0);
  high.vertical = 0.01;
  const auto apart = contact.solve(high);
  EXPECT_EQ(apart.status, Status::no_contact);
  EXPECT_EQ(apart.force.z, 0);
  for (const double force : {0.0, -1e3, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(contact.solve(running(0, 0), force).status, Status::invalid_input);
  WheelState<double> nan = running(0, 0);
  nan.deflection.yaw = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(contact.solve(nan, 10e3).status, Status::invalid_input);
}

TEST(WheelRail, StandsAndRollsBackward) {
  WheelRail contact(s1002_on_60e1());
  WheelState<double> still;
  const auto s = contact.solve(still, 10e3);
  EXPECT_EQ(s.status, Status::ok);
  EXPECT_NEAR(s.force.x, 0, 1e-9);
  // Backward with the opposite turning: the same creepages along the track, forces reversed.
  WheelState<double> back = running(0, 0, 1e-3);
  back.forward_velocity *= -1, back.pitch_velocity *= -1;
  const auto b = contact.solve(back, 10e3), f = contact.solve(running(0, 0, 1e-3), 10e3);
  EXPECT_NEAR(b.force.x, -f.force.x, 1e-6 * 10e3);
}

TEST(WheelRail, RefusesWhatMakesNoSense) {
  const auto message = [](const WheelRailBodies& bodies, const WheelRailMethod& method = {}) {
    return error_of([&] { WheelRail(bodies, method); });
  };
  EXPECT_EQ(message(s1002_on_60e1()), "no error");
  WheelRailBodies bad = s1002_on_60e1();
  std::swap(bad.rail, bad.wheel);
  EXPECT_NE(message(bad).find("wheel"), std::string::npos);
  bad = s1002_on_60e1();
  bad.friction = {};
  EXPECT_NE(message(bad).find("friction"), std::string::npos);
  bad.friction = {{0.1, 0.3}, {0.1, 0.4}};
  EXPECT_NE(message(bad).find("friction angle"), std::string::npos);
  bad = s1002_on_60e1();
  bad.friction = {{0, 0}};
  EXPECT_EQ(message(bad), "no error");
  EXPECT_NE(message(bad, {.theory = Theory::exact}).find("friction = 0"), std::string::npos);
  bad.material.dissimilarity = 0.1;
  EXPECT_NE(message(bad).find("dissimilarity"), std::string::npos);
  EXPECT_NE(message(s1002_on_60e1(), {.elements = 0}).find("elements"), std::string::npos);
  bad = s1002_on_60e1();
  bad.track.gauge = -1;
  EXPECT_NE(message(bad).find("gauge"), std::string::npos);
}

} // namespace
} // namespace microslip
