// What the simplified theory does with extreme contacts, and with those that make no sense.

#include "microslip/batch/solve_parallel.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/simplified/fastsim.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"
#include "tests/test_cases.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

bool all_finite(const ContactForces& f) {
  return std::isfinite(f.fx) && std::isfinite(f.fy) && std::isfinite(f.mz) && std::isfinite(f.adhesion_area) &&
         std::isfinite(f.slip_area);
}
bool all_nan(const ContactForces& f) {
  return std::isnan(f.fx) && std::isnan(f.fy) && std::isnan(f.mz) && std::isnan(f.adhesion_area) &&
         std::isnan(f.slip_area);
}
bool all_finite(const ContactDerivatives& d) {
  bool finite = all_finite(d.forces);
  for (const auto& row : d.jacobian)
    for (const double slope : row) finite = finite && std::isfinite(slope);
  return finite;
}
bool all_nan(const ContactDerivatives& d) {
  bool nans = all_nan(d.forces);
  for (const auto& row : d.jacobian)
    for (const double slope : row) nans = nans && std::isnan(slope);
  return nans;
}

/// A contact with creepages that leave it partly in adhesion.
EllipticContact good_contact() {
  return test_cases()[600];
}

TEST(ContactInput, WithoutCreepageThereIsExactlyNoForce) {
  for (RowSolver& solver : all_solvers(6, 5))
    for (EllipticContact contact : every_nth_case(644)) {
      contact.creepage = {};
      const ContactForces f = solver.solve(contact);
      EXPECT_EQ(f.fx, 0);
      EXPECT_EQ(f.fy, 0);
      EXPECT_EQ(f.mz, 0);
      EXPECT_EQ(f.slip_area, 0);
      EXPECT_EQ(f.status, Status::ok);
    }
}

TEST(ContactInput, WithoutFrictionThereIsExactlyNoForce) {
  for (RowSolver& solver : all_solvers(6, 5)) {
    SCOPED_TRACE(describe(solver));
    for (EllipticContact contact : every_nth_case(53)) {
      contact.friction = FrictionLaw();
      const ContactDerivatives d = solver.differentiate(contact);
      EXPECT_EQ(d.forces.fx, 0);
      EXPECT_EQ(d.forces.fy, 0);
      EXPECT_EQ(d.forces.mz, 0);
      EXPECT_EQ(d.forces.status, Status::ok);
      EXPECT_TRUE(all_finite(d)) << contact.creepage.longitudinal << " " << contact.creepage.lateral << " "
                                 << contact.creepage.spin;
      for (const double p : solver.fields(contact).fields.traction.x) EXPECT_EQ(p, 0);
    }
  }
}

/// Tiny creepages give tiny forces, huge ones mu Fn, nothing is lost between.
TEST(ContactInput, CreepagesOfAnySize) {
  for (RowSolver& solver : all_solvers(6, 5)) {
    SCOPED_TRACE(describe(solver));
    EllipticContact contact = good_contact();
    contact.creepage = {1e-12, 0, 0};
    const ContactDerivatives tiny = solver.differentiate(contact);
    EXPECT_NEAR(tiny.forces.fx, tiny.jacobian[0][0] * 1e-12, 1e-12 * std::abs(tiny.forces.fx));
    EXPECT_LT(tiny.forces.fx, 0);
    EXPECT_EQ(tiny.forces.slip_area, 0);
    contact.creepage = {1e3, -1e3, 0};
    const ContactDerivatives huge = solver.differentiate(contact);
    EXPECT_NEAR(std::hypot(huge.forces.fx, huge.forces.fy), friction_force(contact), 1e-14 * friction_force(contact));
    EXPECT_TRUE(all_finite(huge));
    contact.creepage = {0, 0, 1e3};
    EXPECT_TRUE(all_finite(solver.differentiate(contact)));
  }
}

