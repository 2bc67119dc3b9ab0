// What must not change, or change predictably, when a contact is mirrored, reversed or measured in other units.

#include "microslip/simplified/row_solver.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/test_cases.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Signs that fx, fy, mz, or xi, eta, phi, are multiplied by.
struct Signs {
  int x, y, turn;
};

EllipticContact with_signs(EllipticContact contact, const Signs& signs) {
  Creepage& c = contact.creepage;
  c = {signs.x * c.longitudinal, signs.y * c.lateral, signs.turn * c.spin};
  return contact;
}

std::vector<EllipticContact> contacts() {
  return cases_and_random_contacts(37, 21, [](int k, EllipticContact& contact) {
    if (k % 3 == 0)
      contact.friction = FrictionLaw::rational(0.1, {.drop = 0.3, .half_velocity = 0.01 * contact.rolling_speed});
  });
}

/// Solvers with and without slope reduction.
std::vector<RowSolver> solvers(int mx, int my) {
  auto solvers = all_solvers(mx, my);
  for (const RowSolver& solver : all_solvers(mx, my)) {
    SimplifiedOptions options = solver.options();
    options.slope_reduction = {.initial = 0.6, .at_infinity = 0.5, .decay = 0.8};
    solvers.emplace_back(solver.scheme(), options);
  }
  return solvers;
}

constexpr double rounding = 1e-13;

void expect_signed(const ContactForces& forces, const Signs& signs, const ContactForces& expected,
                   const EllipticContact& contact) {
  const double force = friction_force(contact);
  expect_forces(forces, {signs.x * expected.fx, signs.y * expected.fy, signs.turn * expected.mz}, rounding * force,
                rounding * friction_moment(contact), describe(contact));
}

/// The same solver must answer creepages with changed signs by forces with changed signs.
void expect_symmetry(const Signs& creepages, const Signs& forces) {
  const auto all = contacts();
  for (RowSolver& solver : solvers(7, 6)) {
    SCOPED_TRACE(describe(solver));
    for (const EllipticContact& contact : all)
      expect_signed(solver.solve(with_signs(contact, creepages)), forces, solver.solve(contact), contact);
  }
}

/// y -> -y: w = (xi - phi y, eta + phi x) is mirrored when eta and phi change sign.
TEST(Symmetry, MirrorAcrossTheRollingDirection) {
  expect_symmetry({1, -1, -1}, {1, -1, -1});
}

TEST(Symmetry, ReversedCreepagesReverseTheForces) {
  expect_symmetry({-1, -1, -1}, {-1, -1, -1});
}

/// Both together: an ellipse does not mind the sign of xi but for that of Fx.
TEST(Symmetry, ReversedLongitudinalCreepageReversesFxOnly) {
  expect_symmetry({-1, 1, 1}, {-1, 1, 1});
}

/// x -> -x turns rolling forward into rolling backward: w is mirrored when xi and phi change sign; then Fx and Mz do.
TEST(Symmetry, RollingBackwardIsTheMirrorImageOfRollingForward) {
  const auto all = contacts();
  for (const RowSolver& solver : all_solvers(7, 6)) {
    SCOPED_TRACE(describe(solver));
    SimplifiedOptions options = solver.options();
    options.slope_reduction = {.initial = 0.6};
    options.direction = RollingDirection::forward;
    RowSolver forward(solver.scheme(), options);
    options.direction = RollingDirection::backward;
    RowSolver backward(solver.scheme(), options);
    for (const EllipticContact& contact : all)
      expect_signed(backward.solve(with_signs(contact, {-1, 1, -1})), {-1, 1, -1}, forward.solve(contact), contact);
  }
}

