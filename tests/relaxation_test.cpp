#include "microslip/elasticity/relaxation.hpp"

#include "tests/support/expect_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace microslip {
namespace {

const PronySeries series = {{0.2, 1e-3}, {0.3, 5.0}, {0.25, 0.04}, {0.1, 0.05}, {0.01, 700}};

TEST(Relaxation, CreepIsItsInverseAtEveryFrequency) {
  for (const PronySeries& s : {series, PronySeries{{0.999, 2}}, PronySeries{{1e-6, 2}}, PronySeries{}})
    for (const double omega : {0.0, 1e-4, 0.3, 4.0, 25.0, 1e3, 1e6, -7.0}) {
      std::complex<double> compliance = 1;
      for (const MaterialCreep& creep : creep_of(s))
        compliance += creep.ratio / std::complex<double>(1, omega * creep.time);
      EXPECT_LT(std::abs(compliance * relative_modulus(s, omega) - 1.0), 1e-12) << omega;
    }
}

TEST(Relaxation, AStandardLinearSolidHasItsCreepInClosedForm) {
  const double f = 1.7, time = 0.3; // relaxes by f/(1 + f) with the time tau/(1 + f)
  const std::vector<MaterialCreep> creep = creep_of({{f / (1 + f), time / (1 + f)}});
  ASSERT_EQ(creep.size(), 1U);
  EXPECT_NEAR(creep[0].ratio, f, 1e-14);
  EXPECT_NEAR(creep[0].time, time, 1e-15);
}

TEST(Relaxation, RetardationTimesLieBetweenRelaxationTimes) {
  const double times[] = {1e-3, 0.04, 0.05, 5, 700, INFINITY};
  const std::vector<MaterialCreep> creep = creep_of(series);
  ASSERT_EQ(creep.size(), series.size());
  for (std::size_t k = 0; k < creep.size(); ++k) {
    EXPECT_GT(creep[k].time, times[k]);
    EXPECT_LT(creep[k].time, times[k + 1]);
    EXPECT_GT(creep[k].ratio, 0);
  }
}

TEST(Relaxation, TermsOfOneTimeAreOneTerm) {
  const std::vector<MaterialCreep> two = creep_of({{0.2, 3}, {0.3, 3}}), one = creep_of({{0.5, 3}});
  ASSERT_EQ(two.size(), 1U);
  EXPECT_NEAR(two[0].ratio, one[0].ratio, 1e-15);
  EXPECT_NEAR(two[0].time, one[0].time, 1e-14);
}

TEST(Relaxation, LimitsAreTheInstantaneousAndTheRelaxedModulus) {
  EXPECT_NEAR(relative_modulus(series, 0).real(), 1 - 0.86, 1e-15);
  EXPECT_NEAR(std::abs(relative_modulus(series, 1e12)), 1, 1e-9);
}

TEST(Relaxation, BadTermsAreErrors) {
  const auto with = [](const PronySeries& s) { return [s] { check("shear_relaxation", s); }; };
  expect_error(with({{0.1, 1}, {-0.1, 1}}), "shear_relaxation[1].share", "[-]: must be positive and finite");
  expect_error(with({{0.1, 0}}), "shear_relaxation[0].time", "[s]: must be positive and finite");
  expect_error(with({{0.1, std::nan("")}}), "shear_relaxation[0].time", "[s]: must be positive and finite");
  expect_error(with({{0.5, 1}, {0.5, 2}}), "sum of shear_relaxation.share", "[-]: must be below 1");
}

} // namespace
} // namespace microslip
