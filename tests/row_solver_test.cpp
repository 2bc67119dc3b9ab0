#include "microslip/simplified/row_solver.hpp"

#include "microslip/batch/solve_parallel.hpp"
#include "microslip/simplified/fastsim.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "tests/plain_fastsim.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/same_bits.hpp"
#include "tests/test_cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using std::numbers::pi;

using microslip::same_bits;
bool same_bits(const ContactForces& one, const ContactForces& other) {
  return same_bits(one.fx, other.fx) && same_bits(one.fy, other.fy) && same_bits(one.mz, other.mz) &&
         same_bits(one.adhesion_area, other.adhesion_area) && same_bits(one.slip_area, other.slip_area) &&
         one.status == other.status;
}
bool same_bits(const ContactDerivatives& one, const ContactDerivatives& other) {
  bool same = same_bits(one.forces, other.forces);
  for (int n = 0; n < 3; ++n)
    for (int k = 0; k < 4; ++k) same = same && same_bits(one.jacobian[n][k], other.jacobian[n][k]);
  return same;
}

/// Contacts of all kinds, as a batch may bring them: of different friction laws, some invalid.
std::vector<EllipticContact> mixed_contacts() {
  return cases_and_random_contacts(101, 11, [](int k, EllipticContact& contact) {
    if (k % 5 == 3)
      contact.friction = FrictionLaw::exponential(0.1, {.drop = 0.3, .half_velocity = 0.02 * contact.rolling_speed});
    if (k % 7 == 4) contact.normal_force = -1;
    if (k % 11 == 5) contact.creepage = {};
  });
}

std::vector<ContactForces> solve_batch(RowSolver solver, const std::vector<EllipticContact>& contacts) {
  std::vector<ContactForces> forces(contacts.size());
  solver.solve(contacts, forces);
  return forces;
}

std::vector<ContactDerivatives> differentiate_batch(RowSolver solver, const std::vector<EllipticContact>& contacts) {
  std::vector<ContactDerivatives> derivatives(contacts.size());
  solver.differentiate(contacts, derivatives);
  return derivatives;
}

