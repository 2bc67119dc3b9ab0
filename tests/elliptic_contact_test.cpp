#include "microslip/rolling/solver.hpp"

#include "microslip/damage/wear.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/test_cases.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr Discretisation both_discretisations[] = {Discretisation::second_order, Discretisation::classical};
constexpr RollingDirection both_directions[] = {RollingDirection::forward, RollingDirection::backward};

EllipticContact mixed() {
  return steel_contact(9e-3, 6e-3, 0.4, -0.5, 0.3);
}

Method options(int n, std::optional<Discretisation> discretisation = {}) {
  return {.mx = n, .my = n, .discretisation = discretisation, .tolerance = 1e-9};
}

ContactSolution solve(const Method& options, const EllipticContact& contact, const Motion& motion = {}) {
  return Solver(options).solve(rolling_problem(contact, motion));
}

void expect_same(const ContactSolution& one, const ContactSolution& other) {
  EXPECT_EQ(one.fields.traction.x, other.fields.traction.x);
  EXPECT_EQ(one.fields.traction.y, other.fields.traction.y);
  EXPECT_EQ(one.fields.displacement.x, other.fields.displacement.x);
  EXPECT_EQ(one.fields.pressure, other.fields.pressure);
  EXPECT_EQ(one.totals.mz, other.totals.mz);
}

TEST(EllipticContact, SecondOrderIsTheDefault) {
  EXPECT_EQ(discretisation_of(rolling_problem(mixed()), {}), Discretisation::second_order);
  for (const RollingDirection direction : both_directions)
    expect_same(solve(options(9), mixed(), {.direction = direction}),
                solve(options(9, Discretisation::second_order), mixed(), {.direction = direction}));
}

/// Forces, areas, load and power are those of the fields.
TEST(EllipticContact, TotalsAreSumsOverTheFields) {
  for (const Discretisation discretisation : both_discretisations)
    for (const RollingDirection direction : both_directions) {
      const EllipticContact contact = mixed();
      const ContactSolution s = solve(options(14, discretisation), contact, {.direction = direction});
      const ContactSolution& f = s;
      double fx = 0, fy = 0, mz = 0, bound = 0, load = 0, energy = 0, power = 0, slip = 0, adhesion = 0;
      for (std::size_t k = 0; k < f.elements.x.size(); ++k) {
        fx += f.elements.area[k] * f.fields.traction.x[k];
        fy += f.elements.area[k] * f.fields.traction.y[k];
        mz +=
            f.elements.area[k] * (f.elements.x[k] * f.fields.traction.y[k] - f.elements.y[k] * f.fields.traction.x[k]);
        bound += f.elements.area[k] * f.fields.bound[k];
        load += f.elements.area[k] * s.fields.pressure[k];
        energy += f.elements.area[k] *
                  (f.fields.traction.x[k] * s.fields.displacement.x[k] +
                   f.fields.traction.y[k] * s.fields.displacement.y[k]) /
                  2;
        power -= contact.rolling_speed * f.elements.area[k] *
                 (f.fields.traction.x[k] * f.fields.slip.x[k] + f.fields.traction.y[k] * f.fields.slip.y[k]);
        slip += f.fields.state[k] == CellState::slip ? f.elements.area[k] : 0;
        adhesion += f.fields.state[k] == CellState::adhesion ? f.elements.area[k] : 0;
      }
      const double unit = friction_force(contact);
      expect_forces(f.totals, {fx, fy, mz}, 1e-12 * unit, 1e-12 * friction_moment(contact));
      EXPECT_NEAR(bound, unit, 1e-12 * unit);
      EXPECT_NEAR(load, contact.normal_force, 1e-12 * contact.normal_force);
      EXPECT_NEAR(s.totals.elastic_energy, energy, 1e-12 * energy);
      EXPECT_NEAR(f.totals.frictional_power, f.totals.power_by_creepage, 1e-9 * f.totals.power_by_creepage);
      EXPECT_NEAR(power, f.totals.frictional_power, 0.3 * f.totals.frictional_power); // (E23), with few elements
      EXPECT_NEAR(f.totals.slip_area, slip, 1e-12 * slip);
      EXPECT_NEAR(f.totals.adhesion_area, adhesion, 1e-12 * adhesion);
    }
}

