#include "microslip/friction/traction_bound.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "tests/support/ellipse_integral.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace microslip {
namespace {

using std::numbers::pi;

constexpr auto shapes = {TractionBound::parabolic, TractionBound::elliptic};

double integral(TractionBound shape, double a, double b, double force, double friction) {
  return integral_over_ellipse(a, b,
                               [&](double x, double y) { return traction_bound(shape, a, b, force, friction, x, y); });
}

TEST(TractionBound, IntegratesToTheSlidingForce) {
  for (const auto shape : shapes) {
    for (const double a : {0.004, 0.02}) {
      for (const double mu : {0.0, 0.3, 1.2}) {
        EXPECT_NEAR(integral(shape, a, 0.01, 82e3, mu), mu * 82e3, 1e-13 * mu * 82e3);
      }
    }
  }
}

TEST(TractionBound, PeaksAreAsFourToThree) {
  const double parabolic = traction_bound(TractionBound::parabolic, 0.006, 0.012, 82e3, 0.3, 0, 0);
  const double elliptic = traction_bound(TractionBound::elliptic, 0.006, 0.012, 82e3, 0.3, 0, 0);
  EXPECT_DOUBLE_EQ(parabolic / elliptic, 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(parabolic, 0.3 * 2 * 82e3 / (pi * 0.006 * 0.012));
}

TEST(TractionBound, EllipticBoundIsFrictionTimesHertzsPressure) {
  const HertzContact contact = hertz_from_ellipse(0.004, 0.02, steel, 82e3);
  for (int i = -8; i <= 8; ++i) {
    for (int j = -8; j <= 8; ++j) {
      const double x = i * 0.0006, y = j * 0.003;
      EXPECT_NEAR(traction_bound(TractionBound::elliptic, 0.004, 0.02, 82e3, 0.3, x, y), 0.3 * contact.pressure(x, y),
                  1e-14 * contact.peak_pressure);
    }
  }
}

TEST(TractionBound, ParabolicBoundIsTheSquareOfTheEllipticOne) {
  const double peak_parabolic = traction_bound(TractionBound::parabolic, 0.006, 0.012, 82e3, 0.3, 0, 0);
  const double peak_elliptic = traction_bound(TractionBound::elliptic, 0.006, 0.012, 82e3, 0.3, 0, 0);
  for (const double x : {0.0, 0.001, -0.004, 0.0059}) {
    for (const double y : {0.0, 0.002, -0.009}) {
      const double p = traction_bound(TractionBound::parabolic, 0.006, 0.012, 82e3, 0.3, x, y) / peak_parabolic;
      const double e = traction_bound(TractionBound::elliptic, 0.006, 0.012, 82e3, 0.3, x, y) / peak_elliptic;
      EXPECT_NEAR(p, e * e, 1e-15);
    }
  }
}

TEST(TractionBound, VanishesOnAndBeyondTheEdge) {
  for (const auto shape : shapes) {
    EXPECT_EQ(traction_bound(shape, 0.5, 0.25, 1, 0.3, 0.5, 0), 0);
    EXPECT_EQ(traction_bound(shape, 0.5, 0.25, 1, 0.3, 0, -0.25), 0);
    EXPECT_EQ(traction_bound(shape, 0.5, 0.25, 1, 0.3, 0.4, 0.2), 0);
    EXPECT_EQ(traction_bound(shape, 0.5, 0.25, 1, 0.3, -7, 0), 0);
    EXPECT_EQ(traction_bound(shape, 0.5, 0.25, 1, 0.3, infinity, 0), 0);
    EXPECT_GT(traction_bound(shape, 0.5, 0.25, 1, 0.3, 0.499999, 0), 0);
  }
}

TEST(TractionBound, IsSymmetric) {
  for (const auto shape : shapes) {
    const double g = traction_bound(shape, 0.5, 0.25, 1, 0.3, 0.2, 0.1);
    EXPECT_EQ(traction_bound(shape, 0.5, 0.25, 1, 0.3, -0.2, 0.1), g);
    EXPECT_EQ(traction_bound(shape, 0.5, 0.25, 1, 0.3, 0.2, -0.1), g);
    EXPECT_DOUBLE_EQ(traction_bound(shape, 0.25, 0.5, 1, 0.3, 0.1, 0.2), g);
  }
}

TEST(TractionBound, RefusesWhatMakesNoSense) {
  const auto shape = TractionBound::parabolic;
  for (const double bad : {0.0, -1.0, infinity, nan}) {
    expect_error([&] { traction_bound(shape, bad, 1, 1, 0.3, 0, 0); }, "a", "[m]: must be positive and finite");
    expect_error([&] { traction_bound(shape, 1, bad, 1, 0.3, 0, 0); }, "b", "[m]: must be positive and finite");
    expect_error([&] { traction_bound(shape, 1, 1, bad, 0.3, 0, 0); }, "normal_force",
                 "[N]: must be positive and finite");
  }
  for (const double bad : {-0.1, 11.0, infinity, nan}) {
    expect_error([&] { traction_bound(shape, 1, 1, 1, bad, 0, 0); }, "friction", "[-]: must be in [0, 10]");
  }
}

} // namespace
} // namespace microslip
