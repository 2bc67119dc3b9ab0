// Friction laws of one's own, as tables of mu(v), in every solver that takes friction falling with the slip.

#include "microslip/batch/solve_parallel.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/steel.hpp"
#include "tests/test_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace microslip {
namespace {

constexpr double speed = 20;
const FrictionLaw exponential = FrictionLaw::exponential(0.2, {.drop = 0.15, .half_velocity = 0.03});

FrictionLaw table_of(const FrictionLaw& law, double accuracy) {
  return FrictionLaw::table(FrictionTable::sampled([&](double v) { return law.coefficient(v); }, 40, accuracy));
}

/// Rises from rest to a peak and falls then.
FrictionLaw rising(double at_rest) {
  return FrictionLaw::table({{0, 0.01, 0.02, 0.05, 0.2, 1}, {at_rest, 0.3, 0.35, 0.33, 0.25, 0.2}});
}

EllipticContact contact_with(const FrictionLaw& law, const Creepage& creepage = {0.002, 0.001, 0.2}) {
  EllipticContact contact = steel_contact(6e-3, 4e-3, 80e3, creepage);
  contact.friction = law;
  contact.rolling_speed = speed;
  return contact;
}

Method exact() {
  Method method{.theory = Theory::exact};
  method.mx = method.my = 12;
  method.tolerance = 1e-9;
  return method;
}

ContactSolution solve_exactly(const EllipticContact& contact, const Motion& motion = {}) {
  return Solver(exact()).solve(rolling_problem(contact, motion));
}

/// Forces of a contact by every row solver and the exact theory, steady and transient.
std::vector<std::function<PlaneForces(const EllipticContact&)>> all_theories() {
  std::vector<std::function<PlaneForces(const EllipticContact&)>> all;
  for (const RowSolver& solver : all_solvers(8, 8))
    all.emplace_back([solver](const EllipticContact& c) { return PlaneForces(RowSolver(solver).solve(c)); });
  all.emplace_back([](const EllipticContact& c) { return PlaneForces(solve_exactly(c).totals); });
  all.emplace_back([](const EllipticContact& c) {
    Motion motion{.kind = ContactMotion::transient};
    motion.steps = 3;
    return PlaneForces(solve_exactly(c, motion).totals);
  });
  return all;
}

TEST(OwnFrictionLaw, ATableOfALawGivesItsForcesToTheAccuracyOfTheTable) {
  const FrictionLaw linear = FrictionLaw::linear(0.2, {.drop = 0.15, .half_velocity = 0.05});
  for (const auto& solve : all_theories())
    for (const FrictionLaw& law : {exponential, linear})
      for (const double accuracy : {1e-4, 1e-7}) {
        const EllipticContact contact = contact_with(law);
        const PlaneForces wanted = solve(contact), found = solve(contact_with(table_of(law, accuracy)));
        const double force = 3 * accuracy * contact.normal_force + 1e-8 * contact.normal_force;
        expect_forces(found, wanted, force, force * contact.a);
      }
}

TEST(OwnFrictionLaw, AConstantTableIsCoulombs) {
  const FrictionLaw constant = FrictionLaw::table({{0, 0.1, 5}, {0.3, 0.3, 0.3}});
  Method classical = exact();
  classical.discretisation = Discretisation::classical;
  for (RowSolver& solver : all_solvers(8, 8)) {
    const EllipticContact contact = contact_with(FrictionLaw::coulomb(0.3));
    const double force = 1e-12 * contact.normal_force;
    expect_forces(solver.solve(contact_with(constant)), solver.solve(contact), force, force * contact.a);
  }
  classical.tolerance = 1e-12;
  const EllipticContact contact = contact_with(FrictionLaw::coulomb(0.3));
  const double force = 1e-11 * contact.normal_force;
  expect_forces(Solver(classical).solve(rolling_problem(contact_with(constant))).totals,
                Solver(classical).solve(rolling_problem(contact)).totals, force, force * contact.a);
}

TEST(OwnFrictionLaw, FullSlidingHasTheCoefficientOfItsVelocity) {
  const Creepage sliding = {0.03, 0.02, 0};
  for (const auto& solve : all_theories())
    for (const FrictionLaw& law : {rising(0.1), rising(0), table_of(exponential, 1e-6)}) {
      const EllipticContact contact = contact_with(law, sliding);
      const PlaneForces f = solve(contact);
      EXPECT_NEAR(std::hypot(f.fx, f.fy), law.coefficient(std::hypot(0.03, 0.02) * speed) * contact.normal_force,
                  2e-3 * contact.normal_force); // deformation adds to the rigid slip
    }
}

TEST(OwnFrictionLaw, AMirroredMotionHasMirroredForces) {
  for (const auto& solve : all_theories()) {
    const EllipticContact contact = contact_with(rising(0.1)),
                          mirrored = contact_with(rising(0.1), {0.002, -0.001, -0.2});
    const PlaneForces f = solve(contact), m = solve(mirrored);
    const double force = 1e-7 * contact.normal_force;
    expect_forces(m, {f.fx, -f.fy, -f.mz}, force, force * contact.a);
  }
}

TEST(OwnFrictionLaw, DerivativesAreThoseOfTheForces) {
  const double h = 1e-7;
  for (RowSolver& solver : all_solvers(8, 8)) {
    const EllipticContact contact = contact_with(rising(0.1), {0.004, 0.003, 0.3});
    const ContactDerivatives found = solver.differentiate(contact);
    EllipticContact more = contact, less = contact;
    more.creepage.longitudinal += h, less.creepage.longitudinal -= h;
    const double slope = (solver.solve(more).fx - solver.solve(less).fx) / (2 * h);
    EXPECT_NEAR(found.jacobian[0][0], slope, 1e-4 * contact.normal_force / 0.004);
  }
}

TEST(OwnFrictionLaw, ForcesAbovePartOfTheTableAreReached) {
  const EllipticContact contact = contact_with(rising(0.1), {0, 0, 0});
  Motion motion;
  motion.force_x = -0.25 * contact.normal_force; // mu is 0.1 at rest and 0.35 at most
  const ContactSolution found = solve_exactly(contact, motion);
  EXPECT_EQ(found.report.status, Status::ok) << found.report.reason;
  EXPECT_NEAR(found.totals.fx, *motion.force_x, 1e-4 * contact.normal_force);
}

TEST(OwnFrictionLaw, ThreadsShareATable) {
  const FrictionLaw law = rising(0.1);
  std::vector<EllipticContact> contacts;
  for (int k = 0; k < 600; ++k) contacts.push_back(contact_with(law, {1e-5 * k, 5e-6 * k, 0.1}));
  std::vector<ContactForces> one(contacts.size()), two(contacts.size());
  const Fastsim2 solver(SimplifiedOptions{.mx = 6, .my = 6});
  solve_parallel(solver, contacts, one, 1);
  solve_parallel(solver, contacts, two, 2);
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(one[k].fx, two[k].fx);
}

TEST(OwnFrictionLaw, TheBoundIsTheCoefficientAtTheElementsPressure) {
  const FrictionLaw law = FrictionLaw::table(FrictionTable(
      FrictionGrid{{0, 0.05, 0.5}, {2e8, 8e8, 2e9}, {}, {0.5, 0.45, 0.4, 0.4, 0.35, 0.3, 0.25, 0.22, 0.2}}));
  const ContactSolution found = solve_exactly(contact_with(law));
  ASSERT_EQ(found.report.status, Status::ok);
  int slipping = 0;
  for (std::size_t k = 0; k < found.elements.size(); ++k) {
    const double p = found.fields.pressure[k];
    if (!(p > 0)) continue;
    const bool slips = found.fields.state[k] == CellState::slip;
    const double v = slips ? speed * std::hypot(found.fields.slip.x[k], found.fields.slip.y[k]) : 0;
    EXPECT_NEAR(found.fields.bound[k], law.coefficient(v, p, 0.0) * p, 1e-9 * p);
    const double traction = std::hypot(found.fields.traction.x[k], found.fields.traction.y[k]);
    if (slips)
      EXPECT_NEAR(traction, found.fields.bound[k], 1e-6 * p);
    else
      EXPECT_LE(traction, found.fields.bound[k] * (1 + 1e-6));
    slipping += slips;
  }
  EXPECT_GT(slipping, 20);
}

TEST(OwnFrictionLaw, ATableOfTemperaturesIsTheTemperaturesEffect) {
  const TemperatureEffect effect = {.change = -0.2, .begin = 50, .range = 300};
  const ThermalBody body = {20, 50, 7850, 450};
  RollingProblem wanted = rolling_problem(contact_with(FrictionLaw::coulomb(0.35), {0.01, 0.004, 0.2}));
  wanted.thermal = {body, body};
  RollingProblem own = wanted;
  wanted.friction.temperature_effect = effect;
  own.friction.law = FrictionLaw::table(
      FrictionTable(FrictionGrid{{0, 1}, {}, {-100, 50, 350, 900}, {0.35, 0.35, 0.35, 0.35, 0.15, 0.15, 0.15, 0.15}}));
  for (const double distance : {0.0, 1e-5}) {
    wanted.friction.memory.distance = own.friction.memory.distance = distance;
    const ContactSolution one = Solver(exact()).solve(wanted), other = Solver(exact()).solve(own);
    EXPECT_EQ(other.report.status, Status::ok);
    EXPECT_LT(std::abs(one.totals.fx), 0.33 * 80e3); // heat has an effect
    expect_forces(other.totals, one.totals, 1e-6 * 80e3, 1e-6 * 80e3 * 6e-3);
  }
}

TEST(OwnFrictionLaw, WhatKnowsNoPressureRefusesATableOfPressures) {
  const FrictionLaw law = FrictionLaw::table(FrictionTable(FrictionGrid{{0, 1}, {0, 1e9}, {}, {0.4, 0.3, 0.3, 0.2}}));
  const FrictionLaw hot = FrictionLaw::table(FrictionTable(FrictionGrid{{0, 1}, {}, {20, 300}, {0.4, 0.3, 0.3, 0.2}}));
  EXPECT_EQ(Fastsim2(SimplifiedOptions{}).solve(contact_with(law)).status, Status::invalid_input);
  const auto refusal = [](const FrictionLaw& one, const Method& method) {
    const auto found = incompatibilities(rolling_problem(contact_with(one)), method);
    return found.empty() ? "" : found.front().message();
  };
  EXPECT_EQ(refusal(law, exact()), "");
  EXPECT_NE(refusal(law, {.theory = Theory::fastsim2}).find("friction.table: of pressures or temperatures needs"),
            std::string::npos);
  EXPECT_NE(refusal(hot, exact()).find("friction.table: of temperatures needs the thermal data of both bodies"),
            std::string::npos);
}

} // namespace
} // namespace microslip
