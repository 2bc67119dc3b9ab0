// Friction that depends on the slip velocity, and the solutions that go with it.

#include "microslip/exact/classical/slip_friction.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/rolled.hpp"
#include "tests/support/steel.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const ElementGrid grid = {6, 2, -2.5e-3, 0, 1e-3, 1e-3};
const FrictionLaw law = FrictionLaw::exponential(0.1, {.drop = 0.3, .half_velocity = 2});

TEST(SlipFriction, WithoutMemoryIsTheLaw) {
  const FrictionLaw laws[] = {law, FrictionLaw::coulomb(0.2)};
  const SlipFriction friction(grid, laws, {}, {},
                              {.time = 1e-3, .along_rows = true, .from_high_x = true, .before = {}});
  EXPECT_FALSE(friction.is_constant());
  const std::vector<double> v = {0, 1, 2, 4, 8, 100, 0, 1, 2, 4, 8, 100};
  const auto mu = friction.state(v, std::vector<double>(12)).friction;
  for (std::size_t k = 0; k < 6; ++k) EXPECT_DOUBLE_EQ(mu[k], law.coefficient(v[k]));
  for (std::size_t k = 6; k < 12; ++k) EXPECT_DOUBLE_EQ(mu[k], 0.2);
  EXPECT_EQ(friction.static_coefficients()[0], 0.4);
}

TEST(SlipFriction, RemembersAlongARow) {
  // At a constant slip velocity the coefficient nears the law's by the factor theta from element to element, from the
  // leading edge on.
  const FrictionLaw laws[] = {law};
  const double d = 3e-3, time = 1e-3, v = 2;
  const SlipFriction friction(grid, laws, {.distance = d, .slowest = 0.1}, {},
                              {.time = time, .along_rows = true, .from_high_x = true, .before = {}});
  const auto mu = friction.state(std::vector<double>(12, v), std::vector<double>(12)).friction;
  const double theta = d / (d + time * v), limit = law.coefficient(v);
  for (int j = 0; j < 2; ++j)
    for (int n = 1; n <= 6; ++n)
      EXPECT_NEAR(mu[static_cast<std::size_t>(j * 6 + 6 - n)], limit + std::pow(theta, n) * (0.4 - limit), 1e-14);
}

TEST(SlipFriction, ForgetsWithTimeEvenInAdhesion) {
  const FrictionLaw laws[] = {law};
  const SlipFriction friction(
      grid, laws, {.distance = 1e-3, .slowest = 0.5}, {},
      {.time = 1e-3, .along_rows = false, .from_high_x = true, .before = std::vector<double>(12, 0.15)});
  const double theta = 1e-3 / (1e-3 + 1e-3 * 0.5);
  const std::vector<double> none(12);
  for (const double mu : friction.state(none, none).friction) EXPECT_NEAR(mu, theta * 0.15 + (1 - theta) * 0.4, 1e-15);
}

TEST(SlipFriction, RefusesWhatMakesNoSense) {
  const std::vector<FrictionLaw> three(3, law);
  EXPECT_THROW(SlipFriction(grid, three, {}, {}, {}), Error);
  expect_error([&] { SlipFriction(grid, std::span(three).first(1), {.distance = -1, .slowest = 0}, {}, {}); },
               "friction_memory.distance", "m");
}

/// A cylinder that rolls.
ContactStep cylinder(double creepage, const FrictionLaw& friction) {
  const double a = 4e-3, curvature = 1 / 0.92;
  ContactStep step;
  step.grid = ElementGrid::across_line(a, 60, 2);
  step.bodies = steel;
  for (int i = 0; i < step.grid.mx; ++i) step.gap.push_back(curvature * step.grid.x(i) * step.grid.x(i));
  const double load = line_contact_from_half_width(curvature, steel, a).force_per_length;
  step.load = {NormalLoad::Given::force, load};
  step.friction = {friction};
  step.motion.creepage = {creepage, 0, 0};
  step.motion.rolling_speed = 45;
  step.motion.tolerance = 1e-8;
  return step;
}

/// mu pn of every element belongs to its slip.
void expect_consistent(const ContactStep& step, const ContactStepSolution& s) {
  ASSERT_EQ(s.report.status, Status::ok);
  for (std::size_t k = 0; k < step.grid.count(); ++k) {
    if (s.fields.state[k] != CellState::slip) continue;
    const double v = step.motion.rolling_speed * std::hypot(s.fields.slip.x[k], s.fields.slip.y[k]);
    EXPECT_NEAR(std::hypot(s.fields.traction.x[k], s.fields.traction.y[k]),
                step.friction[0].coefficient(v) * s.normal.pressure[k], 1e-4 * s.normal.peak_pressure);
  }
}

TEST(SlipFriction, TractionsGoWithTheSlip) {
  const FrictionLaw falling = FrictionLaw::exponential(0.18, {.drop = 0.12, .half_velocity = 0.1});
  double last = 1;
  for (const double creepage : {1e-3, 3e-3, 1e-2, 1e-1}) {
    const ContactStep step = cylinder(creepage, falling);
    const ContactStepSolution s = ContactSequence().solve(step);
    expect_consistent(step, s);
    const double force = -s.totals.fx / (0.3 * s.normal_force);
    EXPECT_TRUE(creepage <= 3e-3 || force < last) << force; // falls once all slides
    last = force;
  }
  EXPECT_NEAR(last, 0.6, 1e-3); // kinetic friction at last
}