TEST(ContactInput, EllipsesOfAnyShape) {
  for (RowSolver& solver : all_solvers(6, 5)) {
    SCOPED_TRACE(describe(solver));
    for (const auto& [a, b] : {std::pair{1e-8, 1e-2}, std::pair{1e-2, 1e-8}}) {
      EllipticContact contact = good_contact();
      contact.a = a;
      contact.b = b;
      const Creepage unit = saturating_creepage(contact);
      for (const double share : {0.1, 1.0, 10.0}) {
        contact.creepage = {share * unit.longitudinal, -share * unit.lateral, share * unit.spin};
        const ContactDerivatives d = solver.differentiate(contact);
        EXPECT_EQ(d.forces.status, Status::ok);
        EXPECT_TRUE(all_finite(d));
        EXPECT_GT(std::hypot(d.forces.fx, d.forces.fy), 0.01 * friction_force(contact));
        EXPECT_LE(std::hypot(d.forces.fx, d.forces.fy), (1 + 1e-14) * friction_force(contact));
      }
    }
  }
}

TEST(ContactInput, GridsOfAnySize) {
  EllipticContact contact = good_contact();
  Fastsim2 fine({.mx = 100, .my = 100});
  const double force = friction_force(contact), expected = fine.solve(contact).fy;
  for (const auto scheme : all_schemes)
    for (const auto& [mx, my] : {std::pair{1, 1}, std::pair{1, 10000}, std::pair{10000, 1}}) {
      RowSolver solver(scheme, {.mx = mx, .my = my});
      const ContactDerivatives d = solver.differentiate(contact);
      EXPECT_EQ(d.forces.status, Status::ok);
      EXPECT_TRUE(all_finite(d));
      EXPECT_NEAR(d.forces.fy, expected, 0.5 * force);
      EXPECT_EQ(solver.fields(contact).fields.traction.x.size(), static_cast<std::size_t>(mx) * my);
    }
}

/// All contacts that differ from a good one by a single senseless number.
std::vector<EllipticContact> senseless_contacts() {
  std::vector<EllipticContact> contacts;
  const auto spoil = [&](auto field, std::initializer_list<double> values) {
    for (const double value : values) {
      contacts.push_back(good_contact());
      field(contacts.back()) = value;
    }
  };
  const auto not_positive = {0.0, -0.0, -1.0, infinity, -infinity, nan};
  spoil([](EllipticContact& c) -> double& { return c.a; }, not_positive);
  spoil([](EllipticContact& c) -> double& { return c.b; }, not_positive);
  spoil([](EllipticContact& c) -> double& { return c.shear_modulus; }, not_positive);
  spoil([](EllipticContact& c) -> double& { return c.normal_force; }, not_positive);
  spoil([](EllipticContact& c) -> double& { return c.rolling_speed; }, not_positive);
  spoil([](EllipticContact& c) -> double& { return c.poisson_ratio; }, {-0.01, 0.51, infinity, -infinity, nan});
  spoil([](EllipticContact& c) -> double& { return c.creepage.longitudinal; }, {infinity, -infinity, nan});
  spoil([](EllipticContact& c) -> double& { return c.creepage.lateral; }, {infinity, -infinity, nan});
  spoil([](EllipticContact& c) -> double& { return c.creepage.spin; }, {infinity, -infinity, nan});
  return contacts;
}

TEST(ContactInput, WhatMakesNoSenseIsMarkedAndGivesNoNumbers) {
  for (RowSolver& solver : all_solvers(4, 3))
    for (const EllipticContact& contact : senseless_contacts()) {
      const ContactForces f = solver.solve(contact);
      EXPECT_EQ(f.status, Status::invalid_input);
      EXPECT_TRUE(all_nan(f));
      const ContactDerivatives d = solver.differentiate(contact);
      EXPECT_EQ(d.forces.status, Status::invalid_input);
      EXPECT_TRUE(all_nan(d));
      const ContactSolution fields = solver.fields(contact);
      EXPECT_EQ(fields.report.status, Status::invalid_input);
      EXPECT_TRUE(all_nan(fields.forces()));
      EXPECT_TRUE(std::isnan(fields.totals.frictional_power));
      EXPECT_TRUE(fields.fields.traction.x.empty());
    }
}

