// Forces to an accuracy: the estimate of the error against limits on much finer grids, and what cannot be done.

#include "microslip/error.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "tests/support/expect_error.hpp"
#include "validation/test_set.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Numbers of the 3,220 cases, from 1: some at random, and those where the estimate comes nearest to the error.
constexpr int numbers[] = {98, 426, 949, 1071, 1501, 1701, 2325, 2445, 2908, 3074};

EllipticContact test_case(int number) {
  return validation::test_set_contacts()[static_cast<std::size_t>(number) - 1];
}

double error_of(const EllipticContact& contact, const ContactForces& f, const ContactForces& exact) {
  const double limit = contact.friction.static_coefficient() * contact.normal_force;
  return std::max({std::abs(f.fx - exact.fx), std::abs(f.fy - exact.fy),
                   std::abs(f.mz - exact.mz) / std::sqrt(contact.a * contact.b)}) /
         limit;
}

TEST(AccurateContact, EstimateIsNotBelowAThirdOfTheError) {
  AccurateContactSolver coarse({.accuracy = 0.03}), good({.accuracy = 0.01}), reference({.accuracy = 2e-3});
  for (const int number : numbers) {
    const EllipticContact contact = test_case(number);
    const ContactForces exact = reference.solve(rolling_problem(contact)).forces;
    for (auto* solver : {&coarse, &good}) {
      const AccurateContact result = solver->solve(rolling_problem(contact));
      const double error = error_of(contact, result.forces, exact);
      EXPECT_EQ(result.forces.status, Status::ok);
      EXPECT_LE(result.error, solver == &coarse ? 0.03 : 0.01);
      EXPECT_GE(result.error, error / 3 - 3e-4) << number; // 3e-4: more than the error of the reference
      EXPECT_GE(result.elements, 16);
    }
  }
}

TEST(AccurateContact, ForcesGivenHaveALimitOfTheCreepage) {
  const EllipticContact contact = test_case(1501);
  AccurateContactSolver solver({.accuracy = 2e-3});
  const ContactForces forces = solver.solve(rolling_problem(contact)).forces;
  const AccurateContact back = solver.solve(rolling_problem(contact, {.force_x = forces.fx, .force_y = forces.fy}));
  EXPECT_EQ(back.forces.status, Status::ok);
  const double size = std::hypot(contact.creepage.longitudinal, contact.creepage.lateral);
  EXPECT_NEAR(back.creepage.longitudinal, contact.creepage.longitudinal, 5e-3 * size);
  EXPECT_NEAR(back.creepage.lateral, contact.creepage.lateral, 5e-3 * size);
}

/// Classical elements, whose errors are of first order, have the limit that those of second order have.
TEST(AccurateContact, ClassicalElementsHaveTheSameLimit) {
  AccurateContactSolver classical({.discretisation = Discretisation::classical, .accuracy = 0.02}),
      second_order({.accuracy = 2e-3});
  for (const int number : {98, 1501, 2445, 3074}) {
    const EllipticContact contact = test_case(number);
    const AccurateContact result = classical.solve(rolling_problem(contact));
    const ContactForces exact = second_order.solve(rolling_problem(contact)).forces;
    EXPECT_EQ(result.forces.status, Status::ok);
    EXPECT_LE(result.error, 0.02);
    EXPECT_LE(error_of(contact, result.forces, exact), result.error) << number;
  }
}

/// Dissimilar bodies, friction that falls with the slip, an interface layer: solved classically.
TEST(AccurateContact, EstimateHoldsOfWhatIsSolvedClassically) {
  EllipticContact unlike = test_case(1501), falling = test_case(2445);
  unlike.dissimilarity = 0.2;
  falling.friction = FrictionLaw::polach(0.3, 0.5, 1);
  RollingProblem layer = rolling_problem(test_case(1501));
  layer.bodies.layer.flexibility = 1e-14;
  for (const RollingProblem& problem : {rolling_problem(unlike), rolling_problem(falling), layer}) {
    const AccurateContact rough = AccurateContactSolver({.accuracy = 0.05}).solve(problem),
                          fine = AccurateContactSolver({.accuracy = 0.01}).solve(problem);
    EXPECT_EQ(fine.forces.status, Status::ok);
    EXPECT_LE(fine.error, 0.01);
    EXPECT_GT(fine.elements, rough.elements);
    EXPECT_LE(error_of(elliptic_contact(problem), rough.forces, fine.forces), rough.error + fine.error);
  }
}

TEST(AccurateContact, ProgressMayEndIt) {
  AccurateContactSolver solver({.accuracy = 1e-5});
  const AccurateContact result = solver.solve(rolling_problem(test_case(2445)), [&](double fraction) {
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    return fraction == 0; // until there is a first limit
  });
  EXPECT_EQ(result.forces.status, Status::not_converged);
  EXPECT_GT(result.error, 1e-5);
}

TEST(AccurateContact, RefusesWhatItCannotDo) {
  expect_error([] { AccurateContactSolver({.accuracy = 0.0}); }, "accuracy", "[-]: must be in [1e-05, 0.1]");
  AccurateContactSolver solver({.accuracy = 0.01});
  EXPECT_THROW(solver.solve(rolling_problem(test_case(1), {.kind = ContactMotion::shift})), Error);
  EXPECT_THROW(solver.solve(rolling_problem(test_case(1), {.step = 1e-3})), Error);
  EllipticContact bad = test_case(1);
  bad.a = -1;
  EXPECT_EQ(solver.solve(rolling_problem(bad)).forces.status, Status::invalid_input);
}

} // namespace
} // namespace microslip
