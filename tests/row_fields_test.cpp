#include "microslip/damage/wear.hpp"
#include "microslip/simplified/row_solver.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/test_cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Partial-slip contacts of all shapes, some with friction that falls with the slip velocity.
std::vector<EllipticContact> contacts() {
  RandomContacts random(51);
  std::vector<EllipticContact> contacts = every_nth_case(149);
  for (int k = 0; k < 20; ++k) {
    contacts.push_back(random.next());
    if (k % 2 == 0)
      contacts.back().friction =
          FrictionLaw::exponential(0.1, {.drop = 0.3, .half_velocity = 0.01 * contacts.back().rolling_speed});
  }
  return contacts;
}

/// The slip as the march has it, in tractions per cell: S = s cell/L, component by component. It is a difference of
/// tractions, so it is good to rounding of them.
struct MarchedSlip {
  double x, y;
};
MarchedSlip marched_slip(const ContactSolution& f, std::size_t k, const EllipticContact& contact,
                         const Flexibilities& l) {
  const double cell = 2 * contact.a * std::sqrt(1 - std::pow(f.elements.y[k] / contact.b, 2)) / f.elements.mx();
  return {f.fields.slip.x[k] * cell / l.longitudinal, f.fields.slip.y[k] * cell / l.lateral};
}

/// Calls check(solver, contact, fields).
template <class Check> void for_all_fields(int mx, int my, Check check) {
  const auto all = contacts();
  for (RowSolver& solver : all_solvers(mx, my)) {
    SCOPED_TRACE(describe(solver));
    for (const EllipticContact& contact : all) check(solver, contact, solver.fields(contact));
  }
}

/// (F12): rows from -b to b, cells from the left to the right edge, whatever the direction.
TEST(RowFields, CellsAreWhereThePaperPutsThem) {
  for_all_fields(4, 7, [](const RowSolver&, const EllipticContact& contact, const ContactSolution& f) {
    ASSERT_EQ(f.elements.mx(), 4);
    ASSERT_EQ(f.elements.my(), 7);
    for (int j = 0; j < 7; ++j)
      for (int i = 0; i < 4; ++i) {
        const double y = -contact.b + (j + 0.5) * 2 * contact.b / 7;
        const double edge = contact.a * std::sqrt(1 - y * y / (contact.b * contact.b));
        ASSERT_NEAR(f.elements.y[4 * j + i], y, 1e-15 * contact.b);
        ASSERT_NEAR(f.elements.x[4 * j + i], (i + 0.5) * edge / 2 - edge, 1e-15 * contact.a);
      }
  });
}

TEST(RowFields, BoundIsThatOfTheFrictionLayer) {
  for_all_fields(5, 4, [](const RowSolver& solver, const EllipticContact& contact, const ContactSolution& f) {
    const auto shape = solver.options().bound;
    const double peak = traction_bound(shape, contact.a, contact.b, contact.normal_force, 1, 0, 0);
    for (std::size_t k = 0; k < f.elements.x.size(); ++k) {
      const auto& [xi, eta, phi] = contact.creepage;
      const double slip = std::hypot(xi - phi * f.elements.y[k], eta + phi * f.elements.x[k]);
      const double friction = contact.friction.coefficient(slip * contact.rolling_speed);
      const double expected =
          traction_bound(shape, contact.a, contact.b, contact.normal_force, friction, f.elements.x[k], f.elements.y[k]);
      ASSERT_NEAR(f.fields.bound[k], expected, 1e-14 * peak);
    }
  });
}

/// The weights make up the load exactly: with Coulomb friction the bound's sum is mu Fn.
TEST(RowFields, WeightsMakeUpTheLoad) {
  for (const int n : {1, 2, 5, 10, 31})
    for_all_fields(n, n, [](const RowSolver&, const EllipticContact& contact, const ContactSolution& f) {
      if (contact.friction.kind() != FrictionLaw::Kind::coulomb) return;
      double sum = 0;
      for (std::size_t k = 0; k < f.elements.x.size(); ++k) sum += f.elements.area[k] * f.fields.bound[k];
      ASSERT_NEAR(sum, friction_force(contact), 1e-14 * friction_force(contact));
    });
}

TEST(RowFields, TractionIsWithinTheBound) {
  for_all_fields(9, 8, [](const RowSolver&, const EllipticContact&, const ContactSolution& f) {
    for (std::size_t k = 0; k < f.elements.x.size(); ++k)
      ASSERT_LE(std::hypot(f.fields.traction.x[k], f.fields.traction.y[k]), f.fields.bound[k] * (1 + 4e-16));
  });
}