/// What a hot call marks is what `check` refuses, field by field, in both theories.
TEST(ContactInput, IsInvalidWhereItIsRefused) {
  using Check = void (*)(const EllipticContact&);
  const auto is_refused = [](Check refuse, const EllipticContact& contact) {
    try {
      refuse(contact);
      return false;
    } catch (const Error&) {
      return true;
    }
  };
  std::vector<EllipticContact> contacts = senseless_contacts();
  for (const double k : {-0.51, 0.51, infinity, nan}) {
    contacts.push_back(good_contact());
    contacts.back().dissimilarity = k;
  }
  for (const EllipticContact& contact : contacts) {
    EXPECT_FALSE(is_valid(contact));
    EXPECT_FALSE(is_valid_simplified(contact));
    EXPECT_TRUE(is_refused(check, contact));
    EXPECT_TRUE(is_refused(check_simplified, contact));
  }
  EllipticContact good = good_contact();
  EXPECT_TRUE(is_valid_simplified(good));
  EXPECT_FALSE(is_refused(check_simplified, good));
  for (const double k : {-0.5, 1e-300, 0.5}) { // for the exact theory alone
    good.dissimilarity = k;
    EXPECT_TRUE(is_valid(good));
    EXPECT_FALSE(is_refused(check, good));
    EXPECT_FALSE(is_valid_simplified(good));
    EXPECT_TRUE(is_refused(check_simplified, good));
  }
}

/// Numbers whose elements would have no places: an element's length that underflows, coordinates that overflow.
TEST(ContactInput, SizesThatNoElementHasAreInvalid) {
  Solver solver({.mx = 5, .my = 4});
  for (const double size : {5e-324, 1.7e308})
    for (double EllipticContact::*member : {&EllipticContact::a, &EllipticContact::b}) {
      EllipticContact contact = good_contact();
      contact.*member = size;
      EXPECT_EQ(solver.solve(rolling_problem(contact)).report.status, Status::invalid_input);
      EXPECT_EQ(Fastsim2({.mx = 5, .my = 4}).solve(contact).status, Status::invalid_input);
    }
}

TEST(ContactInput, EndsOfTheRangesAreValid) {
  Fastsim2 solver;
  for (const double nu : {0.0, 0.5}) {
    EllipticContact contact = good_contact();
    contact.poisson_ratio = nu;
    EXPECT_EQ(solver.solve(contact).status, Status::ok);
  }
}

/// Good contacts between bad ones, which share vectors and blocks with them.
TEST(ContactInput, NeighboursInABatchAreNotDisturbed) {
  const auto good = every_nth_case(97);
  const auto bad = senseless_contacts();
  for (const auto scheme : all_schemes)
    for (const int my : {1, 3, 10}) {
      RowSolver solver(scheme, {.mx = 5, .my = my});
      std::vector<EllipticContact> mixed;
      for (std::size_t k = 0; k < bad.size(); ++k) {
        mixed.push_back(good[k % good.size()]);
        if (k % 3 == 0) mixed.push_back(good[(k + 1) % good.size()]);
        mixed.push_back(bad[k]);
      }
      std::vector<ContactForces> forces(mixed.size());
      std::vector<ContactDerivatives> derivatives(mixed.size());
      solver.solve(mixed, forces);
      solver.differentiate(mixed, derivatives);
      for (std::size_t k = 0; k < mixed.size(); ++k) {
        const ContactForces alone = solver.solve(mixed[k]);
        EXPECT_EQ(forces[k].status, alone.status);
        EXPECT_EQ(derivatives[k].forces.status, alone.status);
        if (alone.status != Status::ok) continue;
        EXPECT_EQ(forces[k].fx, alone.fx);
        EXPECT_EQ(forces[k].mz, alone.mz);
        EXPECT_EQ(derivatives[k].forces.fy, alone.fy);
        EXPECT_TRUE(all_finite(derivatives[k]));
      }
    }
}

