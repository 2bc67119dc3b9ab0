// The moment of the pressure about y: rolling resistance of viscoelastic bodies.

#include "microslip/rolling/solver.hpp"
#include "tests/test_cases.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Frictionless rolling of equal bodies whose deformation grows by `ratio` within `time`; negative speed: along -x.
ContactSolution roll(double ratio, double time, double speed) {
  const Material rubber{1e6, 0.5};
  const auto pair = combine(rubber, rubber);
  const EllipticContact contact{.a = 5e-3,
                                .b = 5e-3,
                                .shear_modulus = pair.shear_modulus,
                                .poisson_ratio = pair.poisson_ratio,
                                .normal_force = 10,
                                .friction = FrictionLaw::coulomb(0),
                                .creepage = {},
                                .rolling_speed = std::abs(speed)};
  RollingProblem problem =
      rolling_problem(contact, {.direction = speed > 0 ? RollingDirection::forward : RollingDirection::backward});
  problem.bodies = viscoelastic(rubber, {ratio, time}, rubber, {ratio, time}, speed);
  return Solver({.mx = 24, .my = 24}).solve(problem);
}

TEST(RollingMoment, ResistsRolling) {
  const auto forward = roll(1, 5e-3, 1), backward = roll(1, 5e-3, -1);
  ASSERT_EQ(forward.report.status, Status::ok);
  EXPECT_LT(forward.totals.my, -1e-3 * 10 * 5e-3); // of Fn a
  EXPECT_NEAR(backward.totals.my, -forward.totals.my, 1e-6 * std::abs(forward.totals.my));
}

/// A body rolled over fast or slowly is elastic: instantaneous and relaxed modulus.
TEST(RollingMoment, VanishesAtBothEndsOfTheSpeed) {
  const double largest = std::abs(roll(1, 5e-3, 1).totals.my);
  EXPECT_LT(std::abs(roll(1, 5e-3, 1e3).totals.my), 0.02 * largest);
  EXPECT_LT(std::abs(roll(1, 5e-3, 1e-3).totals.my), 0.02 * largest);
}

TEST(RollingMoment, IsThatOfTheFields) {
  const auto contact = roll(0.5, 2e-3, 1);
  double moment = 0, force = 0;
  for (std::size_t k = 0; k < contact.fields.pressure.size(); ++k) {
    const double of_cell = contact.fields.pressure[k] * contact.elements.area[k];
    force += of_cell;
    moment += contact.elements.x[k] * of_cell;
  }
  EXPECT_NEAR(force, 10, 1e-6);
  EXPECT_NEAR(contact.totals.my, -moment, 1e-12);
}

TEST(RollingMoment, OfElasticBodiesVanishes) {
  for (const auto discretisation : {Discretisation::second_order, Discretisation::classical}) {
    const auto elliptic = steel_contact(5e-3, 6e-3, 0.4, -0.5, 0.3);
    const auto solved = Solver({.mx = 16, .my = 16, .discretisation = discretisation}).solve(rolling_problem(elliptic));
    EXPECT_LT(std::abs(solved.totals.my), 1e-2 * elliptic.normal_force * elliptic.a);
  }
}

} // namespace
} // namespace microslip
