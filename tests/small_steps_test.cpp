// A step that changes less than the tolerance of the whole is solved to its scale: nothing is lost step by step.

#include "tangential_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace microslip {
namespace {

/// A sphere on a plane, nu = 0: F = mu Fn (1 - (1 - d/d0)^(3/2)) for the shift d (Johnson 1985, section 7.2).
struct Sphere {
  EllipticContact contact = steel_contact(1);
  Problem problem;
  double whole; ///< d0: shift of full sliding [m]

  explicit Sphere(int n) {
    contact.poisson_ratio = 0;
    problem = elliptic(contact, n, n);
    whole = 3 * problem.capacity * 2 / (8 * contact.a * contact.shear_modulus);
  }
};

TangentialInput shift_by(double distance, double tolerance) {
  TangentialInput input;
  input.motion = ContactMotion::shift;
  input.creepage.longitudinal = distance;
  input.tolerance = tolerance;
  return input;
}

/// The state after `steps` equal steps from `state`, each begun from zero tractions or from the last state.
ContactSolution after_steps(TangentialProblem& problem, const Problem& p, TangentialInput input, VectorField state,
                            int steps) {
  ContactSolution s;
  for (int k = 0; k < steps; ++k) {
    input.previous = &state;
    s = problem.solve(p.bound, input);
    EXPECT_EQ(s.report.status, Status::ok);
    state = s.fields.traction;
  }
  return s;
}

/// Each step moves tractions by 0.001 of the bound or less, a third of the tolerance.
TEST(SmallSteps, AThousandShiftsAreAWholeOne) {
  const Sphere sphere(15);
  const Problem& p = sphere.problem;
  TangentialProblem problem(p.material, p.grid);
  const double distance = 0.75 * sphere.whole;
  const ContactSolution s = after_steps(problem, p, shift_by(distance / 1000, 3e-3), {}, 1000);
  const ContactSolution whole = problem.solve(p.bound, shift_by(distance, 1e-10));
  EXPECT_NEAR(s.totals.fx, whole.totals.fx, 1e-3 * p.capacity);
  EXPECT_NEAR(-s.totals.fx / p.capacity, 1 - std::pow(0.25, 1.5), 3e-3);
}

/// Steps of 1e-9 of the distance at the default tolerance of 1e-6; the slope dF/dd = 3/2 mu Fn/d0 (1 - d/d0)^(1/2).
TEST(SmallSteps, TinyShiftsFollowMindlinsStiffness) {
  const Sphere sphere(15);
  const Problem& p = sphere.problem;
  TangentialProblem problem(p.material, p.grid);
  const double distance = 0.5 * sphere.whole, tiny = 1e-9 * sphere.whole;
  const ContactSolution first = problem.solve(p.bound, shift_by(distance, 1e-12));
  const int steps = 1000;
  const ContactSolution s = after_steps(problem, p, shift_by(tiny, 1e-6), first.fields.traction, steps);
  TangentialInput at_once = shift_by(steps * tiny, 1e-10);
  at_once.previous = &first.fields.traction;
  const double growth = first.totals.fx - s.totals.fx;
  EXPECT_NEAR(growth, first.totals.fx - problem.solve(p.bound, at_once).totals.fx, 0.01 * growth);
  const double stiffness = 1.5 * p.capacity / sphere.whole * std::sqrt(0.5);
  EXPECT_NEAR(growth / (steps * tiny), stiffness, 0.05 * stiffness);
}

/// The same with the force given: the shift is found.
TEST(SmallSteps, TinyForces) {
  const Sphere sphere(13);
  const Problem& p = sphere.problem;
  TangentialProblem problem(p.material, p.grid);
  TangentialInput input = shift_by(0, 1e-6);
  input.force_x = -0.5 * p.capacity;
  VectorField state = problem.solve(p.bound, input).fields.traction;
  double moved = 0;
  const int steps = 300;
  for (int k = 0; k < steps; ++k) {
    input.previous = &state;
    *input.force_x -= 1e-8 * p.capacity;
    const ContactSolution s = problem.solve(p.bound, input);
    ASSERT_EQ(s.report.status, Status::ok);
    moved += s.creepage.longitudinal;
    state = s.fields.traction;
  }
  const double compliance = sphere.whole / (1.5 * p.capacity * std::cbrt(0.5));
  EXPECT_NEAR(moved / (steps * 1e-8 * p.capacity), compliance, 0.06 * compliance);
}

/// Rolling by a thousandth of an element at a time.
TEST(SmallSteps, RollingDoesNotDependOnTheTolerance) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 11, 11);
  TangentialProblem problem(p.material, p.grid);
  TangentialInput input;
  input.motion = ContactMotion::transient;
  input.step = 1e-3 * p.grid.dx;
  input.creepage = scaled_creepage(contact, 0.5, 0.3, 0.4);
  input.tolerance = 1e-10;
  const ContactSolution fine = after_steps(problem, p, input, {}, 300);
  input.tolerance = 1e-3;
  const ContactSolution rough = after_steps(problem, p, input, {}, 300);
  const double size = std::hypot(fine.totals.fx, fine.totals.fy);
  EXPECT_LT(size, 0.1 * p.capacity);
  EXPECT_NEAR(rough.totals.fx, fine.totals.fx, 2e-3 * size);
  EXPECT_NEAR(rough.totals.fy, fine.totals.fy, 2e-3 * size);
}

/// A step without motion changes nothing, but for what rounding does.
TEST(SmallSteps, AtRest) {
  const Sphere sphere(11);
  const Problem& p = sphere.problem;
  TangentialProblem problem(p.material, p.grid);
  const ContactSolution first = problem.solve(p.bound, shift_by(0.5 * sphere.whole, 1e-6));
  const ContactSolution s = after_steps(problem, p, shift_by(0, 1e-6), first.fields.traction, 20);
  EXPECT_NEAR(s.totals.fx, first.totals.fx, 1e-6 * p.capacity);
}

} // namespace
} // namespace microslip