TEST(Symmetry, FieldsAreMirroredToo) {
  const auto all = contacts();
  for (RowSolver& solver : solvers(5, 6)) {
    SCOPED_TRACE(describe(solver));
    for (std::size_t n = 0; n < all.size(); n += 11) {
      const EllipticContact& contact = all[n];
      const double peak = friction_force(contact) / ellipse_area(contact);
      const ContactSolution f = solver.fields(contact), m = solver.fields(with_signs(contact, {1, -1, -1}));
      for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 5; ++i) {
          const int here = j * 5 + i, there = (5 - j) * 5 + i;
          ASSERT_NEAR(f.elements.x[here], m.elements.x[there], 1e-15 * contact.a);
          ASSERT_NEAR(f.elements.y[here], -m.elements.y[there], 1e-15 * contact.b);
          ASSERT_NEAR(f.fields.traction.x[here], m.fields.traction.x[there], 1e-12 * peak);
          ASSERT_NEAR(f.fields.traction.y[here], -m.fields.traction.y[there], 1e-12 * peak);
        }
      ASSERT_NEAR(f.totals.frictional_power, m.totals.frictional_power, 1e-12 * f.totals.frictional_power);
    }
  }
}

/// The same contact in units that are `length` and `force` times smaller.
EllipticContact in_units(EllipticContact contact, double length, double force) {
  contact.a *= length;
  contact.b *= length;
  contact.shear_modulus *= force / (length * length);
  contact.normal_force *= force;
  contact.creepage.spin /= length;
  contact.rolling_speed *= length;
  return contact;
}

void expect_same_in_units(double length, double force, double tolerance) {
  const auto all = contacts();
  for (RowSolver& solver : solvers(6, 5)) {
    SCOPED_TRACE(describe(solver));
    for (const EllipticContact& contact : all) {
      if (contact.friction.kind() != FrictionLaw::Kind::coulomb) continue;
      const EllipticContact other = in_units(contact, length, force);
      const ContactForces f = solver.solve(contact), g = solver.solve(other);
      expect_forces({g.fx / force, g.fy / force, g.mz / (force * length)}, f, tolerance * friction_force(contact),
                    tolerance * friction_moment(contact));
      if (tolerance == 0) {
        ASSERT_EQ(g.adhesion_area / (length * length), f.adhesion_area);
      }
    }
  }
}

/// Powers of two are exact in the machine's numbers.
TEST(Symmetry, UnitsDoNotMatter) {
  expect_same_in_units(1024, 0x1p-20, 0);
  expect_same_in_units(1e3, 1, rounding);             // mm, N
  expect_same_in_units(1 / 0.0254, 0.2248, rounding); // inch, pound
}

/// Velocities of a friction law in another unit, with the rolling speed in it too.
TEST(Symmetry, UnitOfTimeDoesNotMatter) {
  for (RowSolver& solver : solvers(6, 5)) {
    SCOPED_TRACE(describe(solver));
    EllipticContact contact = RandomContacts(22).next(), other = contact;
    contact.rolling_speed = 20;
    contact.friction = FrictionLaw::exponential(0.1, {.drop = 0.2, .half_velocity = 0.5});
    other.rolling_speed = 20 * 3600;
    other.friction = FrictionLaw::exponential(0.1, {.drop = 0.2, .half_velocity = 0.5 * 3600});
    expect_signed(solver.solve(other), {1, 1, 1}, solver.solve(contact), contact);
  }
}

/// With Coulomb friction, creepages and load k times as large on the same ellipse give k times the forces.
TEST(Symmetry, ForcesAreHomogeneousInCreepagesAndLoad) {
  const auto all = contacts();
  for (RowSolver& solver : solvers(7, 6)) {
    SCOPED_TRACE(describe(solver));
    for (const EllipticContact& contact : all) {
      if (contact.friction.kind() != FrictionLaw::Kind::coulomb) continue;
      for (const double k : {0.5, 3.7}) {
        EllipticContact larger = contact;
        larger.creepage = {k * contact.creepage.longitudinal, k * contact.creepage.lateral, k * contact.creepage.spin};
        larger.normal_force *= k;
        ContactForces f = solver.solve(larger);
        f.fx /= k;
        f.fy /= k;
        f.mz /= k;
        expect_signed(f, {1, 1, 1}, solver.solve(contact), contact);
      }
    }
  }
}

} // namespace
} // namespace microslip
