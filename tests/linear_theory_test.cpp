// Vanishing creepages: the simplified theory becomes linear and, with the flexibilities (F17), gives Kalker's C11, C22
// and C23. For Mz it has other coefficients.

#include "microslip/simplified/fastsim2.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/test_cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using std::numbers::pi;

/// Forces, and how they are measured.
struct Linear {
  double fx, fy, mz;
};

/// A particle that entered at x = h(y) carries p = -(xi/L1 - y phi/L3) (h - x) along x and
/// -(eta/L2) (h - x) - phi/L3 (h^2 - x^2)/2 along y. Integrated over the ellipse, for rolling forward:
/// Fx = -G c^2 C11 xi, Fy = -G c^2 (C22 eta + c C23 phi),
/// Mz = pi a^3 b eta/(4 L2) - 8 a^2 b^3 phi/(15 L3).
/// Rolling backward phi drives Fy, and eta Mz, in the opposite direction.
Linear linear_theory(const EllipticContact& contact, const Creepage& creepage, const Flexibilities& l,
                     RollingDirection direction) {
  const double a = contact.a, b = contact.b, sign = direction == RollingDirection::forward ? 1 : -1;
  const auto& [xi, eta, phi] = creepage;
  return {-8 * a * a * b / 3 * xi / l.longitudinal,
          -8 * a * a * b / 3 * eta / l.lateral - sign * pi * a * a * a * b / 4 * phi / l.spin,
          sign * pi * a * a * a * b / 4 * eta / l.lateral - 8 * a * a * b * b * b / 15 * phi / l.spin};
}

TEST(LinearTheory, FlexibilitiesGiveTheCreepageCoefficients) {
  RandomContacts random(31);
  for (int k = 0; k < 50; ++k) {
    const EllipticContact contact = random.next();
    const auto l = flexibilities(FlexibilityModel::three, {}, contact);
    const auto c = creepage_coefficients(contact.a / contact.b, contact.poisson_ratio);
    const double g = contact.shear_modulus, ab = contact.a * contact.b;
    const auto one = linear_theory(contact, {1, 0, 0}, l, RollingDirection::forward),
               two = linear_theory(contact, {0, 1, 0}, l, RollingDirection::forward),
               three = linear_theory(contact, {0, 0, 1}, l, RollingDirection::forward);
    EXPECT_DOUBLE_EQ(one.fx, -g * ab * c.c11);
    EXPECT_DOUBLE_EQ(two.fy, -g * ab * c.c22);
    EXPECT_DOUBLE_EQ(two.mz, 3 * pi / 32 * g * ab * contact.a * c.c22);
    EXPECT_DOUBLE_EQ(three.fy, -g * std::pow(ab, 1.5) * c.c23);
  }
}

/// Creepages so small that nothing slides on the grids below.
Creepage vanishing(const EllipticContact& contact, const Creepage& shares) {
  const Creepage unit = saturating_creepage(contact);
  constexpr double small = 1e-7;
  return {small * shares.longitudinal * unit.longitudinal, small * shares.lateral * unit.lateral,
          small * shares.spin * unit.spin};
}

constexpr Creepage mixtures[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, -0.7, 0.4}, {-0.3, -1, -0.8}};

/// Largest error over shapes and mixtures of creepages, relative to the size of the creepages.
double linear_error(MarchingScheme scheme, TractionBound bound, RollingDirection direction, int n) {
  RowSolver solver(scheme, {.mx = n, .my = n, .bound = bound, .direction = direction});
  double worst = 0;
  for (EllipticContact contact : every_nth_case(644))
    for (const Creepage& shares : mixtures) {
      contact.creepage = vanishing(contact, shares);
      const auto l = flexibilities(FlexibilityModel::three, {}, contact);
      const auto expected = linear_theory(contact, contact.creepage, l, direction);
      const auto f = solver.solve(contact);
      const double force = 1e-7 * friction_force(contact), moment = force * std::max(contact.a, contact.b);
      worst = std::max({worst, std::abs(f.fx - expected.fx) / force, std::abs(f.fy - expected.fy) / force,
                        std::abs(f.mz - expected.mz) / moment});
      EXPECT_EQ(f.status, Status::ok);
      EXPECT_EQ(f.slip_area, 0);
    }
  return worst;
}