/// Forces in single precision are those in double to 1e-5 of mu Fn, whatever the units, the size of the slip and the
/// instruction set.
TEST(RowSolver, SinglePrecision) {
  for (const auto scheme : all_schemes)
    for (const auto& [mx, my] : {std::pair{10, 10}, {3, 17}, {40, 5}}) {
      RowSolver full(scheme, {.mx = mx, .my = my});
      std::vector<RowSolver> singles;
      for (const auto set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
        if (is_available(set))
          singles.push_back(
              RowSolver(scheme, {.mx = mx, .my = my, .instruction_set = set, .precision = Precision::single}));
      for (const double force_unit : {1.0, 1e-12, 1e12})
        for (const double slip : {1.0, 1e9, 1e20, 0.0}) {
          std::vector<EllipticContact> contacts = every_nth_case(7);
          for (EllipticContact& c : contacts) {
            c.normal_force *= force_unit, c.shear_modulus *= force_unit;
            c.creepage = {slip * c.creepage.longitudinal, slip * c.creepage.lateral, slip * c.creepage.spin};
          }
          const auto wanted = solve_batch(full, contacts);
          for (RowSolver& single : singles) {
            const auto found = solve_batch(single, contacts);
            for (std::size_t k = 0; k < contacts.size(); ++k) {
              SCOPED_TRACE(describe(single) + ": " + describe(contacts[k]));
              const double force = friction_force(contacts[k]), area = wanted[k].slip_area + wanted[k].adhesion_area;
              ASSERT_EQ(found[k].status, Status::ok);
              expect_forces(found[k], wanted[k], 1e-5 * force, 1e-5 * friction_moment(contacts[k]));
              ASSERT_NEAR(found[k].slip_area, wanted[k].slip_area, area / mx); // cells that are about to slip
            }
          }
        }
    }
}

TEST(RowSolver, SinglePrecisionWithoutFrictionAndOfBadInput) {
  RowSolver single(MarchingScheme::fastsim2, {.precision = Precision::single});
  EllipticContact contact = every_nth_case(1)[0];
  contact.friction = FrictionLaw::coulomb(0);
  EXPECT_EQ(single.solve(contact).fx, 0);
  contact.a = -1;
  EXPECT_EQ(single.solve(contact).status, Status::invalid_input);
}

TEST(RowSolver, InstructionSetsAgreeToTheLastBit) {
  const auto contacts = mixed_contacts();
  for (const RowSolver& solver : all_solvers(5, 9)) {
    SCOPED_TRACE(describe(solver));
    SimplifiedOptions options = solver.options();
    options.instruction_set = InstructionSet::baseline;
    RowSolver baseline(solver.scheme(), options);
    const auto forces = solve_batch(baseline, contacts);
    const auto derivatives = differentiate_batch(baseline, contacts);
    for (const auto set : {InstructionSet::avx2, InstructionSet::avx512}) {
      if (!is_available(set)) continue;
      options.instruction_set = set;
      RowSolver other(solver.scheme(), options);
      const auto other_forces = solve_batch(other, contacts);
      const auto other_derivatives = differentiate_batch(other, contacts);
      for (std::size_t k = 0; k < contacts.size(); ++k) {
        ASSERT_TRUE(same_bits(forces[k], other_forces[k])) << describe(other) << ": " << describe(contacts[k]);
        ASSERT_TRUE(same_bits(derivatives[k], other_derivatives[k])) << describe(other);
      }
      for (std::size_t k = 0; k < contacts.size(); k += 7) {
        const ContactSolution one = baseline.fields(contacts[k]), two = other.fields(contacts[k]);
        ASSERT_TRUE(same_bits(one.fields.traction.x, two.fields.traction.x) &&
                    same_bits(one.fields.traction.y, two.fields.traction.y) &&
                    same_bits(one.fields.slip.x, two.fields.slip.x) &&
                    same_bits(one.fields.slip.y, two.fields.slip.y) && one.fields.state == two.fields.state &&
                    same_bits(one.forces(), two.forces()));
      }
    }
  }
}

TEST(RowSolver, OneByOneAndInABatchAgreeToTheLastBit) {
  const auto contacts = mixed_contacts();
  for (const auto& [mx, my] : {std::pair{6, 10}, std::pair{3, 1}, std::pair{2, 400}})
    for (const auto scheme : all_schemes) {
      RowSolver solver(scheme, {.mx = mx, .my = my});
      SCOPED_TRACE(describe(solver));
      const auto forces = solve_batch(solver, contacts);
      const auto derivatives = differentiate_batch(solver, contacts);
      for (std::size_t k = 0; k < contacts.size(); ++k) {
        ASSERT_TRUE(same_bits(forces[k], solver.solve(contacts[k]))) << describe(contacts[k]);
        ASSERT_TRUE(same_bits(derivatives[k], solver.differentiate(contacts[k]))) << describe(contacts[k]);
      }
    }
}

TEST(RowSolver, ThreadsAgreeToTheLastBit) {
  std::vector<EllipticContact> contacts = test_cases(); // many chunks, the last one incomplete
  const auto mixed = mixed_contacts();
  contacts.insert(contacts.begin() + 700, mixed.begin(), mixed.end());
  for (const auto scheme : all_schemes) {
    const RowSolver solver(scheme, {.mx = 4, .my = 5});
    const auto forces = solve_batch(solver, contacts);
    for (const int threads : {1, 2, 3}) {
      std::vector<ContactForces> parallel(contacts.size());
      solve_parallel(solver, contacts, parallel, threads);
      for (std::size_t k = 0; k < contacts.size(); ++k)
        ASSERT_TRUE(same_bits(forces[k], parallel[k])) << "contact " << k << ", " << threads << " threads";
    }
  }
}

TEST(RowSolver, EmptyBatchIsNoWork) {
  Fastsim2 solver;
  solver.solve({}, {});
  solver.differentiate({}, {});
  solve_parallel(solver, {}, {}, 2);
}

TEST(RowSolver, ForcesAreTheSameWithAndWithoutDerivatives) {
  const auto contacts = mixed_contacts();
  for (RowSolver& solver : all_solvers(6, 7)) {
    SCOPED_TRACE(describe(solver));
    const auto forces = solve_batch(solver, contacts);
    const auto derivatives = differentiate_batch(solver, contacts);
    for (std::size_t k = 0; k < contacts.size(); ++k)
      ASSERT_TRUE(same_bits(forces[k], derivatives[k].forces)) << describe(contacts[k]);
  }
}

/// Against the paper's algorithms written down without any haste; differences relative to mu Fn.
void expect_plain_result(const RowSolver& solver, const std::vector<EllipticContact>& contacts) {
  SCOPED_TRACE(describe(solver));
  const auto forces = solve_batch(solver, contacts);
  double worst = 0, worst_area = 0;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const EllipticContact& contact = contacts[k];
    ASSERT_EQ(forces[k].status, Status::ok);
    const auto plain = plain::solve(static_cast<int>(solver.scheme()), solver.options(), contact);
    const double force = friction_force(contact), moment = friction_moment(contact);
    worst = std::max({worst, std::abs(forces[k].fx - plain.fx) / force, std::abs(forces[k].fy - plain.fy) / force,
                      std::abs(forces[k].mz - plain.mz) / moment});
    // Under pure spin particles meet the bound at both sides of the y axis alike: rounding decides which cells slide.
    if (contact.creepage.longitudinal != 0 || contact.creepage.lateral != 0)
      worst_area = std::max(worst_area, std::abs(forces[k].slip_area - plain.slip_area) / ellipse_area(contact));
  }
  EXPECT_LT(worst, 1e-13);
  EXPECT_LT(worst_area, 1e-10);
}

