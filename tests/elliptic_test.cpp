#include "microslip/numerics/elliptic.hpp"

#include "microslip/error.hpp"
#include "tests/support/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace microslip {
namespace {

struct Reference {
  long double K = 0, E = 0, B = 0, D = 0, C = 0;
};

/// The integrals themselves in extended precision. With tan(phi) = exp(u) the trapezoidal rule converges like
/// exp(-pi^2/h) for every axis ratio g, because all branch points lie at Im u = +-pi/2.
Reference quadrature(double axis_ratio) {
  const long double g = axis_ratio;
  const long double h = 0.2L;
  const int end = static_cast<int>((50 - std::log(g)) / h);
  Reference sum;
  for (int i = static_cast<int>(-50 / h); i <= end; ++i) {
    const long double t = std::exp(i * h);
    const long double c2 = 1 / (1 + t * t), s2 = t * t * c2;
    const long double delta = std::sqrt(c2 + g * g * s2);
    const long double weight = h * t * c2;
    sum.K += weight / delta;
    sum.E += weight * delta;
    sum.B += weight * c2 / delta;
    sum.D += weight * s2 / delta;
    sum.C += weight * s2 * c2 / (delta * delta * delta);
  }
  return sum;
}

double relative_error(double value, long double reference) {
  return static_cast<double>(std::abs(value - reference) / std::abs(reference));
}

TEST(Elliptic, AgreesWithQuadratureFromCircleToNeedle) {
  double worst = 0;
  for (int i = 0; i <= 256; ++i) {
    const double g = std::pow(10, -i / 16.0);
    const EllipticIntegrals integrals = complete_elliptic_integrals(g);
    const Reference reference = quadrature(g);
    for (const double error : {relative_error(integrals.K, reference.K), relative_error(integrals.E, reference.E),
                               relative_error(integrals.B, reference.B), relative_error(integrals.D, reference.D),
                               relative_error(integrals.C, reference.C)}) {
      EXPECT_LT(error, 3e-15) << "g = " << g;
      worst = std::max(worst, error);
    }
  }
  RecordProperty("worst_relative_error", std::to_string(worst * 1e15) + "e-15");
}

TEST(Elliptic, AgreesWithQuadratureNearTheCircle) {
  for (const double distance : {1e-1, 1e-2, 1e-4, 1e-7, 1e-8, 1e-9, 1e-12, 1e-16}) {
    const double g = 1 - distance;
    const EllipticIntegrals integrals = complete_elliptic_integrals(g);
    const Reference reference = quadrature(g);
    EXPECT_LT(relative_error(integrals.K, reference.K), 3e-15) << "1 - g = " << distance;
    EXPECT_LT(relative_error(integrals.E, reference.E), 3e-15) << "1 - g = " << distance;
    EXPECT_LT(relative_error(integrals.B, reference.B), 3e-15) << "1 - g = " << distance;
    EXPECT_LT(relative_error(integrals.D, reference.D), 3e-15) << "1 - g = " << distance;
    EXPECT_LT(relative_error(integrals.C, reference.C), 3e-15) << "1 - g = " << distance;
  }
}

TEST(Elliptic, CircleIsExact) {
  const EllipticIntegrals integrals = complete_elliptic_integrals(1);
  EXPECT_DOUBLE_EQ(integrals.K, std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(integrals.E, std::numbers::pi / 2);
  EXPECT_EQ(integrals.B, integrals.D);
  EXPECT_DOUBLE_EQ(integrals.C, std::numbers::pi / 16);
}

TEST(Elliptic, LemniscateConstant) {
  // K(1/sqrt 2) = Gamma(1/4)^2/(4 sqrt pi).
  const double quarter_gamma = std::tgamma(0.25);
  const double expected = quarter_gamma * quarter_gamma / (4 * std::sqrt(std::numbers::pi));
  EXPECT_NEAR(complete_elliptic_integrals(std::numbers::sqrt2 / 2).K, expected, 3e-15 * expected);
}

TEST(Elliptic, LegendresRelation) {
  for (int i = 1; i < 50; ++i) {
    const double angle = i * std::numbers::pi / 100;
    const EllipticIntegrals one = complete_elliptic_integrals(std::cos(angle));
    const EllipticIntegrals other = complete_elliptic_integrals(std::sin(angle));
    EXPECT_NEAR(one.E * other.K + other.E * one.K - one.K * other.K, std::numbers::pi / 2, 1e-14);
  }
}

TEST(Elliptic, SlopesAreThoseStated) {
  for (const double g : {0.9, 0.5, 0.1, 1e-3}) {
    const double h = 1e-5;
    const EllipticIntegrals here = complete_elliptic_integrals(g);
    const EllipticIntegrals below = complete_elliptic_integrals(g * std::exp(-h));
    const EllipticIntegrals above = complete_elliptic_integrals(g * std::exp(h));
    EXPECT_NEAR((above.D - below.D) / (2 * h), here.C - here.D, 1e-9);
    EXPECT_NEAR((above.B - below.B) / (2 * h), -g * g * here.C, 1e-9);
  }
}

TEST(Elliptic, SlenderLimits) {
  // K -> ln(4/g), E -> 1, B -> 1, D -> ln(4/g) - 1, all with corrections of order g^2 ln g.
  const double g = 1e-100;
  const EllipticIntegrals integrals = complete_elliptic_integrals(g);
  EXPECT_NEAR(integrals.K, std::log(4 / g), 1e-12);
  EXPECT_NEAR(integrals.D, std::log(4 / g) - 1, 1e-12);
  EXPECT_NEAR(integrals.B, 1, 5e-15);
  EXPECT_NEAR(integrals.E, 1, 5e-15);
}

TEST(Elliptic, RefusesWhatIsNoAxisRatio) {
  for (const double g : {0.0, -0.5, 1.0000001, infinity, nan}) {
    EXPECT_THROW(complete_elliptic_integrals(g), Error) << g;
  }
}

} // namespace
} // namespace microslip
