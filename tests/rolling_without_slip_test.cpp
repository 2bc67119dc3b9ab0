#include "validation/rolling_without_slip.hpp"

#include "tests/support/expect_error.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace microslip::validation {
namespace {

constexpr double ratios[] = {0.1, 0.4, 1, 2, 8};
constexpr double materials[] = {0, 0.2, 0.35, 0.5};

/// Betti's theorem for rolling to and fro. Nothing in the series knows of it.
TEST(RollingWithoutSlip, SpinForceAndTurningMomentAreReciprocal) {
  for (const double ratio : ratios)
    for (const double nu : materials) {
      const LinearCoefficients c = rolling_without_slip(ratio, nu, 32);
      EXPECT_NEAR(c.c32 / c.c23, -1, 2e-4) << ratio << " " << nu;
    }
}

TEST(RollingWithoutSlip, DoesNotKnowTheDirectionAtPoissonsRatioZero) {
  for (const double ratio : ratios) {
    const LinearCoefficients c = rolling_without_slip(ratio, 0, 16);
    EXPECT_NEAR(c.c11 / c.c22, 1, 1e-10);
  }
}

TEST(RollingWithoutSlip, ConvergesFast) {
  for (const double ratio : {0.5, 1.0, 2.0})
    for (const double nu : materials) {
      const LinearCoefficients coarse = rolling_without_slip(ratio, nu, 8),
                               middle = rolling_without_slip(ratio, nu, 16), fine = rolling_without_slip(ratio, nu, 32);
      for (const auto c :
           {&LinearCoefficients::c11, &LinearCoefficients::c22, &LinearCoefficients::c23, &LinearCoefficients::c33}) {
        const double exact = fine.*c;
        EXPECT_LT(std::abs(coarse.*c / exact - 1), 1e-3);
        EXPECT_LT(std::abs(middle.*c / exact - 1), 5e-5);
      }
    }
}

/// Strips across the rolling direction roll by themselves: plane strain and anti-plane shear.
TEST(RollingWithoutSlip, WideEllipsesRollAsStrips) {
  const double strip = std::numbers::pi * std::numbers::pi / 4;
  for (const double nu : materials) {
    const LinearCoefficients wide = rolling_without_slip(0.02, nu, 48), wider = rolling_without_slip(0.01, nu, 48);
    EXPECT_NEAR(wider.c11 * (1 - nu) / strip, 1, 2e-3);
    EXPECT_NEAR(wider.c22 / strip, 1, 2e-3);
    EXPECT_LT(std::abs(wider.c11 * (1 - nu) - strip), std::abs(wide.c11 * (1 - nu) - strip));
    EXPECT_LT(std::abs(wider.c22 - strip), std::abs(wide.c22 - strip));
  }
}

TEST(RollingWithoutSlip, RejectsWhatItCannotSolve) {
  expect_error([] { rolling_without_slip(0, 0.25, 16); }, "a_over_b", "[-]: must be");
  expect_error([] { rolling_without_slip(1, 0.6, 16); }, "poisson_ratio", "[-]: must be");
  expect_error([] { rolling_without_slip(1, 0.25, 1); }, "degree", "must be");
}

} // namespace
} // namespace microslip::validation