TEST(SlipFriction, ThatIsConstantIsCoulombs) {
  const FrictionLaw flat = FrictionLaw::linear(0.3, {.drop = 1e-13, .half_velocity = 1});
  const auto falling = ContactSequence().solve(cylinder(1e-3, flat));
  const auto coulomb = ContactSequence().solve(cylinder(1e-3, FrictionLaw::coulomb(0.3)));
  EXPECT_TRUE(coulomb.slip_friction.friction.empty());
  EXPECT_NEAR(falling.totals.fx, coulomb.totals.fx, 1e-6 * coulomb.normal_force);
}

TEST(SlipFriction, HasTwoSolutionsInATimeStepOfWhichTheStartDecides) {
  // Vollebregt & Schuttelaars 2012: from the steady state on, a step with slip from below and one with slip from above.
  const FrictionLaw falling = FrictionLaw::exponential(0.18, {.drop = 0.12, .half_velocity = 0.1});
  ContactSequence sequence;
  ContactStep step = cylinder(1e-3, falling);
  ASSERT_EQ(sequence.solve(step).report.status, Status::ok);
  step.motion.motion = ContactMotion::transient;
  step.motion.step = step.grid.dx;
  step.start = StepStart::previous;
  const ContactStepSolution below = sequence.solve(step);
  step.start = StepStart::repeated;
  step.slip_start = SlipStart::above;
  const ContactStepSolution above = sequence.solve(step);
  expect_consistent(step, below);
  expect_consistent(step, above);
  EXPECT_LT(below.slip_elements, above.slip_elements);
  EXPECT_GT(-below.totals.fx, -above.totals.fx * 1.02);
}

/// In the second step of Vollebregt & Schuttelaars's cylinder the zone of slip jumps, so that rounds lead to a solution
/// far away, and no trial before succeeds: it took 162 Newton steps when each went on to its end.
TEST(SlipFriction, TrialsEndSoonWhereTheSlipJumps) {
  ContactStep step = cylinder(-1e-3, FrictionLaw::exponential(0.18, {.drop = 0.12, .half_velocity = 0.1}));
  step.grid = ElementGrid::across_line(4e-3, 82, 5);
  step.gap.clear();
  for (int i = 0; i < step.grid.mx; ++i) step.gap.push_back(step.grid.x(i) * step.grid.x(i) / 0.92);
  step.motion.step = 1e-4;
  ContactSequence sequence;
  ASSERT_EQ(sequence.solve(step).report.status, Status::ok);
  step.motion.motion = ContactMotion::transient;
  step.start = StepStart::previous;
  const ContactStepSolution first = sequence.solve(step), second = sequence.solve(step);
  expect_consistent(step, second);
  EXPECT_LT(second.totals.fx, 0.95 * first.totals.fx);
  EXPECT_LE(second.report.newton_steps, 130);
}

TEST(SlipFriction, OfASteadyStateStaysInSmallSteps) {
  // With a memory that is long against the contact nothing is ambiguous, and steady rolling is where the steps end.
  const FrictionLaw falling = FrictionLaw::exponential(0.18, {.drop = 0.12, .half_velocity = 0.1});
  ContactStep step = cylinder(1e-3, falling);
  step.friction_memory = {.distance = 5e-5, .slowest = 1e-2};
  const ContactStepSolution steady = ContactSequence().solve(step);
  ASSERT_EQ(steady.report.status, Status::ok);
  const ContactStepSolution s = rolled(step, 300);
  ASSERT_EQ(s.report.status, Status::ok);
  EXPECT_NEAR(s.totals.fx, steady.totals.fx, 2e-3 * 0.3 * s.normal_force);
}

/// A softening layer's bound jumps with the slip where friction, which falls, becomes the smaller one: in this shift
/// the equations' solution has an element beyond the bound of its slip by a quarter.
TEST(SlipFriction, TractionsBeyondABoundThatJumpsAreNoSolution) {
  RollingProblem shift;
  shift.geometry = Ellipse{1.8185148172359569e-3, 0.94085105415694361e-3};
  shift.bodies = CombinedMaterial{2.7859012478784542e9, 0.2093928486335272, 0};
  shift.bodies.layer = {
      .flexibility = 1.1067595532225277e-14, .yield_stress = 2.943633156249742e6, .hardening = -2.191691499568523e10};
  shift.load = {NormalLoad::Given::force, 42.377409466468428};
  shift.friction.law = FrictionLaw::rational(0.245831, {.drop = 0.030588, .half_velocity = 2.1e-5});
  shift.motion.kind = ContactMotion::shift;
  shift.motion.creepage = {2.9803306919252192e-5, -1.9287141621198011e-5, 2.4325905120654655e-4};
  const ContactSolution s = Solver({.mx = 24, .my = 13}).solve(shift);
  EXPECT_EQ(s.report.status, Status::not_converged);
  EXPECT_NE(s.report.reason.find("the bound jumps"), std::string::npos) << s.report.reason;
  EXPECT_NEAR(s.report.residual, 0.25, 0.05);
}

} // namespace
} // namespace microslip