/// One order, whatever the direction and the discretisation: x grows along a row, y from row to row.
TEST(EllipticContact, FieldsAscendInXAndY) {
  for (const Discretisation discretisation : both_discretisations)
    for (const RollingDirection direction : both_directions) {
      const ContactSolution f = solve(options(9, discretisation), mixed(), {.direction = direction});
      for (std::size_t k = 0; k < f.elements.size(); ++k) {
        if (k % f.elements.mx() > 0) {
          EXPECT_GT(f.elements.x[k], f.elements.x[k - 1]);
        }
        if (k >= static_cast<std::size_t>(f.elements.mx())) {
          EXPECT_GT(f.elements.y[k], f.elements.y[k - f.elements.mx()]);
        }
      }
    }
}

/// Rolling along -x is the mirror image of rolling along x: xi, phi, Fx and Mz change their signs.
TEST(EllipticContact, RollingBackwardIsTheMirrorImage) {
  for (const Discretisation discretisation : both_discretisations) {
    const ContactSolution forward = solve(options(13, discretisation), mixed());
    EllipticContact mirrored = mixed();
    mirrored.creepage.longitudinal *= -1;
    mirrored.creepage.spin *= -1;
    const ContactSolution s = solve(options(13, discretisation), mirrored, {.direction = RollingDirection::backward});
    const double unit = friction_force(mirrored);
    expect_forces(s.totals, {-forward.totals.fx, forward.totals.fy, -forward.totals.mz}, 1e-8 * unit,
                  1e-8 * friction_moment(mirrored));
    EXPECT_EQ(s.creepage.longitudinal, mirrored.creepage.longitudinal);
    EXPECT_EQ(s.creepage.spin, mirrored.creepage.spin);
    ASSERT_EQ(s.elements.mx(), forward.elements.mx());
    double peak = 0;
    for (const double g : forward.fields.bound) peak = std::max(peak, g);
    for (std::size_t k = 0; k < s.elements.size(); ++k) {
      const std::size_t column = k % s.elements.mx(), image = k + s.elements.mx() - 1 - 2 * column;
      EXPECT_NEAR(s.elements.x[k], -forward.elements.x[image], 1e-15);
      EXPECT_NEAR(s.fields.traction.x[k], -forward.fields.traction.x[image], 1e-5 * peak);
      EXPECT_NEAR(s.fields.traction.y[k], forward.fields.traction.y[image], 1e-5 * peak);
      EXPECT_NEAR(s.fields.displacement.x[k], -forward.fields.displacement.x[image], 1e-10);
    }
  }
}

/// Two discretisations of one problem: extrapolated, each at its order, they agree. The signs of both directions too.
TEST(EllipticContact, BothDiscretisationsHaveTheSameLimit) {
  for (const RollingDirection direction : both_directions)
    for (const double sign : {1.0, -1.0}) {
      const EllipticContact contact = steel_contact(9e-3, 6e-3, 0.4, -0.5, 0.3 * sign);
      const auto limit = [&](Discretisation discretisation, double order) {
        const ContactForces coarse = solve(options(20, discretisation), contact, {.direction = direction}).forces();
        const ContactForces fine = solve(options(40, discretisation), contact, {.direction = direction}).forces();
        const double more = 1 / (std::exp2(order) - 1);
        return ContactForces{fine.fx + more * (fine.fx - coarse.fx), fine.fy + more * (fine.fy - coarse.fy),
                             fine.mz + more * (fine.mz - coarse.mz)};
      };
      const ContactForces second = limit(Discretisation::second_order, 2), first = limit(Discretisation::classical, 1);
      expect_forces(second, first, 3e-3 * friction_force(contact), 3e-3 * friction_moment(contact));
    }
}

/// Shifts, and rolling with a step that is given, are classical all the same.
TEST(EllipticContact, OtherMotionsAreClassical) {
  std::vector<Motion> motions(3);
  motions[0].kind = ContactMotion::shift;
  motions[1].kind = ContactMotion::transient;
  motions[1].steps = 3;
  motions[1].step = 1e-3;
  motions[2].step = 1e-3;
  for (const Motion& motion : motions) {
    EllipticContact contact = mixed();
    if (motion.kind == ContactMotion::shift) contact.creepage = {3e-6, 2e-6, 0};
    expect_same(solve(options(10), contact, motion), solve(options(10, Discretisation::classical), contact, motion));
  }
}

