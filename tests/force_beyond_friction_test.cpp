#include "microslip/rolling/solver.hpp"
#include "tests/support/steel.hpp"

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double friction = 0.3, load = 10e3, speed = 10;
const Material soft = {20e9, 0.4};
const ThermalBody hot = {20, 50, 7850, 450};

/// A kind of problem, with the largest force that its friction can bear.
struct Kind {
  std::string name;
  std::function<void(RollingProblem&, Method&)> set;
  double limit = friction * load; ///< [N]
  bool falls = false;             ///< what sliding bears may be less than the limit
};

RollingProblem ellipse() {
  RollingProblem p;
  p.geometry = Ellipse{4e-3, 3e-3};
  p.bodies = steel;
  p.load = {NormalLoad::Given::force, load};
  p.friction.law = FrictionLaw::coulomb(friction);
  p.motion.rolling_speed = speed;
  p.motion.creepage = {1e-4, -2e-4, 0.05};
  return p;
}

GapFormula sphere() {
  return {ElementGrid::across_ellipse(3e-3, 3e-3, 11, 11, 3), [](double x, double y) { return (x * x + y * y) / 0.6; }};
}

const std::vector<Kind> kinds = {
    {"second order", [](auto&, auto&) {}},
    {"classical", [](auto&, Method& m) { m.discretisation = Discretisation::classical; }},
    {"patch", [](RollingProblem& p, auto&) { p.geometry = sphere(); }},
    {"classical patch",
     [](RollingProblem& p, Method& m) { p.geometry = sphere(), m.discretisation = Discretisation::classical; }},
    {"shift", [](RollingProblem& p, auto&) { p.motion.kind = ContactMotion::shift; }},
    {"transient", [](RollingProblem& p, auto&) { p.motion.kind = ContactMotion::transient; }},
    {"transient by a step",
     [](RollingProblem& p, auto&) { p.motion.kind = ContactMotion::transient, p.motion.step = 3e-4; }},
    {"backward", [](RollingProblem& p, auto&) { p.motion.direction = RollingDirection::backward; }},
    {"unequal bodies", [](RollingProblem& p, auto&) { p.bodies = combine(steel_body, soft); }},
    {"unequal bodies in turn",
     [](RollingProblem& p, Method& m) { p.bodies = combine(steel_body, soft), m.coupling = Coupling::alternating; }},
    {"shift of unequal bodies with falling friction",
     [](RollingProblem& p, auto&) {
       p.bodies = combine(steel_body, soft), p.motion.kind = ContactMotion::shift;
       p.friction.law = FrictionLaw::exponential(0.1, {0.2, 1e-6});
     },
     friction* load, true},
    {"viscoelastic",
     [](RollingProblem& p, auto&) {
       p.bodies = viscoelastic(steel_body, {1, 1e-4}, steel_body, {1, 1e-4}, speed);
     }},
    {"one viscoelastic body",
     [](RollingProblem& p, auto&) {
       p.bodies = viscoelastic(steel_body, {1, 1e-4}, steel_body, {}, speed);
     }},
    {"falling friction",
     [](RollingProblem& p, auto&) {
       p.friction.law = FrictionLaw::linear(0.1, {0.2, 0.01});
     },
     friction* load, true},
    {"falling friction from above",
     [](RollingProblem& p, Method& m) {
       p.friction.law = FrictionLaw::rational(0.1, {0.2, 0.01}), m.slip_start = SlipStart::above;
     },
     friction* load, true},
    {"heat",
     [](RollingProblem& p, auto&) {
       p.thermal = {hot, hot}, p.friction.temperature_effect = {{-0.1, 100, 200}};
     },
     friction* load, true},
    {"friction that grows with heat",
     [](RollingProblem& p, auto&) {
       p.thermal = {hot, hot}, p.friction.temperature_effect = {{0.1, 100, 200}};
     },
     0.4 * load, true},
    {"elastic layer", [](RollingProblem& p, auto&) { p.bodies.layer.flexibility = 1e-14; }},
    {"hardening layer",
     [](RollingProblem& p, auto&) {
       p.bodies.layer = {1e-14, 50e6, 1e13};
     }},
};