TEST(RowSolver, AgreesWithThePlainAlgorithmOnAllTestCases) {
  const auto cases = test_cases();
  for (const RowSolver& solver : all_solvers(10, 10)) expect_plain_result(solver, cases);
}

TEST(RowSolver, AgreesWithThePlainAlgorithmOnOddGrids) {
  const auto cases = every_nth_case(17);
  for (const auto& [mx, my] :
       {std::pair{1, 1}, std::pair{1, 7}, std::pair{7, 1}, std::pair{2, 3}, std::pair{3, 5}, std::pair{33, 2}})
    for (const RowSolver& solver : all_solvers(mx, my)) expect_plain_result(solver, cases);
}

TEST(RowSolver, AgreesWithThePlainAlgorithmOnRandomContacts) {
  RandomContacts random(12);
  std::vector<EllipticContact> contacts;
  for (int k = 0; k < 200; ++k) contacts.push_back(random.next());
  for (const RowSolver& solver : all_solvers(8, 11)) expect_plain_result(solver, contacts);
}

/// Grids from one cell to long and wide ones.
constexpr std::pair<int, int> grids[] = {{1, 1}, {1, 10}, {10, 1}, {3, 5}, {10, 10}, {33, 2}, {64, 37}};

/// The effective rigid slip (F18) decides where the force points: that is -w when all flexibilities are equal.
TEST(RowSolver, FullSlidingGivesTheFrictionForceOnEveryGrid) {
  EllipticContact contact = test_cases()[0];
  for (const auto& [mx, my] : grids)
    for (RowSolver& solver : all_solvers(mx, my))
      for (const double angle : {0.0, 0.7, pi / 2, 2.5, 4.0, 5.9}) {
        SCOPED_TRACE(describe(solver));
        contact.creepage = {1e3 * std::cos(angle), 1e3 * std::sin(angle), 0};
        const Flexibilities l = flexibilities(solver.options().flexibility, {}, contact);
        const double wx = contact.creepage.longitudinal / l.longitudinal, wy = contact.creepage.lateral / l.lateral;
        const ContactForces f = solver.solve(contact);
        const double force = friction_force(contact), w = std::hypot(wx, wy);
        EXPECT_NEAR(f.fx, -force * wx / w, 1e-14 * force);
        EXPECT_NEAR(f.fy, -force * wy / w, 1e-14 * force);
        EXPECT_NEAR(std::hypot(f.fx, f.fy), force, 1e-14 * force);
        // FASTSIM2 lets a particle adhere for a moment under the elliptic bound, which rises infinitely fast at first.
        const bool at_once =
            solver.scheme() != MarchingScheme::fastsim2 || solver.options().bound == TractionBound::parabolic;
        EXPECT_NEAR(f.slip_area, ellipse_area(contact), (at_once ? 1e-14 : 1e-6) * ellipse_area(contact));
        if (solver.options().flexibility != FlexibilityModel::three) {
          EXPECT_NEAR(f.fx, -force * std::cos(angle), 1e-14 * force);
          EXPECT_NEAR(f.fy, -force * std::sin(angle), 1e-14 * force);
        }
      }
}

