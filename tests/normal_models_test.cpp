// Models of the normal problem that validation compares with the exact theory.

#include "validation/models/normal_models.hpp"

#include "microslip/rolling/solver.hpp"
#include "tests/support/steel.hpp"
#include "validation/models/equivalent_ellipse.hpp"
#include "validation/models/exactly_rolled.hpp"
#include "validation/models/kik_piotrowski.hpp"
#include "validation/models/pressed_wheel.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::validation {
namespace {

using std::numbers::pi;

constexpr double approach = 60e-6;

PatchGap gap_of(double along, double spacing, const std::function<double(double y)>& height, double curvature) {
  constexpr std::size_t rows = 400; // to either side
  PatchGap gap{.along = along, .at_point = curvature / 2, .spacing = spacing, .origin = rows, .heights = {}};
  for (std::size_t k = 0; k <= 2 * rows; ++k) gap.heights.push_back(height((double(k) - double(rows)) * spacing));
  return gap;
}

/// A x^2 + B y^2.
PatchGap paraboloid(double along, double across) {
  const double b = std::sqrt(approach / across);
  return gap_of(
      along, b / 150, [=](double y) { return across * y * y; }, 2 * across);
}

/// A head that is flatter on one side.
PatchGap two_radii(double scale, bool mirrored = false) {
  const auto height = [=](double y) { return (((y > 0) != mirrored) ? 0.4 : 2.0) * y * y / scale; };
  return gap_of(1 / scale, 1e-4 * scale, height, 2 / scale);
}

bool is_hertzian(const NormalModel& model) {
  return model.press != kik_piotrowski && model.press != kik_piotrowski_corrected;
}

TEST(NormalModels, MostHaveHertzOfParaboloids) {
  for (const double across : {0.3, 1.0, 4.0}) {
    const PatchGap gap = paraboloid(1.1, across);
    const HertzContact hertz = hertz_from_approach({1.1, across}, steel, approach);
    for (const NormalModel& model : normal_models()) {
      if (!is_hertzian(model)) continue;
      const NormalPatch patch = model.press(gap, steel, approach);
      EXPECT_NEAR(patch.force() / hertz.normal_force, 1, 0.003) << model.name << across;
      EXPECT_NEAR(patch.area() / (pi * hertz.a * hertz.b), 1, 0.003) << model.name << across;
      EXPECT_NEAR(patch.peak() / hertz.peak_pressure, 1, 0.003) << model.name << across;
      EXPECT_NEAR(patch.length() / (2 * hertz.a), 1, 0.003) << model.name << across;
      EXPECT_NEAR(patch.width() / (2 * hertz.b), 1, 0.003) << model.name << across;
    }
  }
}

/// On a sphere Hertz's radius is that of half the approach, Kik & Piotrowski's that of 0.55: area 1.1, load its root.
TEST(NormalModels, KikAndPiotrowskiOnASphere) {
  const HertzContact hertz = hertz_from_approach({1, 1}, steel, approach);
  const double size = std::sqrt(1.1);
  for (const auto press : {kik_piotrowski, kik_piotrowski_corrected}) {
    const NormalPatch patch = press(paraboloid(1, 1), steel, approach);
    EXPECT_NEAR(patch.area() / (pi * hertz.a * hertz.b), 1.1, 0.003);
    EXPECT_NEAR(patch.length() / (2 * hertz.a), size, 0.003);
    EXPECT_NEAR(patch.force() / hertz.normal_force, size, 0.003);
    EXPECT_NEAR(patch.peak() / hertz.peak_pressure, 1 / size, 0.003);
  }
}

/// The correction of the shape keeps the area and gives Hertz's ratio of axes; similar ellipses with the same approach
/// have loads in proportion to their size.
TEST(NormalModels, CorrectedShapeIsHertzs) {
  for (const double across : {0.2, 5.0}) {
    const PatchGap gap = paraboloid(1, across);
    const HertzContact hertz = hertz_from_approach({1, across}, steel, approach);
    const NormalPatch plain = kik_piotrowski(gap, steel, approach),
                      patch = kik_piotrowski_corrected(gap, steel, approach);
    EXPECT_NEAR(plain.length() / plain.width(), std::sqrt(across), 0.01 * std::sqrt(across));
    EXPECT_NEAR(patch.length() / patch.width() / (hertz.a / hertz.b), 1, 0.005);
    EXPECT_NEAR(patch.area() / plain.area(), 1, 1e-12);
    EXPECT_NEAR(patch.area() / (pi * 0.55 * approach / std::sqrt(across)), 1, 0.003);
    EXPECT_NEAR(patch.force() / hertz.normal_force, std::sqrt(patch.area() / (pi * hertz.a * hertz.b)), 0.005);
  }
}

/// Without a length of its own each model keeps pressures when all lengths grow; loads are in proportion to moduli. B
/// of a row is taken over 0.5 mm, so what depends on it is left out where B varies.
TEST(NormalModels, AreSimilarAndLinearInTheModulus) {
  constexpr double scale = 2;
  for (const NormalModel& model : normal_models()) {
    const NormalPatch one = model.press(two_radii(1), steel, approach);
    CombinedMaterial harder = steel;
    harder.shear_modulus *= 3;
    EXPECT_NEAR(model.press(two_radii(1), harder, approach).force() / one.force(), 3, 1e-9) << model.name;
    const bool uses_rows = model.name == "STRIPES" || model.name == "ANALYN";
    const NormalPatch large = model.press(two_radii(scale), steel, scale * approach);
    EXPECT_NEAR(large.force() / (scale * scale * one.force()), 1, uses_rows ? 0.02 : 1e-9) << model.name;
    EXPECT_NEAR(large.area() / (scale * scale * one.area()), 1, uses_rows ? 0.02 : 1e-9) << model.name;
  }
}

TEST(NormalModels, AreMirrored) {
  for (const NormalModel& model : normal_models()) {
    const NormalPatch one = model.press(two_radii(1), steel, approach),
                      other = model.press(two_radii(1, true), steel, approach);
    ASSERT_EQ(one.strips.size(), other.strips.size()) << model.name;
    for (std::size_t k = 0; k < one.strips.size(); ++k) {
      const Strip &s = one.strips[k], &t = other.strips[other.strips.size() - 1 - k];
      EXPECT_NEAR(s.y, -t.y, 1e-9) << model.name;
      EXPECT_NEAR(s.load, t.load, 1e-9 * one.force()) << model.name;
      EXPECT_NEAR(s.half_length, t.half_length, 1e-9) << model.name;
    }
  }
}

TEST(NormalPatch, PressureOfHertzPressesInByTheApproach) {
  for (const double across : {0.1, 1.0, 20.0}) {
    const HertzContact hertz = hertz_from_approach({1, across}, steel, approach);
    const NormalPatch patch = pressed_at_point(in_rows(hertz).strips, steel, approach);
    EXPECT_NEAR(patch.force() / hertz.normal_force, 1, 0.004) << across;
  }
}

/// Squared half-lengths that fall linearly to both ends from a row in the middle.
TEST(NormalPatch, WidthEndsWhereSquaredLengthsVanish) {
  std::vector<double> lengths;
  for (int k = -3; k <= 3; ++k) lengths.push_back(std::sqrt(3.25 - std::abs(k)));
  EXPECT_NEAR(width_of_rows(lengths, 2.0), 2 * 6.5, 1e-12);
  EXPECT_EQ(width_of_rows({}, 2.0), 0);
}

TEST(NormalPatch, FewerRowsBearTheSameLoad) {
  const NormalPatch patch = in_rows(hertz_from_approach({1, 2}, steel, approach)), fewer = patch.with_rows(24);
  EXPECT_LE(fewer.strips.size(), 24U);
  EXPECT_NEAR(fewer.force() / patch.force(), 1, 1e-12);
  EXPECT_NEAR(fewer.area() / patch.area(), 1, 0.01);
}

TEST(NormalPatch, RollsAsTheEllipseThatItIs) {
  constexpr double friction = 0.3;
  const HertzContact hertz = hertz_from_approach({1, 1.5}, steel, approach);
  const Creepage creepage{-4e-4, 3e-4, 0.1};
  const ContactForces forces = Solver(Method{.mx = 40, .my = 40})
                                   .solve(rolling_problem({.a = hertz.a,
                                                           .b = hertz.b,
                                                           .shear_modulus = steel.shear_modulus,
                                                           .poisson_ratio = steel.poisson_ratio,
                                                           .normal_force = hertz.normal_force,
                                                           .friction = FrictionLaw::coulomb(friction),
                                                           .creepage = creepage}))
                                   .forces();
  const auto found = exactly_rolled(in_rows(hertz), steel, creepage, friction, 24);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x, forces.fx, 0.003 * friction * hertz.normal_force);
  EXPECT_NEAR(found->y, forces.fy, 0.003 * friction * hertz.normal_force);
}

