// Wear, fatigue and guidance of a wheel on a rail.

#include "microslip/damage/contact_damage.hpp"
#include "microslip/damage/fatigue.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/railway/derailment.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/support/s1002_on_60e1.hpp"
#include "tests/support/sphere_on_rail.hpp"
#include "tests/support/steel.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include <gtest/gtest.h>
#include <numeric>

namespace microslip {
namespace {

constexpr double hardness = 2.7e9, shear_yield = 300e6, friction = 0.3;

WheelRailBodies example(TrackSide side, const SurfaceStrength& strength) {
  WheelRailBodies bodies = s1002_on_60e1(side);
  bodies.strength = strength;
  return bodies;
}

double number_of(const WheelRailPatch& patch, std::string_view name) {
  const auto all = patch_quantities();
  return std::find_if(all.begin(), all.end(), [name](const auto& q) { return q.name == name; })->value(patch);
}

constexpr Theory theories[] = {Theory::fastsim2, Theory::exact};

TEST(WheelRailDamage, IsGivenWhereItsStrengthIs) {
  for (const Theory theory : theories)
    for (const bool hard : {false, true})
      for (const bool yields : {false, true}) {
        SurfaceStrength strength;
        if (hard) strength.hardness = hardness;
        if (yields) strength.shear_yield_strength = shear_yield;
        WheelRail contact(example(TrackSide::left, strength), {.theory = theory, .elements = 10});
        const auto s = contact.solve(running(6.1e-3, 2e-3, 0, 30), 80e3);
        ASSERT_EQ(s.status, Status::ok);
        for (const WheelRailPatch& patch : s.patches) {
          for (const auto* name : {"worn_area", "wear_depth"}) EXPECT_EQ(std::isnan(number_of(patch, name)), !hard);
          for (const auto* name : {"fatigue_index", "shakedown_load"})
            EXPECT_EQ(std::isnan(number_of(patch, name)), !yields);
          for (const auto* name : {"worn_mass_r8t", "t_gamma_per_area", "shakedown_limit", "nadal_limit"})
            EXPECT_FALSE(std::isnan(number_of(patch, name)));
        }
        EXPECT_EQ(s.fields.empty(), theory == Theory::fastsim2);
      }
}

TEST(WheelRailDamage, IsTheSameOnBothSides) {
  const SurfaceStrength strength{hardness, shear_yield};
  for (const Theory theory : theories) {
    WheelRail left(example(TrackSide::left, strength), {.theory = theory, .elements = 10}),
        right(example(TrackSide::right, strength), {.theory = theory, .elements = 10});
    const WheelState<double> state = running(6.1e-3, 2e-3, 0, 30);
    const auto a = left.solve(state, 80e3), b = right.solve(state.mirrored(), 80e3);
    ASSERT_EQ(a.patches.size(), b.patches.size());
    EXPECT_EQ(a.y_over_q, b.y_over_q);
    EXPECT_EQ(a.nadal_limit, b.nadal_limit);
    for (std::size_t k = 0; k < a.patches.size(); ++k) {
      const PatchDamage &one = a.patches[k].damage, &other = b.patches[k].damage;
      EXPECT_EQ(one.worn_area, other.worn_area);
      EXPECT_EQ(one.wear_depth, other.wear_depth);
      EXPECT_EQ(one.fatigue_index, other.fatigue_index);
      EXPECT_EQ(number_of(a.patches[k], "nadal_limit"), number_of(b.patches[k], "nadal_limit"));
    }
  }
}

// With one wear coefficient volume is work over mu and hardness; the simplified theory's bound is not quite mu p.
TEST(WheelRailDamage, WearIsTheWorkOfFriction) {
  constexpr double k = 6e-4;
  const SurfaceStrength strength{hardness, {}, {.slow = k, .medium = k, .fast = k, .seizure = k}};
  for (const Theory theory : theories)
    for (const double lateral : {-3e-3, 2e-3, 6.1e-3}) {
      WheelRail contact(example(TrackSide::left, strength), {.theory = theory, .elements = 16, .fields = true});
      const auto s = contact.solve(running(lateral, 4e-3, 0, 30), 80e3);
      ASSERT_EQ(s.status, Status::ok);
      ASSERT_EQ(s.fields.size(), s.patches.size());
      for (std::size_t i = 0; i < s.patches.size(); ++i) {
        const WheelRailPatch& patch = s.patches[i];
        const auto work = friction_work(s.fields[i]);
        const double expected = k / (friction * hardness) *
                                std::inner_product(work.begin(), work.end(), s.fields[i].elements.area.begin(), 0.0);
        EXPECT_NEAR(*patch.damage.worn_area / expected, 1, theory == Theory::exact ? 1e-4 : 0.15) << lateral;
        double sum = 0;
        for (const DamageField& field : damage_fields())
          if (field.name == "wear_depth")
            for (const double depth : field.values(s.fields[i], strength, patch.rolling_speed)) sum += depth;
        EXPECT_NEAR(sum * s.fields[i].elements.grid.dy, *patch.damage.worn_area, 1e-12 * expected);
      }
    }
}

TEST(WheelRailDamage, FieldsOfBothLevelsHaveTheForcesAndThePowerOfTheirPatches) {
  const WheelRailMethod planes{.theory = Theory::exact, .shape = PatchShape::flat, .elements = 16};
  const WheelRailMethod surfaces{.theory = Theory::exact, .elements = 16};
  for (const WheelRailMethod& method : {WheelRailMethod{.fields = true}, planes, surfaces})
    for (const double lateral : {-3e-3, 2e-3, 6.1e-3}) {
      WheelRail contact(example(TrackSide::left, {}), method);
      const auto s = contact.solve(running(lateral, 4e-3, 0, 30), 80e3);
      ASSERT_EQ(s.fields.size(), s.patches.size());
      for (std::size_t i = 0; i < s.patches.size(); ++i) {
        const ContactSolution& f = s.fields[i];
        const WheelRailPatch& patch = s.patches[i];
        double normal = 0;
        for (std::size_t k = 0; k < f.elements.size(); ++k) normal += f.fields.pressure[k] * f.elements.area[k];
        // Rows lean against one another by the turn of the surface; fields of fastsim2 have rows of equal width in one
        // plane.
        const bool is_exact = method.theory == Theory::exact, is_plane = method.surface() == PatchShape::flat;
        const double rows = is_exact ? 1e-6 : 2e-3, turn = is_plane ? 0 : std::abs(patch.turn);
        EXPECT_NEAR(normal / patch.normal_force, 1, rows + 1 - std::cos(turn));
        EXPECT_NEAR(f.totals.fx, patch.fx, rows * normal);
        EXPECT_NEAR(f.totals.fy, patch.fs, (rows + std::sin(turn)) * normal);
        EXPECT_NEAR(f.totals.mz, patch.moment, (is_plane ? 1e-8 : 2e-6) * normal);
        EXPECT_NEAR(f.totals.frictional_power / patch.frictional_power, 1, rows);
        EXPECT_NEAR(f.totals.slip_area, patch.slip_area, (is_exact ? 1e-6 : 0.1) * patch.contact_area);
      }
    }
}

/// A sphere of 0.1 m on a rail that is a cylinder of 0.1 m along the track, and its state with a contact angle [rad].
WheelRail sphere_on_cylinder(Theory theory) {
  WheelRailBodies bodies = sphere_on_rail(0.1, 0.1);
  bodies.strength = {hardness, shear_yield};
  return WheelRail(std::move(bodies), {.theory = theory, .elements = 24});
}
WheelState<double> leaning(double angle) {
  WheelState<double> state;
  state.lateral = -0.2 * std::sin(angle);
  state.forward_velocity = 2, state.pitch_velocity = 2 / (0.1 * std::cos(angle));
  return state;
}

// A wheel that slides down on its rail: the rail pushes it towards the track's centre by Nadal's Y/Q.
TEST(WheelRailDamage, YOverQIsNadalsWhereAWheelSlidesDown) {
  for (const Theory theory : theories)
    for (const double angle : {0.05, 0.15}) {
      WheelRail contact = sphere_on_cylinder(theory);
      WheelState<double> state = leaning(angle);
      state.lateral_velocity = -std::cos(angle), state.vertical_velocity = -std::sin(angle);
      const auto down = contact.solve(state, 5e3);
      ASSERT_EQ(down.status, Status::ok);
      ASSERT_EQ(down.patches.size(), 1u);
      EXPECT_NEAR(*down.y_over_q, nadal_limit(angle, friction), 2e-3);
      EXPECT_NEAR(*down.y_over_q, number_of(down.patches[0], "nadal_limit"), 2e-3);
      // Going up: friction holds it down.
      state.lateral_velocity *= -1, state.vertical_velocity *= -1;
      EXPECT_NEAR(*contact.solve(state, 5e3).y_over_q, nadal_limit(angle, -friction), 2e-3);
    }
}

TEST(WheelRailDamage, NadalsLimitIsThatOfTheAngleOfFriction) {
  EXPECT_NEAR(nadal_limit(std::numbers::pi / 2, 0.25), 4, 1e-12);
  for (const double angle : {0.2, 0.8, 1.2})
    for (const double mu : {0.0, 0.1, 0.5}) EXPECT_NEAR(nadal_limit(angle, mu), std::tan(angle - std::atan(mu)), 1e-12);
  WheelRail contact(example(TrackSide::left, {}));
  const auto s = contact.solve(running(0, 0, 0, 30), 80e3);
  // S1002: 70 degrees.
  EXPECT_NEAR(*s.nadal_limit, std::tan(70 * std::numbers::pi / 180 - std::atan(friction)), 0.01);
  WheelRail sphere = sphere_on_cylinder(Theory::fastsim2);
  EXPECT_LT(std::abs(*sphere.solve(leaning(0), 5e3).y_over_q), 1e-3);
}

TEST(WheelRailDamage, FatigueIndexIsHertzs) {
  for (const Theory theory : theories) {
    WheelRail contact = sphere_on_cylinder(theory);
    WheelState<double> state = leaning(0);
    state.pitch_velocity *= 1.05;
    const auto s = contact.solve(state, 5e3);
    ASSERT_EQ(s.patches.size(), 1u);
    const HertzContact hertz =
        hertz_from_load(gap_curvatures({0.1, std::numeric_limits<double>::infinity(), 0.1, 0.1}), steel, 5e3);
    const double expected = friction - 2 * std::numbers::pi * hertz.a * hertz.b * shear_yield / (3 * 5e3);
    EXPECT_NEAR(*s.patches[0].damage.fatigue_index, expected, theory == Theory::exact ? 2e-3 : 0.02);
    EXPECT_NEAR(*s.patches[0].damage.shakedown_load / (hertz.peak_pressure / shear_yield), 1,
                theory == Theory::exact ? 0.01 : 0.08);
    EXPECT_EQ(number_of(s.patches[0], "shakedown_limit"),
              point_shakedown_limit(number_of(s.patches[0], "traction_coefficient")));
  }
}

TEST(WheelRailDamage, RefusesStrengthsOutOfRange) {
  expect_error([] { WheelRail contact(example(TrackSide::left, {-1.0, {}})); }, "hardness", "[Pa]: must be positive");
  expect_error(
      [] {
        WheelRail contact(example(TrackSide::left, {{}, 0.0}));
      },
      "shear_yield_strength", "[Pa]: must be positive");
}

} // namespace
} // namespace microslip