TEST(RowFields, CellsAdhereWithoutSlipOrSlipOnTheBound) {
  int adhesion = 0, slip = 0;
  for_all_fields(9, 8, [&](const RowSolver&, const EllipticContact&, const ContactSolution& f) {
    for (std::size_t k = 0; k < f.elements.x.size(); ++k) {
      if (f.fields.state[k] == CellState::adhesion) {
        ASSERT_EQ(f.fields.slip.x[k], 0);
        ASSERT_EQ(f.fields.slip.y[k], 0);
        ++adhesion;
      } else {
        ASSERT_EQ(f.fields.state[k], CellState::slip);
        ASSERT_NEAR(std::hypot(f.fields.traction.x[k], f.fields.traction.y[k]), f.fields.bound[k],
                    1e-15 * f.fields.bound[k]);
        ++slip;
      }
    }
  });
  EXPECT_GT(adhesion, 10000);
  EXPECT_GT(slip, 10000);
}

/// p = -g S/|S|, to the rounding of the tractions whose difference S is; with equal flexibilities S is parallel to s.
TEST(RowFields, TractionOpposesSlip) {
  for_all_fields(9, 8, [](const RowSolver& solver, const EllipticContact& contact, const ContactSolution& f) {
    const auto l = flexibilities(solver.options().flexibility, {}, contact);
    for (std::size_t k = 0; k < f.elements.x.size(); ++k) {
      if (f.fields.state[k] != CellState::slip) continue;
      const auto s = marched_slip(f, k, contact, l);
      const double p2 = f.fields.traction.x[k] * f.fields.traction.x[k] +
                        f.fields.traction.y[k] * f.fields.traction.y[k],
                   size = std::hypot(f.fields.traction.x[k], f.fields.traction.y[k]);
      // The tractions before and after the bound is applied can be larger than the bound by |S|.
      const double rounding = 1e-15 * size * (size + std::hypot(s.x, s.y));
      ASSERT_NEAR(f.fields.traction.x[k] * s.y - f.fields.traction.y[k] * s.x, 0, rounding);
      ASSERT_LE(f.fields.traction.x[k] * s.x + f.fields.traction.y[k] * s.y, 1e-15 * p2);
    }
  });
}

TEST(RowFields, TractionsAddUpToTheForces) {
  for_all_fields(9, 8, [](const RowSolver&, const EllipticContact& contact, const ContactSolution& f) {
    double fx = 0, fy = 0, mz = 0;
    for (std::size_t k = 0; k < f.elements.x.size(); ++k) {
      fx += f.elements.area[k] * f.fields.traction.x[k];
      fy += f.elements.area[k] * f.fields.traction.y[k];
      mz += f.elements.area[k] * (f.elements.x[k] * f.fields.traction.y[k] - f.elements.y[k] * f.fields.traction.x[k]);
    }
    const double force = friction_force(contact);
    expect_forces(f.totals, {fx, fy, mz}, 1e-14 * force, 1e-14 * force * std::max(contact.a, contact.b));
  });
}

TEST(RowFields, ForcesAreThoseOfTheForcesAlone) {
  for_all_fields(9, 8, [](RowSolver solver, const EllipticContact& contact, const ContactSolution& f) {
    const ContactForces expected = solver.solve(contact);
    const double force = friction_force(contact);
    expect_forces(f.totals, expected, 1e-14 * force, 1e-14 * friction_moment(contact));
    ASSERT_NEAR(f.totals.slip_area, expected.slip_area, 1e-10 * ellipse_area(contact));
  });
}

/// FASTSIM knows no boundary within a cell: the slip area is that of the sliding cells.
TEST(RowFields, SlipAreaIsThatOfTheSlidingCells) {
  for_all_fields(9, 8, [](const RowSolver& solver, const EllipticContact& contact, const ContactSolution& f) {
    if (solver.scheme() != MarchingScheme::fastsim) return;
    double sliding = 0, all = 0;
    for (std::size_t k = 0; k < f.elements.x.size(); ++k) {
      all += f.elements.area[k];
      if (f.fields.state[k] == CellState::slip) sliding += f.elements.area[k];
    }
    ASSERT_NEAR(f.totals.slip_area, sliding / all * ellipse_area(contact), 1e-14 * ellipse_area(contact));
  });
}

/// Power over the friction force times V times the creepages' size.
double power_unit(const EllipticContact& contact) {
  const auto& [xi, eta, phi] = contact.creepage;
  return friction_force(contact) * contact.rolling_speed *
         (std::hypot(xi, eta) + std::abs(phi) * std::max(contact.a, contact.b));
}