/// A cylindrical wheel above the middle of a rail.
WheelRailBodies bodies_of(const Profile& rail, const Profile& wheel) {
  WheelRailBodies bodies{
      .rail = rail, .wheel = wheel, .track = {}, .wheelset = {}, .material = steel, .friction = {{0, 0.3}}};
  bodies.track.rail_origin = ProfilePoint{0.75, 0};
  return bodies;
}

Profile profile_of(ProfileRole role, double half_width, const std::function<double(double)>& z) {
  constexpr int count = 400;
  std::vector<ProfilePoint> points;
  for (int k = 0; k <= count; ++k) {
    const double y = half_width * (2.0 * k / count - 1);
    points.push_back({y, z(y)});
  }
  return Profile(role, points);
}

/// A cylindrical wheel on a round rail is Hertz's contact of crossed cylinders, and yaw changes next to nothing of it.
TEST(ModelledWheel, OfACylinderOnARoundRailIsHertzs) {
  constexpr double radius = 0.3, load = 80e3;
  const Profile rail =
      profile_of(ProfileRole::rail, 0.03, [](double y) { return std::sqrt(radius * radius - y * y) - radius; });
  const Profile wheel = profile_of(ProfileRole::wheel, 0.05, [](double) { return 0; });
  const WheelRailBodies bodies = bodies_of(rail, wheel);
  const HertzContact hertz = hertz_from_load({0.5 / bodies.wheelset.nominal_radius, 0.5 / radius}, steel, load);
  ModelledWheel modelled(bodies);
  for (const double yaw : {0.0, 5e-3}) {
    WheelState<double> state;
    state.yaw = yaw, state.forward_velocity = 20, state.pitch_velocity = 20 / bodies.wheelset.nominal_radius;
    modelled.place(state);
    for (const NormalModel& model : normal_models()) {
      const PressedWheel pressed = modelled.press(model, load, 0);
      ASSERT_TRUE(pressed.bears_load) << model.name;
      ASSERT_EQ(pressed.patches.size(), 1U) << model.name;
      EXPECT_NEAR(pressed.force().z / load, 1, 1e-6) << model.name;
      if (!is_hertzian(model)) continue;
      EXPECT_NEAR(pressed.lowering / hertz.approach, 1, 0.003) << model.name;
      EXPECT_NEAR(pressed.patches[0].normal.peak() / hertz.peak_pressure, 1, 0.004) << model.name;
    }
  }
}

/// Friction moves horizontal forces to the side that creepages say, and no further than mu times the load.
TEST(ModelledWheel, RollsWithinFriction) {
  constexpr double load = 80e3, friction = 0.3;
  const Profile rail = profile_of(ProfileRole::rail, 0.03, [](double y) { return -y * y; });
  const Profile wheel = profile_of(ProfileRole::wheel, 0.05, [](double) { return 0; });
  const WheelRailBodies bodies = bodies_of(rail, wheel);
  ModelledWheel modelled(bodies);
  WheelState<double> state;
  state.forward_velocity = 20, state.pitch_velocity = 1.02 * 20 / bodies.wheelset.nominal_radius;
  modelled.place(state);
  for (const NormalModel& model : normal_models()) { // a wheel that turns too fast pulls forwards
    const PressedWheel pressed = modelled.press(model, load, friction);
    EXPECT_NEAR(pressed.force().x, friction * load, 1e-3 * load) << model.name;
    EXPECT_GT(pressed.patches[0].power, 0) << model.name;
  }
}

} // namespace
} // namespace microslip::validation