/// Forces of some size along a direction, or along x or y alone.
std::vector<Motion> forces(const Motion& motion, double size) {
  Motion x = motion, y = motion, both = motion;
  x.force_x = -size, y.force_y = size;
  both.force_x = -0.6 * size, both.force_y = 0.8 * size;
  return {x, y, both};
}

void expect_full_sliding(const ContactSolution& s, double limit) {
  EXPECT_EQ(s.report.status, Status::no_solution);
  EXPECT_FALSE(s.report.reason.empty());
  EXPECT_EQ(s.report.newton_steps, 0);
  EXPECT_TRUE(std::isfinite(s.totals.fx + s.totals.fy + s.totals.mz + s.totals.frictional_power));
  EXPECT_NEAR(std::hypot(s.totals.fx, s.totals.fy), limit, 2e-3 * limit);
  EXPECT_EQ(s.totals.adhesion_area, 0);
}

TEST(ForceBeyondFriction, IsAnsweredAtOnceForEveryKindOfProblem) {
  for (const Kind& kind : kinds) {
    RollingProblem p = ellipse();
    Method method{.mx = 11, .my = 10};
    kind.set(p, method);
    for (const double share : {1.005, 3.0})
      for (const Motion& motion : forces(p.motion, share * kind.limit)) {
        SCOPED_TRACE(kind.name + " " + std::to_string(share));
        p.motion = motion;
        expect_full_sliding(Solver(method).solve(p), kind.limit);
      }
  }
}

TEST(ForceBeyondFriction, ForcesJustWithinHaveASolution) {
  for (const Kind& kind : kinds) {
    if (kind.falls) continue;
    SCOPED_TRACE(kind.name);
    RollingProblem p = ellipse();
    Method method{.mx = 11, .my = 10};
    kind.set(p, method);
    p.motion.force_x = -0.9 * kind.limit;
    const ContactSolution s = Solver(method).solve(p);
    EXPECT_EQ(s.report.status, Status::ok);
    EXPECT_NEAR(s.totals.fx, -0.9 * kind.limit, 1e-4 * kind.limit);
  }
}

/// A layer that does not harden bears its yield stress where that is less than friction's.
TEST(ForceBeyondFriction, OfALayerThatYieldsIsWhatTheLayerBears) {
  for (const double hardening : {0.0, -1e10})
    for (const bool retarded : {false, true}) {
      RollingProblem p = ellipse();
      if (retarded) p.bodies = viscoelastic(steel_body, {1, 1e-4}, steel_body, {1, 1e-4}, speed);
      p.bodies.layer = {1e-14, 50e6, hardening};
      p.motion.force_x = 0.9 * friction * load;
      const ContactSolution s = Solver({.mx = 11, .my = 10}).solve(p);
      double bears = 0;
      for (std::size_t k = 0; k < s.elements.size(); ++k)
        bears += s.elements.area[k] * std::min(friction * s.fields.pressure[k], 50e6);
      ASSERT_LT(bears, 0.9 * friction * load);
      expect_full_sliding(s, bears);
      EXPECT_NEAR(s.report.residual, 0.9 * friction * load / bears - 1, 1e-9);
    }
}

TEST(ForceBeyondFriction, WithoutFrictionNoForceIsBorne) {
  for (const bool unequal : {false, true}) {
    RollingProblem p = ellipse();
    if (unequal) p.bodies = combine(steel_body, soft);
    p.bodies.layer.flexibility = 1e-14;
    p.friction.law = FrictionLaw::coulomb(0);
    p.motion.force_x = 1;
    const ContactSolution s = Solver({.mx = 6, .my = 6}).solve(p);
    EXPECT_EQ(s.report.status, Status::no_solution);
    EXPECT_EQ(s.totals.fx, 0);
    p.motion.force_x = 0;
    EXPECT_EQ(Solver({.mx = 6, .my = 6}).solve(p).report.status, Status::ok);
  }
}

} // namespace
} // namespace microslip
