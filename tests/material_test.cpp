#include "microslip/elasticity/material.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace microslip {
namespace {

constexpr Material steel{.shear_modulus = 82e9, .poisson_ratio = 0.28};

void expect_relative(double value, double expected, double tolerance) {
  EXPECT_NEAR(value, expected, tolerance * std::abs(expected));
}

TEST(Material, ShearModulusFromYoungs) {
  const Material material = Material::from_young(210e9, 0.25);
  EXPECT_DOUBLE_EQ(material.shear_modulus, 84e9);
  EXPECT_EQ(material.poisson_ratio, 0.25);
  EXPECT_TRUE(std::isinf(Material::from_young(infinity, 0.3).shear_modulus));
}

TEST(CombinedMaterial, EqualBodiesGiveTheirOwnConstants) {
  for (const double modulus : {1.0, 3e7, 82e9, 0.1, 1e-300, 1e300}) {
    for (const double ratio : {0.0, 0.1, 0.28, 0.3, 0.5}) {
      const Material body{.shear_modulus = modulus, .poisson_ratio = ratio};
      const CombinedMaterial combined = combine(body, body);
      EXPECT_EQ(combined.shear_modulus, modulus);
      EXPECT_EQ(combined.poisson_ratio, ratio);
      EXPECT_EQ(combined.dissimilarity, 0);
    }
  }
}

TEST(CombinedMaterial, SatisfiesTheDefinitionsOfHalfSpaceTheory) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> modulus(1e9, 2e11), ratio(0, 0.5);
  for (int i = 0; i < 200; ++i) {
    const Material one{.shear_modulus = modulus(random), .poisson_ratio = ratio(random)};
    const Material two{.shear_modulus = modulus(random), .poisson_ratio = ratio(random)};
    const auto [g1, nu1] = one;
    const auto [g2, nu2] = two;
    const CombinedMaterial combined = combine(one, two);
    const double g = combined.shear_modulus;
    expect_relative(1 / g, (1 / g1 + 1 / g2) / 2, 1e-15);
    expect_relative(combined.poisson_ratio / g, (nu1 / g1 + nu2 / g2) / 2, 2e-15);
    EXPECT_NEAR(combined.dissimilarity, g * ((1 - 2 * nu1) / g1 - (1 - 2 * nu2) / g2) / 4, 1e-15);
  }
}

TEST(CombinedMaterial, ContactModulusAddsTheCompliancesOfBothBodies) {
  // 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 (Johnson 1985, equation (4.21)).
  const double e1 = 206e9, nu1 = 0.28, e2 = 3e9, nu2 = 0.47;
  const CombinedMaterial combined = combine(Material::from_young(e1, nu1), Material::from_young(e2, nu2));
  expect_relative(1 / combined.contact_modulus(), (1 - nu1 * nu1) / e1 + (1 - nu2 * nu2) / e2, 1e-15);
}

TEST(CombinedMaterial, RigidBodyHasNoShare) {
  // What Poisson's ratio a rigid body is given does not matter.
  for (const double ratio : {0.0, 0.5}) {
    const Material rigid{.shear_modulus = infinity, .poisson_ratio = ratio};
    const CombinedMaterial combined = combine(steel, rigid);
    EXPECT_EQ(combined.shear_modulus, 2 * 82e9);
    EXPECT_EQ(combined.poisson_ratio, 0.28);
    EXPECT_DOUBLE_EQ(combined.dissimilarity, (1 - 2 * 0.28) / 2);
    EXPECT_DOUBLE_EQ(combine(rigid, steel).dissimilarity, -(1 - 2 * 0.28) / 2);
  }
}

TEST(CombinedMaterial, SwappingTheBodiesTurnsTheSignOfK) {
  const Material rubber{.shear_modulus = 1e6, .poisson_ratio = 0.4};
  const CombinedMaterial one = combine(steel, rubber);
  const CombinedMaterial other = combine(rubber, steel);
  EXPECT_EQ(one.shear_modulus, other.shear_modulus);
  EXPECT_EQ(one.poisson_ratio, other.poisson_ratio);
  EXPECT_EQ(one.dissimilarity, -other.dissimilarity);
  EXPECT_LT(one.dissimilarity, 0);
}

TEST(CombinedMaterial, BentallAndJohnsonsRollers) {
  // Published as K = 0.1002: G = 23,000 and 82,000 N/mm2, nu = 0.31 and 0.28.
  const CombinedMaterial combined =
      combine({.shear_modulus = 23e9, .poisson_ratio = 0.31}, {.shear_modulus = 82e9, .poisson_ratio = 0.28});
  EXPECT_NEAR(combined.dissimilarity, 0.1002, 0.5e-4);
}

TEST(CombinedMaterial, IncompressibleBodiesStayInRange) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> modulus(1e5, 1e7);
  for (int i = 0; i < 1000; ++i) {
    const CombinedMaterial combined = combine({.shear_modulus = modulus(random), .poisson_ratio = 0.5},
                                              {.shear_modulus = modulus(random), .poisson_ratio = 0.5});
    EXPECT_LE(combined.poisson_ratio, 0.5);
    EXPECT_GT(combined.poisson_ratio, 0.5 - 1e-15);
    EXPECT_EQ(combined.dissimilarity, 0);
  }
}

TEST(Material, RefusesConstantsThatMakeNoSense) {
  const std::string positive = "[Pa]: must be positive, or infinite for a rigid body";
  for (const double bad : {0.0, -82e9, -infinity, nan}) {
    const Material body{.shear_modulus = bad, .poisson_ratio = 0.28};
    expect_error([&] { combine(body, steel); }, "body1.shear_modulus", positive);
    expect_error([&] { combine(steel, body); }, "body2.shear_modulus", positive);
    expect_error([&] { Material::from_young(bad, 0.28); }, "young_modulus", positive);
  }
  for (const double bad : {-0.1, -1e-9, 0.500001, 0.62, infinity, nan}) {
    const Material body{.shear_modulus = 82e9, .poisson_ratio = bad};
    expect_error([&] { combine(body, steel); }, "body1.poisson_ratio", "[-]: must be in [0, 0.5]");
    expect_error([&] { combine(steel, body); }, "body2.poisson_ratio", "[-]: must be in [0, 0.5]");
    expect_error([&] { Material::from_young(210e9, bad); }, "poisson_ratio", "[-]: must be in [0, 0.5]");
  }
}

TEST(CombinedMaterial, RefusesTwoRigidBodies) {
  const Material rigid{.shear_modulus = infinity, .poisson_ratio = 0};
  expect_error([&] { combine(rigid, rigid); }, "body1.shear_modulus and body2.shear_modulus",
               "[Pa]: must be finite for at least one body");
}

} // namespace
} // namespace microslip