TEST(EllipticContact, TransientRollingKeepsItsSteps) {
  Motion motion;
  motion.kind = ContactMotion::transient;
  motion.steps = 5;
  const ContactSolution s = solve(options(10), mixed(), motion);
  ASSERT_EQ(s.history.size(), 5U);
  EXPECT_EQ(s.history.back().totals.fx, s.totals.fx);
  EXPECT_GT(s.totals.peak_pressure, 0);
  int steps = 0;
  for (const SolutionStep& step : s.history) {
    steps += step.report.newton_steps;
    EXPECT_EQ(step.totals.peak_pressure, s.totals.peak_pressure);
    EXPECT_EQ(step.totals.my, s.totals.my);
  }
  EXPECT_EQ(s.report.newton_steps, steps);
  EXPECT_LT(std::abs(s.history[0].totals.fx), std::abs(s.history[4].totals.fx));
  const ContactSolution ended =
      Solver(options(10)).solve(rolling_problem(mixed(), motion), [&](double fraction) { return fraction < 0.41; });
  EXPECT_EQ(ended.history.size(), 2U);
}

TEST(EllipticContact, ForcesLeadBackToTheCreepages) {
  for (const RollingDirection direction : both_directions) {
    const EllipticContact contact = mixed();
    const ContactSolution given = solve(options(12), contact, {.direction = direction});
    Motion motion{.direction = direction};
    motion.force_x = given.totals.fx;
    motion.force_y = given.totals.fy;
    EllipticContact unknown = contact;
    unknown.creepage.longitudinal = 5;
    unknown.creepage.lateral = -7;
    const ContactSolution s = solve(options(12), unknown, motion);
    const double size = std::hypot(contact.creepage.longitudinal, contact.creepage.lateral);
    EXPECT_EQ(s.report.status, Status::ok);
    EXPECT_NEAR(s.creepage.longitudinal, contact.creepage.longitudinal, 1e-3 * size);
    EXPECT_NEAR(s.creepage.lateral, contact.creepage.lateral, 1e-3 * size);
    EXPECT_NEAR(s.totals.fx, *motion.force_x, 1e-8 * friction_force(contact));
    EXPECT_NEAR(s.totals.fy, *motion.force_y, 1e-8 * friction_force(contact));
  }
}

/// What a solver has done before leaves no trace, whatever it was.
TEST(EllipticContact, SolversCanBeUsedForOneContactAfterTheOther) {
  Solver solver(options(9));
  Motion transient;
  transient.kind = ContactMotion::transient;
  EllipticContact other = steel_contact(5e-3, 7e-3, 0.2, 0.3, -0.4), rubber = mixed();
  rubber.shear_modulus = 1e6;
  rubber.poisson_ratio = 0.5;
  rubber.normal_force = 10;
  for (const EllipticContact& contact : {mixed(), other, mixed(), rubber, mixed()})
    for (const Motion& motion : {Motion{}, transient, Motion{}})
      expect_same(solver.solve(rolling_problem(contact, motion)), solve(options(9), contact, motion));
}

double power_at_centres(const ContactSolution& s) {
  const std::vector<double> work = friction_work(s);
  double power = 0;
  for (std::size_t k = 0; k < work.size(); ++k) power += s.elements.area[k] * work[k];
  return power;
}

/// Frictional power by two formulas: their difference vanishes with the grid.
TEST(EllipticContact, PowersAgreeInTheLimit) {
  const EllipticContact contact = mixed();
  double last = 1;
  for (const int n : {12, 24, 48}) {
    const ContactSolution s = solve(options(n), contact);
    const double difference = std::abs(1 - contact.rolling_speed * power_at_centres(s) / s.totals.frictional_power);
    EXPECT_LT(difference, 0.7 * last) << n;
    last = difference;
  }
  EXPECT_LT(last, 0.1);
}

/// As accurate as the forces where nearly all adheres and hardly any slip shows at the elements' centres.
TEST(EllipticContact, FrictionalPowerNeedsNoFineElements) {
  for (const double size : {0.02, 0.1}) {
    const EllipticContact contact = steel_contact(9e-3, 6e-3, 0.4 * size, -0.5 * size, 0.3 * size);
    const double power = solve(options(60), contact).totals.frictional_power;
    EXPECT_NEAR(solve(options(15), contact).totals.frictional_power, power, 0.04 * power) << size;
  }
}

TEST(EllipticContact, ApproachIsHertz) {
  const EllipticContact contact = mixed();
  const double hertz = hertz_from_ellipse(contact.a, contact.b, steel, contact.normal_force).approach;
  EXPECT_NEAR(solve(options(10), contact).approach, hertz, 1e-14 * hertz);
  EXPECT_NEAR(solve(options(30, Discretisation::classical), contact).approach, hertz, 1e-3 * hertz);
}