/// Order 2 where p is integrated exactly, which leaves the sum over the rows; 3/2 where the weights of the elliptic
/// bound come in; 1 for the full first step.
TEST(LinearTheory, IsTheLimitOfVanishingCreepages) {
  for (const auto scheme : all_schemes)
    for (const auto bound : all_bounds)
      for (const auto direction : all_directions) {
        SCOPED_TRACE(describe(RowSolver(scheme, {.bound = bound, .direction = direction})));
        const double order = scheme == MarchingScheme::fastsim ? 1 : bound == TractionBound::elliptic ? 1.5 : 2;
        const double at20 = linear_error(scheme, bound, direction, 20);
        const double at160 = linear_error(scheme, bound, direction, 160);
        EXPECT_NEAR(std::log2(at20 / at160) / 3, order, 0.2);
        EXPECT_LT(at160, scheme == MarchingScheme::fastsim ? 0.03 : 1e-3);
      }
}

/// The flexibility (F19) is the mean for each mixture: linear theory with three equal flexibilities.
TEST(LinearTheory, HoldsForEveryFlexibilityModel) {
  for (const auto model : all_flexibility_models) {
    Fastsim2 solver({.mx = 200, .my = 200, .flexibility = model});
    for (EllipticContact contact : every_nth_case(644))
      for (const Creepage& shares : mixtures) {
        contact.creepage = vanishing(contact, shares);
        const auto l = flexibilities(model, {}, contact);
        const auto expected = linear_theory(contact, contact.creepage, l, RollingDirection::forward);
        const auto f = solver.solve(contact);
        const double force = 1e-7 * friction_force(contact);
        expect_forces(f, expected, 1e-3 * force, 1e-3 * force * std::max(contact.a, contact.b));
      }
  }
}

TEST(LinearTheory, SlopeReductionReducesTheSlope) {
  EllipticContact contact = test_cases()[0];
  contact.creepage = vanishing(contact, {1, -0.7, 0.4});
  for (const auto scheme : all_schemes) {
    RowSolver full(scheme, {}), reduced(scheme, {.slope_reduction = {.initial = 0.3, .at_infinity = 0.4, .decay = 2}});
    const auto f = full.solve(contact), r = reduced.solve(contact);
    expect_forces({r.fx / f.fx, r.fy / f.fy, r.mz / f.mz}, {0.3, 0.3, 0.3}, 1e-6);
  }
}

/// Without creepage the derivatives are finite and those of linear theory on the same grid.
TEST(LinearTheory, IsTheJacobianAtRest) {
  for (RowSolver& solver : all_solvers(9, 8)) {
    if (solver.options().flexibility == FlexibilityModel::one) continue; // has a kink there, see below
    SCOPED_TRACE(describe(solver));
    for (EllipticContact contact : every_nth_case(644)) {
      contact.creepage = {};
      const auto at_rest = solver.differentiate(contact);
      const Creepage unit = vanishing(contact, {1, 1, 1});
      const double force = 1e-7 * friction_force(contact);
      const Creepage single[] = {{unit.longitudinal, 0, 0}, {0, unit.lateral, 0}, {0, 0, unit.spin}};
      const double size[] = {unit.longitudinal, unit.lateral, unit.spin};
      for (int k = 0; k < 3; ++k) {
        contact.creepage = single[k];
        const auto f = solver.solve(contact);
        EXPECT_NEAR(at_rest.jacobian[0][k] * size[k], f.fx, 1e-6 * force);
        EXPECT_NEAR(at_rest.jacobian[1][k] * size[k], f.fy, 1e-6 * force);
        EXPECT_NEAR(at_rest.jacobian[2][k] * size[k], f.mz, 1e-6 * force * std::max(contact.a, contact.b));
      }
      for (int n = 0; n < 3; ++n) EXPECT_EQ(at_rest.jacobian[n][3], 0);
      EXPECT_EQ(at_rest.forces.slip_area, 0);
    }
  }
}

/// The mean flexibility (F19) depends on the direction in which the creepages leave rest; any value will do there.
TEST(LinearTheory, JacobianAtRestIsFiniteWithOneFlexibility) {
  EllipticContact contact = test_cases()[0];
  for (const auto scheme : all_schemes) {
    RowSolver solver(scheme, {.flexibility = FlexibilityModel::one});
    for (const auto& row : solver.differentiate(contact).jacobian)
      for (const double slope : row) EXPECT_TRUE(std::isfinite(slope));
  }
}

} // namespace
} // namespace microslip