/// s = w + du/dq along the path q of a particle, so integral p.s = integral p.w + [L p^2/2], and p is zero where
/// particles enter and leave. With one flexibility integral p.w is xi Fx + eta Fy + phi Mz: what friction takes is what
/// drives the bodies. With three it is integral (L1 px w~x + L2 py w~y) with the effective rigid slip w~ of (F18).
double driving_power(const ContactSolution& f, const EllipticContact& contact, const Flexibilities& l) {
  const auto& [xi, eta, phi] = contact.creepage;
  double power = 0;
  for (std::size_t k = 0; k < f.elements.x.size(); ++k)
    power -= f.elements.area[k] * (f.fields.traction.x[k] * (xi - phi * f.elements.y[k] * l.longitudinal / l.spin) +
                                   f.fields.traction.y[k] * (eta + phi * f.elements.x[k] * l.lateral / l.spin));
  return power * contact.rolling_speed;
}

TEST(RowFields, FrictionTakesWhatDrivesTheBodies) {
  for_all_fields(9, 8, [](const RowSolver& solver, const EllipticContact& contact, const ContactSolution& f) {
    ASSERT_GE(f.totals.frictional_power, 0);
    const Flexibilities l = flexibilities(solver.options().flexibility, solver.options().slope_reduction, contact,
                                          solver.options().creepage_table);
    ASSERT_NEAR(f.totals.frictional_power, driving_power(f, contact, l), 1e-13 * power_unit(contact));
  });
}

/// -V sum of p.s over the cells' centres.
double power_at_centres(const ContactSolution& f, double rolling_speed) {
  const std::vector<double> work = friction_work(f);
  double power = 0;
  for (std::size_t k = 0; k < work.size(); ++k) power += rolling_speed * f.elements.area[k] * work[k];
  return power;
}

/// Also where nearly all adheres, and little or nothing of the slip shows at the cells' centres.
TEST(RowFields, FrictionalPowerNeedsNoFineCells) {
  RowSolver coarse(MarchingScheme::fastsim2, {.mx = 10, .my = 10}),
      fine(MarchingScheme::fastsim2, {.mx = 200, .my = 200});
  for (const double size : {0.01, 0.05, 0.2, 0.5, 1.0}) {
    EllipticContact contact = steel_contact(6e-3, 5e-3, 0.8 * size, -0.6 * size, 0);
    const double power = fine.fields(contact).totals.frictional_power;
    EXPECT_NEAR(coarse.fields(contact).totals.frictional_power, power, 0.02 * power) << size;
  }
}

/// Median over test cases of |power at the centres - driving power|, relative to the power that full sliding would
/// take. Where all slip is within the last cell the misfit is larger than that.
double power_misfit(MarchingScheme scheme, FlexibilityModel model, int n) {
  RowSolver solver(scheme, {.mx = n, .my = n, .flexibility = model});
  std::vector<double> misfits;
  for (const EllipticContact& contact : every_nth_case(29)) {
    if (!(power_unit(contact) > 0)) continue;
    const ContactSolution f = solver.fields(contact);
    const double driving = driving_power(f, contact, flexibilities(model, {}, contact));
    if (model == FlexibilityModel::one) {
      const auto& [xi, eta, phi] = contact.creepage;
      const double expected = -contact.rolling_speed * (xi * f.totals.fx + eta * f.totals.fy + phi * f.totals.mz);
      EXPECT_NEAR(driving, expected, 1e-13 * power_unit(contact));
    }
    misfits.push_back(std::abs(power_at_centres(f, contact.rolling_speed) - driving) / power_unit(contact));
  }
  std::nth_element(misfits.begin(), misfits.begin() + misfits.size() / 2, misfits.end());
  return misfits[misfits.size() / 2];
}

/// With order 1 from FASTSIM. From FASTSIM2 with order 3/2 at least: the cell in which slip begins counts whole, an
/// error of the cell's length in each row that has either sign and so grows with the root of the number of rows only.
TEST(RowFields, PowerAtTheCentresTendsToTheDrivingPower) {
  for (const auto model : all_flexibility_models)
    for (const auto scheme : all_schemes) {
      SCOPED_TRACE(describe(RowSolver(scheme, {.flexibility = model})));
      const double order = std::log2(power_misfit(scheme, model, 10) / power_misfit(scheme, model, 160)) / 4;
      if (scheme == MarchingScheme::fastsim2)
        EXPECT_GT(order, 1.5);
      else
        EXPECT_NEAR(order, 1, 0.15);
    }
}

} // namespace
} // namespace microslip
