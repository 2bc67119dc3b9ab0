// Young's modulus of rubber by its Shore A hardness.

#include "microslip/elasticity/shore_hardness.hpp"
#include "microslip/error.hpp"

#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Boussinesq's flat punch of radius b, E = (1 - nu^2) F/(2 b d), nu = 1/2, with the spring and the stroke of ASTM
/// D2240 and the mean diameter of its cone's frustum, 0.79 mm at the tip and 1.27 mm behind it.
TEST(ShoreHardness, IsAPunchOnAHalfSpace) {
  for (const double shore : {20.0, 35.0, 50.0, 60.0, 75.0, 90.0}) {
    const double force = 0.55 + 0.075 * shore, diameter = 0.5 * (0.79e-3 + 1.27e-3), depth = 2.5e-3 * (1 - shore / 100);
    EXPECT_NEAR(young_modulus_of_shore_a(shore) / (0.75 * force / (diameter * depth)), 1, 0.025) << shore;
  }
}

/// E = 0.0981 (56 + 7.62336 S)/(0.137505 (254 - 2.54 S)), worked out by hand to four digits.
TEST(ShoreHardness, HasTheValuesOfTheFormula) {
  EXPECT_NEAR(young_modulus_of_shore_a(40), 1.690e6, 0.5e3);
  EXPECT_NEAR(young_modulus_of_shore_a(60), 3.605e6, 0.5e3);
  EXPECT_NEAR(young_modulus_of_shore_a(80), 9.351e6, 0.5e3);
}

TEST(ShoreHardness, RisesAndHasAnInverse) {
  double before = 0;
  for (double shore = softest_shore_a; shore <= hardest_shore_a; shore += 2.5) {
    const double young = young_modulus_of_shore_a(shore);
    EXPECT_GT(young, before);
    EXPECT_NEAR(shore_a_of_young_modulus(young), shore, 1e-10);
    before = young;
  }
}

TEST(ShoreHardness, RefusesWhatIsOutOfRange) {
  for (const double shore : {-1.0, 19.9, 90.1, 100.0, 0.0 / 0.0}) {
    EXPECT_THROW(young_modulus_of_shore_a(shore), Error) << shore;
  }
  for (const double young : {0.0, 0.73e6, 20.9e6, 200e9}) {
    EXPECT_THROW(shore_a_of_young_modulus(young), Error) << young;
  }
  try {
    young_modulus_of_shore_a(95);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), "shore_a = 95 [-]: must be in [20, 90]");
  }
}

} // namespace
} // namespace microslip
