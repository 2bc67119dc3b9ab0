#include "microslip/simplified/computed_coefficients.hpp"

#include "microslip/simplified/fastsim2.hpp"
#include "tests/test_cases.hpp"
#include "validation/rolling_without_slip.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace microslip {
namespace {

std::array<double, 4> computed(double a_over_b, double nu) {
  const CreepageCoefficients c = creepage_coefficients(a_over_b, nu, CreepageTable::computed);
  return {c.c11, c.c22, c.c23, c.c33};
}

/// At the table's entries and between them.
TEST(ComputedCoefficients, AreThoseOfTheSeries) {
  for (const double ratio : {0.05, 0.062, 0.3, 1.0, 1.13, 4.0, 17.0, 20.0})
    for (const double nu : {0.0, 0.06, 0.25, 0.28, 0.44, 0.5}) {
      const auto exact = validation::rolling_without_slip(ratio, nu, 48);
      const auto c = computed(ratio, nu);
      const std::array<double, 4> expected = {exact.c11, exact.c22, exact.c23, exact.c33};
      for (int n = 0; n < 4; ++n)
        EXPECT_NEAR(c[n], expected[n], 1e-4 * expected[n]) << "C number " << n << " at " << ratio << ", " << nu;
    }
}

/// Its three digits have errors.
TEST(ComputedCoefficients, AreCloseToKalkersTable) {
  for (int k = 1; k <= 19; ++k)
    for (const double nu : {0.0, 0.25, 0.5}) {
      const double ratio = k <= 10 ? 0.1 * k : 1 / (0.1 * (20 - k));
      const CreepageCoefficients kalker = creepage_coefficients(ratio, nu);
      const auto c = computed(ratio, nu);
      EXPECT_NEAR(c[0] / kalker.c11, 1, 0.01);
      EXPECT_NEAR(c[1] / kalker.c22, 1, 0.012);
      EXPECT_NEAR(c[2] / kalker.c23, 1, 0.02);
      EXPECT_NEAR(c[3] / kalker.c33, 1, 0.02);
    }
}

TEST(ComputedCoefficients, AreContinuous) {
  constexpr double step = 1e-9;
  for (const double seam : {0.05, 0.05 * std::pow(400, 1 / 24.0), 1.0, 0.05 * std::pow(400, 23 / 24.0), 20.0})
    for (const double nu : {0.0, 0.28, 0.5}) {
      const auto below = computed(seam * (1 - step), nu), above = computed(seam * (1 + step), nu);
      for (int n = 0; n < 4; ++n) EXPECT_NEAR(above[n], below[n], 10 * step * below[n]) << seam << ", C number " << n;
    }
}

TEST(ComputedCoefficients, ArePositiveAndFiniteForAnyEllipse) {
  for (int k = -120; k <= 120; ++k)
    for (const double nu : {0.0, 0.13, 0.25, 0.28, 0.4, 0.5})
      for (const double c : computed(std::pow(10, k / 10.0), nu)) {
        EXPECT_GT(c, 0) << "a/b = 1e" << k / 10.0 << ", nu = " << nu;
        EXPECT_TRUE(std::isfinite(c));
      }
}

/// At nu = 0 the half-space answers a traction alike in all directions: C11 = C22.
TEST(ComputedCoefficients, DoNotKnowTheDirectionAtPoissonsRatioZero) {
  for (int k = -10; k <= 10; ++k) {
    const auto c = computed(std::pow(10, k / 10.0), 0);
    EXPECT_NEAR(c[0] / c[1], 1, 1e-7);
  }
}

/// The simplified theory on request: Fx = -G a b C11 xi, Fy = -G a b C22 eta for vanishing creepages.
TEST(ComputedCoefficients, RuleTheSimplifiedTheoryOnRequest) {
  for (const auto table : {CreepageTable::kalker, CreepageTable::computed}) {
    Fastsim2 solver({.mx = 200, .my = 200, .creepage_table = table});
    for (EllipticContact contact : every_nth_case(644)) {
      const double small = 1e-7 * friction_force(contact) / (contact.shear_modulus * contact.a * contact.b);
      contact.creepage = {small, -small, 0};
      const auto c = creepage_coefficients(contact.a / contact.b, contact.poisson_ratio, table);
      const auto f = solver.solve(contact);
      const double unit = contact.shear_modulus * contact.a * contact.b * small;
      EXPECT_NEAR(f.fx / unit, -c.c11, 2e-4 * c.c11);
      EXPECT_NEAR(f.fy / unit, c.c22, 2e-4 * c.c22);
    }
  }
}

} // namespace
} // namespace microslip
