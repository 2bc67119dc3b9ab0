#include "creep_law.hpp"

#include <microslip.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace {

/// Wheel of Cooperrider's bogie at rest in the middle of the track, as DYTSI's table of contact geometry has it.
WheelContact wheel_at_rest() {
  return {5.9519e-3, 6.6526e-3, 4.1246, 3.5631, 1.3703, 8.268e10, 0.15, 66661, 0, 0, 0};
}

WheelContact with_creepages(double longitudinal, double lateral, double spin) {
  WheelContact contact = wheel_at_rest();
  contact.longitudinal = longitudinal;
  contact.lateral = lateral;
  contact.spin = spin;
  return contact;
}

double bound(const WheelContact& contact) {
  return contact.friction * contact.normal_force;
}

class EveryLaw : public testing::TestWithParam<std::string> {
protected:
  CreepForces forces(double longitudinal, double lateral, double spin) {
    return law_->forces(with_creepages(longitudinal, lateral, spin));
  }

private:
  std::unique_ptr<CreepLaw> law_ = make_creep_law(GetParam());
};

TEST_P(EveryLaw, OpposesCreepageAndStaysBelowTheBound) {
  for (const double creepage : {1e-4, 1e-3, 1e-2}) {
    const CreepForces found = forces(creepage, creepage, 0);
    EXPECT_LT(found.longitudinal, 0);
    EXPECT_LT(found.lateral, 0);
    EXPECT_LE(std::hypot(found.longitudinal, found.lateral), bound(wheel_at_rest()) * (1 + 1e-9));
  }
}

TEST_P(EveryLaw, ReversedCreepagesReverseForces) {
  const CreepForces one = forces(7e-4, -4e-4, 0.1), other = forces(-7e-4, 4e-4, -0.1);
  EXPECT_NEAR(one.longitudinal, -other.longitudinal, 1e-6 * bound(wheel_at_rest()));
  EXPECT_NEAR(one.lateral, -other.lateral, 1e-6 * bound(wheel_at_rest()));
}

TEST_P(EveryLaw, LeftAndRightAreMirrorImages) {
  const CreepForces one = forces(7e-4, -4e-4, 0.1), other = forces(7e-4, 4e-4, -0.1);
  EXPECT_NEAR(one.longitudinal, other.longitudinal, 1e-6 * bound(wheel_at_rest()));
  EXPECT_NEAR(one.lateral, -other.lateral, 1e-6 * bound(wheel_at_rest()));
}

TEST_P(EveryLaw, BeginsWithKalkersCoefficients) {
  const WheelContact at_rest = wheel_at_rest();
  const double stiffness = at_rest.shear_modulus * at_rest.a * at_rest.b, c = std::sqrt(at_rest.a * at_rest.b);
  const double small = 1e-7;
  // Those of the table of geometry are Kalker's to 1 %, and 24 x 24 elements or 10 x 10 cells have 1 % more.
  EXPECT_NEAR(forces(small, 0, 0).longitudinal / (-stiffness * small), at_rest.c11, 0.02 * at_rest.c11);
  EXPECT_NEAR(forces(0, small, 0).lateral / (-stiffness * small), at_rest.c22, 0.02 * at_rest.c22);
  EXPECT_NEAR(forces(0, 0, small / c).lateral / (-stiffness * small), at_rest.c23, 0.02 * at_rest.c23);
}

TEST_P(EveryLaw, SlidesUnderLargeCreepage) {
  EXPECT_NEAR(forces(1, 0, 0).longitudinal, -bound(wheel_at_rest()), 1e-3 * bound(wheel_at_rest()));
}

TEST_P(EveryLaw, RefusesWhatIsNoContact) {
  WheelContact contact = with_creepages(1e-3, 0, 0);
  contact.a = -1;
  if (GetParam() != "shen_hedrick_elkins") { // a formula, which takes anything
    EXPECT_THROW(make_creep_law(GetParam())->forces(contact), std::runtime_error);
  }
}

