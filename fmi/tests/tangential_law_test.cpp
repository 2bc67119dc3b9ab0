#include "fmi/tangential_law.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "tests/support/expect_close.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace microslip::fmi {
namespace {

/// Half adhesion, half slip, with all creepages.
LawInput some_input() {
  return {.creepage = {0.001, -0.0005, 0.3}, .normal_force = 60e3, .friction = 0.25};
}

TEST(TangentialLaw, EllipseGrowsAsHertzSays) {
  // The parameters are those of one load, the forces those of Hertz's ellipse under another.
  const CombinedMaterial material{82e9, 0.28, 0};
  const GapCurvatures gap = {0.8, 1.3};
  const HertzContact reference = hertz_from_load(gap, material, 80e3), hertz = hertz_from_load(gap, material, 60e3);
  TangentialLaw law({.semi_axis_x = reference.a, .semi_axis_y = reference.b, .reference_force = 80e3});
  const LawInput input = some_input();
  const ContactForces found = law.evaluate(input), wanted = Fastsim2().solve({.a = hertz.a,
                                                                              .b = hertz.b,
                                                                              .shear_modulus = 82e9,
                                                                              .poisson_ratio = 0.28,
                                                                              .normal_force = 60e3,
                                                                              .friction = FrictionLaw::coulomb(0.25),
                                                                              .creepage = input.creepage});
  expect_forces(found, wanted, 1e-9 * 15e3);
  EXPECT_NEAR(found.slip_area, wanted.slip_area, 1e-9 * wanted.slip_area);
}

TEST(TangentialLaw, DerivativesAreThoseOfTheForces) {
  TangentialLaw law({});
  const LawInput input = some_input();
  const auto by = law.differentiate(input);
  const double steps[] = {1e-8, 1e-8, 1e-5, 0.5, 1e-6};
  for (int k = 0; k < 5; ++k) {
    const auto moved = [&](double by_steps) {
      LawInput at = input;
      double* const inputs[] = {&at.creepage.longitudinal, &at.creepage.lateral, &at.creepage.spin, &at.normal_force,
                                &at.friction};
      *inputs[k] += by_steps * steps[k];
      return law.evaluate(at);
    };
    const ContactForces above = moved(1), below = moved(-1);
    const double differences[] = {above.fx - below.fx, above.fy - below.fy, above.mz - below.mz};
    for (int row = 0; row < 3; ++row) {
      const double difference = differences[row] / (2 * steps[k]);
      EXPECT_NEAR(by[row][k], difference, 1e-5 * std::abs(difference)) << row << ", " << k;
    }
  }
}

TEST(TangentialLaw, WithoutFrictionTheForceIsZeroAndGrowsWithFriction) {
  TangentialLaw law({});
  LawInput input = some_input();
  input.friction = 0;
  EXPECT_EQ(law.evaluate(input).fx, 0);
  const auto by = law.differentiate(input);
  input.friction = 1e-6; // full sliding
  EXPECT_NEAR(by[0][4], law.evaluate(input).fx / 1e-6, 1e-3 * std::abs(by[0][4]));
  EXPECT_LT(by[0][4], -1e3);
}

TEST(TangentialLaw, AWheelThatLiftsHasNoForces) {
  TangentialLaw law({});
  LawInput input = some_input();
  for (const double load : {0.0, -5.0}) {
    input.normal_force = load;
    const ContactForces forces = law.evaluate(input);
    EXPECT_EQ(forces.status, Status::no_contact);
    EXPECT_EQ(std::abs(forces.fx) + std::abs(forces.fy) + std::abs(forces.mz) + forces.slip_area, 0);
    EXPECT_EQ(law.differentiate(input)[0][0], 0);
  }
  input.normal_force = 1e-3;
  EXPECT_NEAR(std::hypot(law.evaluate(input).fx, law.evaluate(input).fy), 0.25e-3, 1e-6); // slides fully
}

TEST(TangentialLaw, RefusesWhatIsOutOfRange) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(TangentialLaw({.semi_axis_x = 0}), Error);
  EXPECT_THROW(TangentialLaw({.semi_axis_y = nan}), Error);
  EXPECT_THROW(TangentialLaw({.reference_force = -1}), Error);
  EXPECT_THROW(TangentialLaw({.shear_modulus = 0}), Error);
  EXPECT_THROW(TangentialLaw({.poisson_ratio = 0.6}), Error);
  EXPECT_THROW(TangentialLaw({.mx = 0}), Error);
  TangentialLaw law({});
  EXPECT_THROW(law.evaluate({.creepage = {nan, 0, 0}}), Error);
  EXPECT_THROW(law.evaluate({.creepage = {0, nan, 0}}), Error);
  EXPECT_THROW(law.evaluate({.creepage = {0, 0, nan}}), Error);
  EXPECT_THROW(law.evaluate({.creepage = {}, .normal_force = nan}), Error);
  EXPECT_THROW(law.differentiate({.creepage = {}, .friction = -0.1}), Error);
}

} // namespace
} // namespace microslip::fmi