/// Zero where the bodies touch, positive around.
TEST(EllipticContact, DeformedGap) {
  for (const Discretisation discretisation : both_discretisations) {
    Solver solver(options(12, discretisation));
    const EllipticContact contact = mixed();
    const std::vector<double> gap = solver.deformed_gap(rolling_problem(contact)).gap;
    const ContactSolution s = solve(options(12, discretisation), contact);
    ASSERT_EQ(gap.size(), s.fields.pressure.size());
    for (std::size_t k = 0; k < gap.size(); ++k) {
      const double x = s.elements.x[k] / contact.a, y = s.elements.y[k] / contact.b;
      if (x * x + y * y < 0.8) {
        EXPECT_NEAR(gap[k], 0, 1e-6 * s.approach);
      }
      if (x * x + y * y > 1.3) {
        EXPECT_GT(gap[k], 1e-3 * s.approach);
      }
    }
  }
}

TEST(EllipticContact, InputOutOfRangeIsAStatus) {
  constexpr double bad[] = {0, -1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
  for (const Discretisation discretisation : both_discretisations) {
    Solver solver(options(6, discretisation));
    const auto expect_invalid = [&](const EllipticContact& contact, const Motion& motion = {}) {
      const ContactSolution s = solver.solve(rolling_problem(contact, motion));
      EXPECT_EQ(s.report.status, Status::invalid_input);
      EXPECT_TRUE(std::isnan(s.totals.fx));
    };
    for (const auto member : {&EllipticContact::a, &EllipticContact::b, &EllipticContact::shear_modulus,
                              &EllipticContact::normal_force, &EllipticContact::rolling_speed})
      for (const double value : bad) {
        EllipticContact contact = mixed();
        contact.*member = value;
        expect_invalid(contact);
      }
    for (const double value : {-0.1, 0.51, bad[2]}) {
      EllipticContact contact = mixed();
      contact.poisson_ratio = value;
      expect_invalid(contact);
    }
    for (const double value : {bad[2], bad[3]}) {
      EllipticContact contact = mixed();
      contact.creepage.spin = value;
      expect_invalid(contact);
      Motion motion;
      motion.force_x = value;
      expect_invalid(mixed(), motion);
    }
    EXPECT_EQ(solver.solve(rolling_problem(mixed())).report.status, Status::ok);
  }
}

/// Of a K that rounding of the constants makes, the solution is that of similar bodies, at second order.
TEST(EllipticContact, RoundingOfTheDissimilarityDoesNotCouple) {
  EllipticContact rounded = mixed();
  rounded.dissimilarity = 1e-9;
  expect_same(solve(options(8), rounded), solve(options(8), mixed()));
  EXPECT_EQ(Solver(options(8)).differentiate(rolling_problem(rounded)).solution.report.status, Status::ok);
}

/// The gap is that of a solution, so it is refused where the solution is; so are derivatives.
TEST(EllipticContact, IsRefusedForGapAndDerivativesAsForTheSolution) {
  RollingProblem problem = rolling_problem(mixed());
  problem.bodies = viscoelastic({1e6, 0.5}, {1, 0.01}, {1e6, 0.5}, {1, 0.01}, 1);
  Solver solver(options(6, Discretisation::classical));
  EXPECT_EQ(solver.differentiate(problem).solution.report.status, Status::ok);
  problem.motion.kind = ContactMotion::transient;
  EXPECT_THROW(solver.solve(problem), Error);
  EXPECT_THROW(solver.deformed_gap(problem), Error);
  EXPECT_THROW(solver.differentiate(problem), Error);
  for (const Motion& motion : {Motion{.kind = ContactMotion::shift}, Motion{.force_x = 1e3}})
    EXPECT_EQ(solver.differentiate(rolling_problem(mixed(), motion)).solution.report.status, Status::invalid_input);
  const Motion in_steps{.step = 1e-3}; // as long as the contact: of the classical discretisation
  EXPECT_EQ(solver.differentiate(rolling_problem(mixed(), in_steps)).solution.report.status, Status::ok);
}

TEST(EllipticContact, RefusesOptionsOutOfRange) {
  expect_error([] { Solver({.mx = 0}); }, "mx", "[-]: must be in [1, 4000]");
  expect_error([] { Solver({.my = 4001}); }, "my", "[-]: must be in [1, 4000]");
  expect_error([] { Solver({.tolerance = 0}); }, "tolerance", "[-]: must be in [1e-14, 0.1]");
}

} // namespace
} // namespace microslip