INSTANTIATE_TEST_SUITE_P(Dytsi, EveryLaw, testing::ValuesIn(creep_law_names()),
                         [](const auto& law) { return law.param; });

TEST(DytsiCreepLaw, ShenHedrickElkinsIsItsFormula) {
  const WheelContact contact = with_creepages(3e-4, 5e-4, -0.05);
  const double stiffness = contact.shear_modulus * contact.a * contact.b;
  const double x = stiffness * contact.c11 * 3e-4;
  const double y = stiffness * (contact.c22 * 5e-4 - std::sqrt(contact.a * contact.b) * contact.c23 * 0.05);
  const double u = std::sqrt(x * x + y * y) / bound(contact);
  ASSERT_LT(u, 3);
  const double force = bound(contact) * (u - u * u / 3 + u * u * u / 27);
  const CreepForces found = make_creep_law("shen_hedrick_elkins")->forces(contact);
  EXPECT_NEAR(std::hypot(found.longitudinal, found.lateral), force, 1e-9 * force);
  EXPECT_NEAR(found.longitudinal * y, found.lateral * x, 1e-9 * force * std::hypot(x, y));
}

TEST(DytsiCreepLaw, ForcesAreThoseOfTheLibrary) {
  const WheelContact contact = with_creepages(3e-4, 5e-4, -0.05);
  const microslip_contact same = {.a = contact.a,
                                  .b = contact.b,
                                  .shear_modulus = contact.shear_modulus,
                                  .poisson_ratio = 0.27,
                                  .normal_force = contact.normal_force,
                                  .rolling_speed = 60,
                                  .creepage_longitudinal = 3e-4,
                                  .creepage_lateral = 5e-4,
                                  .spin = -0.05,
                                  .friction = contact.friction,
                                  .friction_law = MICROSLIP_COULOMB,
                                  .friction_drop = {},
                                  .friction_half_velocity = {}};
  microslip_fastsim2* solver = nullptr;
  microslip_error error;
  ASSERT_EQ(microslip_fastsim2_create(nullptr, &solver, &error), MICROSLIP_OK);
  microslip_forces expected;
  ASSERT_EQ(microslip_fastsim2_solve(solver, 1, &same, &expected), MICROSLIP_OK);
  microslip_fastsim2_destroy(solver);
  const CreepForces fastsim2 = make_creep_law("fastsim2")->forces(contact);
  EXPECT_EQ(fastsim2.longitudinal, expected.fx);
  EXPECT_EQ(fastsim2.lateral, expected.fy);
  const CreepForces table = make_creep_law("table")->forces(contact), exact = make_creep_law("exact")->forces(contact);
  EXPECT_NEAR(table.longitudinal, exact.longitudinal, 0.003 * bound(contact));
  EXPECT_NEAR(table.lateral, exact.lateral, 0.003 * bound(contact));
}

TEST(DytsiCreepLaw, ReplacesForcesByThoseOfTheLawInUse) {
  const WheelContact contact = with_creepages(3e-4, 5e-4, -0.05);
  double forces[2] = {1, 2};
  use_creep_law(nullptr, 0);
  replace_creep_forces(contact, forces);
  EXPECT_EQ(forces[0], 1);
  EXPECT_EQ(forces[1], 2);
  use_creep_law(make_creep_law("fastsim2"), 1.438e11);
  replace_creep_forces(contact, forces);
  WheelContact stiffer = contact;
  stiffer.shear_modulus = 1.438e11;
  const CreepForces expected = make_creep_law("fastsim2")->forces(stiffer);
  EXPECT_EQ(forces[0], expected.longitudinal);
  EXPECT_EQ(forces[1], expected.lateral);
  use_creep_law(nullptr, 0);
}

TEST(DytsiCreepLaw, RefusesAnUnknownNameWithThoseThatThereAre) {
  try {
    make_creep_law("polach");
    FAIL();
  } catch (const std::invalid_argument& error) {
    for (const std::string& name : creep_law_names())
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
  }
}

} // namespace