/// Calls `check` with every n-th case and its forces by all solvers on all grids.
template <class Check> void for_all_solvers(std::size_t n, const Check& check) {
  const auto cases = every_nth_case(n);
  for (const auto& [mx, my] : grids)
    for (const RowSolver& solver : all_solvers(mx, my)) {
      SCOPED_TRACE(describe(solver));
      const auto forces = solve_batch(solver, cases);
      for (std::size_t k = 0; k < cases.size(); ++k) check(cases[k], forces[k]);
    }
}

TEST(RowSolver, AreasAddUpToTheEllipse) {
  for_all_solvers(13, [](const EllipticContact& contact, const ContactForces& forces) {
    const double area = ellipse_area(contact);
    ASSERT_NEAR(forces.adhesion_area + forces.slip_area, area, 1e-15 * area);
    ASSERT_GE(forces.adhesion_area, 0);
    ASSERT_GE(forces.slip_area, 0);
  });
}

TEST(RowSolver, ForceIsNeverLargerThanFriction) {
  for_all_solvers(5, [](const EllipticContact& contact, const ContactForces& forces) {
    ASSERT_LE(std::hypot(forces.fx, forces.fy), friction_force(contact) * (1 + 1e-14));
  });
}

/// Longitudinal or lateral creepage alone under the parabolic bound, in closed form: with theta = acos(k), the force
/// over mu Fn is 1 - 8/(3 pi) integral of (cos t - k)^3 cos t over [-theta, theta], where k is the creepage over the
/// one that makes everything slide; the adhesion area over that of the ellipse is 2/pi (theta - k sin theta).
double creep_force(double k) {
  const double t = std::acos(k), s = std::sin(t);
  const double cos4 = 3 * t / 4 + std::sin(2 * t) / 2 + std::sin(4 * t) / 16, cos3 = 2 * s - 2 * s * s * s / 3;
  return 1 - 8 / (3 * pi) * (cos4 - 3 * k * cos3 + 3 * k * k * (t + s * k) - 2 * k * k * k * s);
}
double adhesion_share(double k) {
  return 2 / pi * (std::acos(k) - k * std::sin(std::acos(k)));
}

struct CreepError {
  double force = 0, area = 0;
};

/// Root of the mean square error over a creep curve.
CreepError creep_error(RowSolver solver, bool longitudinal) {
  EllipticContact contact = test_cases()[0];
  const Flexibilities l = flexibilities(FlexibilityModel::three, {}, contact);
  const double slope = 4 * friction_force(contact) / (ellipse_area(contact) * contact.a);
  CreepError error;
  const int points = 97;
  for (int n = 1; n <= points; ++n) {
    const double k = n / (points + 1.0);
    contact.creepage = longitudinal ? Creepage{.longitudinal = k * slope * l.longitudinal}
                                    : Creepage{.lateral = k * slope * l.lateral};
    const ContactForces f = solver.solve(contact);
    const double force = -(longitudinal ? f.fx : f.fy) / friction_force(contact);
    error.force += std::pow(force - creep_force(k), 2) / points;
    error.area += std::pow(f.adhesion_area / ellipse_area(contact) - adhesion_share(k), 2) / points;
  }
  return {std::sqrt(error.force), std::sqrt(error.area)};
}

/// Creepage that is constant along a row is integrated without error by the schemes that begin with half a step.
TEST(RowSolver, TendsToTheClosedFormOfTheCreepCurve) {
  struct Expected {
    MarchingScheme scheme;
    double force_order, area_order, force_at_20;
  };
  for (const bool longitudinal : {true, false})
    for (const auto& expected :
         {Expected{MarchingScheme::fastsim2, 2, 1.5, 4e-4}, Expected{MarchingScheme::fastsim_half_step, 2, 1, 4e-4},
          Expected{MarchingScheme::fastsim, 1, 1, 0.025}}) {
      SCOPED_TRACE(describe(RowSolver(expected.scheme, {})));
      const auto error = [&](int n) {
        return creep_error(RowSolver(expected.scheme, {.mx = n, .my = n}), longitudinal);
      };
      const CreepError at20 = error(20), at160 = error(160);
      EXPECT_LT(at20.force, expected.force_at_20);
      EXPECT_NEAR(std::log2(at20.force / at160.force) / 3, expected.force_order, 0.25);
      EXPECT_NEAR(std::log2(at20.area / at160.area) / 3, expected.area_order, 0.25);
    }
}

} // namespace
} // namespace microslip
