// Inputs of bodies that layers and relaxation contain: creep of half-spaces, an interface layer.

#include "microslip/rolling/solver.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double radius = 0.1, half_width = 4e-3;
const Method classical = {.theory = Theory::exact, .discretisation = Discretisation::classical, .tolerance = 1e-10};

/// A ball, or a roller, on bodies that are still to be set.
RollingProblem rolling_on(const ElementGrid& grid, double load) {
  RollingProblem p;
  p.geometry =
      GapFormula{grid, [line = grid.line](double x, double y) { return (x * x + (line ? 0 : y * y)) / (2 * radius); }};
  p.load = {NormalLoad::Given::force, load};
  p.friction.law = FrictionLaw::coulomb(0.3);
  return p;
}

ElementGrid across_ball(int elements) {
  return ElementGrid::across_ellipse(half_width, half_width, elements, elements / 4);
}

ContactSolution solve(const RollingProblem& p) {
  ContactSolution s = Solver(classical).solve(p);
  EXPECT_EQ(s.report.status, Status::ok) << s.report.reason;
  return s;
}

void expect_same(const ContactSolution& a, const ContactSolution& b, double friction_limit, double tolerance) {
  EXPECT_NEAR(a.totals.fx, b.totals.fx, tolerance * friction_limit);
  EXPECT_NEAR(a.totals.fy, b.totals.fy, tolerance * friction_limit);
  EXPECT_NEAR(a.totals.mz, b.totals.mz, tolerance * friction_limit * half_width);
  EXPECT_NEAR(a.totals.my, b.totals.my, tolerance * friction_limit / 0.3 * half_width);
  EXPECT_NEAR(a.approach, b.approach, tolerance * b.approach);
  EXPECT_NEAR(a.totals.peak_pressure, b.totals.peak_pressure, tolerance * b.totals.peak_pressure);
}

/// Creep f (1 - exp(-t/T)) under a constant stress is a relaxation of the share g = f/(1 + f) with the time T/(1 + f):
/// bodies of `creep` are half-spaces of that Prony term, alone or as layers on themselves.
TEST(LayeredSpecialCases, CreepIsARelaxation) {
  const Material polymer1 = {400e6, 0.4}, polymer2 = {900e6, 0.3};
  const MaterialCreep creep1 = {1.5, 4e-3}, creep2 = {0.6, 2e-2};
  const auto relaxing = [](const Material& material, const MaterialCreep& c) {
    return ViscoelasticMaterial{material, {{c.ratio / (1 + c.ratio), c.time / (1 + c.ratio)}}};
  };
  for (const double speed : {1.0, -0.2}) {
    RollingProblem p = rolling_on(across_ball(12), 500);
    p.motion.creepage = {2e-3, -1e-3, 0.1};
    p.motion.rolling_speed = std::abs(speed);
    if (speed < 0) p.motion.direction = RollingDirection::backward;
    RollingProblem by_creep = p;
    by_creep.bodies = viscoelastic(polymer1, creep1, polymer2, creep2, speed);
    const ContactSolution expected = solve(by_creep);
    const LayeredBody body1 = {{}, relaxing(polymer1, creep1)}, body2 = {{}, relaxing(polymer2, creep2)};
    const LayeredBody on_itself = {{{1e-3, body2.substrate}, {5e-3, body2.substrate}}, body2.substrate};
    for (const LayeredBody& second : {body2, on_itself}) {
      p.layered = LayeredBodies{body1, second, speed};
      expect_same(solve(p), expected, 0.3 * 500, 1e-6);
    }
  }
}

/// A layer between half-spaces that is sheared by p h/G and rigid across, `layer`, is an incompressible one so thin
/// that it has no way to flow: with h/G kept, what is left falls with h, so that halving h twice extrapolates it.
TEST(LayeredSpecialCases, AnInterfaceLayerIsAThinIncompressibleOne) {
  const Material polymer = {1e9, 0.3};
  constexpr double flexibility = 1e-12; // h/G [m/Pa], beside a/G = 3e-12 m/Pa of a half-space
  RollingProblem p = rolling_on(across_ball(12), 500);
  p.friction.law = FrictionLaw::coulomb(10);
  p.motion.creepage = {2e-3, -1e-3, 0.1};
  RollingProblem between = p;
  between.bodies = combine(polymer, polymer);
  between.bodies.layer.flexibility = flexibility;
  const ContactSolution expected = solve(between);
  const auto with_layer = [&](double thickness) {
    p.layered = LayeredBodies{{{}, {polymer}}, {{{thickness, {{thickness / flexibility, 0.5}}}}, {polymer}}};
    return solve(p);
  };
  const double force = std::hypot(expected.totals.fx, expected.totals.fy);
  double before = 0, furthest = HUGE_VAL;
  for (const double h : {2.4e-4, 1.2e-4, 6e-5, 3e-5}) { // of a half-width of 3 mm
    const ContactSolution s = with_layer(h);
    const double away = std::hypot(s.totals.fx - expected.totals.fx, s.totals.fy - expected.totals.fy) / force;
    EXPECT_NEAR(s.approach / expected.approach, 1, 60 * h) << h;
    if (before > 0) {
      EXPECT_NEAR((2 * s.approach - before) / expected.approach, 1, 3e-4 * h / 3e-5) << h;
    }
    EXPECT_LT(away, 0.5 * furthest) << h;
    before = s.approach, furthest = away;
  }
  EXPECT_LT(furthest, 1e-3);
}

} // namespace
} // namespace microslip