/// Any numbers up to 1e300: either all forces are finite, or they are marked and none is. The derivatives, in whose
/// course larger numbers come up, as long as no input is beyond 1e30.
TEST(ContactInput, NumbersAreFiniteOrMarked) {
  RandomContacts random(41);
  int marked = 0, unmarked = 0;
  for (int n = 0; n < 3000; ++n) {
    const double reach = std::pow(10, random.about(1, 300));
    EllipticContact contact;
    contact.a = random.about(1 / reach, reach);
    contact.b = random.about(1 / reach, reach);
    contact.shear_modulus = random.about(1 / reach, reach);
    contact.normal_force = random.about(1 / reach, reach);
    contact.rolling_speed = random.about(1 / reach, reach);
    contact.poisson_ratio = random.between(0, 0.5);
    contact.creepage = {random.signed_about(1 / reach, reach), random.signed_about(1 / reach, reach),
                        random.signed_about(1 / reach, reach)};
    contact.friction = n % 3 == 0 ? FrictionLaw::linear(0.1, {.drop = 0.2, .half_velocity = 1})
                                  : FrictionLaw::coulomb(random.between(0, 1));
    for (const auto scheme : all_schemes)
      for (const auto model : all_flexibility_models) {
        RowSolver solver(scheme, {.mx = 3, .my = 2, .flexibility = model});
        const ContactForces f = solver.solve(contact);
        EXPECT_TRUE(f.status == Status::ok ? all_finite(f) : all_nan(f));
        const ContactDerivatives d = solver.differentiate(contact);
        EXPECT_EQ(d.forces.status, f.status);
        if (f.status != Status::ok) {
          EXPECT_TRUE(all_nan(d));
        } else if (reach < 1e30) {
          EXPECT_TRUE(all_finite(d));
        }
        ++(f.status == Status::ok ? unmarked : marked);
      }
  }
  EXPECT_GT(marked, 1000);
  EXPECT_GT(unmarked, 1000);
}

TEST(SimplifiedOptions, OutOfRangeAreRefused) {
  const auto make = [](const SimplifiedOptions& options) { return [=] { Fastsim2 solver(options); }; };
  for (const int bad : {0, -1, 10001, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
    expect_error(make({.mx = bad}), "mx", "must be in [1, 10000]");
    expect_error(make({.my = bad}), "my", "must be in [1, 10000]");
  }
  for (const double bad : {-0.1, 1.1, infinity, nan}) {
    expect_error(make({.slope_reduction = {.initial = bad}}), "slope_reduction.initial", "[-]: must be in");
    expect_error(make({.slope_reduction = {.at_infinity = bad}}), "slope_reduction.at_infinity", "[-]: must be in");
  }
  for (const double bad : {-0.1, infinity, nan})
    expect_error(make({.slope_reduction = {.decay = bad}}), "slope_reduction.decay", "[-]: must be in");
  expect_error(make({.slope_reduction = {.initial = 0}}), "slope_reduction.initial", "[-]: must be in");
}

TEST(SimplifiedOptions, UnavailableInstructionSetIsRefused) {
  for (const auto set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (is_available(set))
      EXPECT_NO_THROW(Fastsim({.instruction_set = set}));
    else
      EXPECT_THROW(Fastsim({.instruction_set = set}), Error);
  }
  EXPECT_TRUE(is_available(InstructionSet::baseline));
  EXPECT_TRUE(is_available(best_instruction_set()));
}

TEST(SolveParallel, RefusesNumbersOfThreadsOutOfRange) {
  const Fastsim2 solver;
  for (const int bad : {0, -1, 1025})
    expect_error([&] { solve_parallel(solver, {}, {}, bad); }, "threads", "must be in [1, 1024]");
}

/// A copy has separate memory; an assigned solver is the one it was assigned from.
TEST(RowSolver, CopiesAreIndependent) {
  Fastsim2 solver({.mx = 4, .my = 3});
  const double expected = solver.solve(good_contact()).fy;
  RowSolver copy = solver;
  copy.solve(test_cases()[100]);
  EXPECT_EQ(solver.solve(good_contact()).fy, expected);
  EXPECT_EQ(copy.solve(good_contact()).fy, expected);
  Fastsim other({.mx = 9, .my = 9});
  copy = other;
  EXPECT_EQ(copy.scheme(), MarchingScheme::fastsim);
  EXPECT_EQ(copy.options().mx, 9);
  EXPECT_EQ(copy.solve(good_contact()).fy, other.solve(good_contact()).fy);
  const RowSolver moved = std::move(copy);
  EXPECT_EQ(moved.options().my, 9);
}

TEST(Fastsim, NamesItsSchemes) {
  EXPECT_EQ(Fastsim().scheme(), MarchingScheme::fastsim);
  EXPECT_EQ(Fastsim({}, FirstStep::half).scheme(), MarchingScheme::fastsim_half_step);
  EXPECT_EQ(Fastsim2().scheme(), MarchingScheme::fastsim2);
}

} // namespace
} // namespace microslip
