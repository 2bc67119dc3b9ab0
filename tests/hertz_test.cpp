#include "microslip/elasticity/hertz.hpp"

#include "tests/support/ellipse_integral.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace microslip {
namespace {

using std::numbers::pi;

/// What a misfit may be; leaves room for machines whose long double is no better than double.
constexpr double fit = 1e-13;

/// a/b from needle to needle, with the circle and its close neighbours.
constexpr std::array axis_ratios = {1e-4,      3e-4,     1e-3, 0.01, 0.1, 0.2,  0.5,   0.9, 1 - 1e-9, 1.0,
                                    1 + 1e-15, 1 + 1e-9, 1.1,  2.0,  5.0, 10.0, 100.0, 1e3, 3e3,      1e4};

double relative_error(double value, double expected) {
  return std::abs(value - expected) / std::abs(expected);
}

void expect_same(const HertzContact& one, const HertzContact& other, double tolerance) {
  EXPECT_LT(relative_error(one.a, other.a), tolerance);
  EXPECT_LT(relative_error(one.b, other.b), tolerance);
  EXPECT_LT(relative_error(one.normal_force, other.normal_force), tolerance);
  EXPECT_LT(relative_error(one.approach, other.approach), tolerance);
  EXPECT_LT(relative_error(one.peak_pressure, other.peak_pressure), tolerance);
  EXPECT_LT(relative_error(one.stiffness, other.stiffness), tolerance);
  EXPECT_LT(relative_error(one.gap.x, other.gap.x), tolerance);
  EXPECT_LT(relative_error(one.gap.y, other.gap.y), tolerance);
}

/// The surface displacement u_n at a point of the ellipse, straight from Boussinesq's u = 1/(pi E*) integral of p/r:
/// along a line through the point, p is a half ellipse over the chord, whose area is known; what is left is an integral
/// over the direction of the line, done in extended precision by the trapezoidal rule in u, tan(phi) = exp(u).
long double displacement(const HertzContact& contact, double modulus, long double x, long double y) {
  const long double a = contact.a, b = contact.b;
  const long double depth = 1 - (x / a) * (x / a) - (y / b) * (y / b);
  const long double h = 0.2L;
  long double sum = 0;
  for (int i = -300; i <= 300; ++i) {
    const long double t = std::exp(i * h);
    const long double c2 = 1 / (1 + t * t), s2 = t * t * c2;
    const long double gamma = c2 / (a * a) + s2 / (b * b);
    const long double beta2 = x * x * c2 / (a * a * a * a) + y * y * s2 / (b * b * b * b);
    sum += h * t * c2 * (depth + beta2 / gamma) / std::sqrt(gamma);
  }
  const long double peak = 1.5L * contact.normal_force / (std::numbers::pi_v<long double> * a * b);
  return peak / modulus * sum;
}

/// Largest relative misfit of u = delta - A x^2 - B y^2 in the centre, at the ends of both axes and between them, each
/// coefficient alone.
double misfit(const HertzContact& contact, double modulus) {
  const double a = contact.a, b = contact.b;
  const long double centre = displacement(contact, modulus, 0, 0);
  const long double end_x = displacement(contact, modulus, a, 0);
  const long double end_y = displacement(contact, modulus, 0, b);
  const long double inside = displacement(contact, modulus, 0.3L * a, 0.6L * b);
  const auto A = static_cast<double>((centre - end_x) / a / a);
  const auto B = static_cast<double>((centre - end_y) / b / b);
  const auto approach = static_cast<double>(inside + 0.09L * contact.gap.x * a * a + 0.36L * contact.gap.y * b * b);
  return std::max({relative_error(contact.approach, static_cast<double>(centre)),
                   relative_error(contact.approach, approach), relative_error(contact.gap.x, A),
                   relative_error(contact.gap.y, B)});
}

TEST(Hertz, PressureFlattensTheGapFromEllipse) {
  double worst = 0;
  for (const double ratio : axis_ratios) {
    const HertzContact contact = hertz_from_ellipse(0.004 * ratio, 0.004, steel, 82e3);
    const double error = misfit(contact, steel.contact_modulus());
    EXPECT_LT(error, fit) << "a/b = " << ratio;
    worst = std::max(worst, error);
  }
  RecordProperty("worst_relative_error", std::to_string(worst * 1e15) + "e-15");
}

TEST(Hertz, PressureFlattensTheGapFromLoad) {
  double worst = 0;
  for (int i = -68; i <= 68; ++i) {
    const GapCurvatures gap{.x = 0.7 * std::pow(10, i / 8.0), .y = 0.7};
    const HertzContact contact = hertz_from_load(gap, steel, 82e3);
    EXPECT_EQ(contact.gap.x, gap.x);
    EXPECT_EQ(contact.gap.y, gap.y);
    EXPECT_EQ(contact.normal_force, 82e3);
    const double error = misfit(contact, steel.contact_modulus());
    EXPECT_LT(error, fit) << "A/B = " << gap.x / gap.y;
    worst = std::max(worst, error);
  }
  RecordProperty("worst_relative_error", std::to_string(worst * 1e15) + "e-15");
}

TEST(Hertz, PressureFlattensTheGapFromApproach) {
  for (int i = -17; i <= 17; ++i) {
    const GapCurvatures gap{.x = 0.7 * std::pow(10, i / 2.0), .y = 0.7};
    const HertzContact contact = hertz_from_approach(gap, steel, 5e-5);
    EXPECT_EQ(contact.approach, 5e-5);
    EXPECT_LT(misfit(contact, steel.contact_modulus()), fit) << "A/B = " << gap.x / gap.y;
  }
}

TEST(Hertz, ThereAndBackIsTheSame) {
  for (const double ratio : axis_ratios) {
    SCOPED_TRACE(ratio);
    const HertzContact contact = hertz_from_ellipse(0.003 * std::sqrt(ratio), 0.003 / std::sqrt(ratio), steel, 5e4);
    expect_same(hertz_from_load(contact.gap, steel, contact.normal_force), contact, 1e-14);
    expect_same(hertz_from_approach(contact.gap, steel, contact.approach), contact, 1e-14);
  }
}

TEST(Hertz, SphereOnFlat) {
  // Johnson 1985, equations (4.22)-(4.24).
  const double radius = 0.46, force = 80e3, modulus = steel.contact_modulus();
  const GapCurvatures gap = gap_curvatures({radius, infinity, radius, infinity});
  const HertzContact contact = hertz_from_load(gap, steel, force);
  const double a = std::cbrt(3 * force * radius / (4 * modulus));
  EXPECT_EQ(contact.a, contact.b);
  EXPECT_LT(relative_error(contact.a, a), 4e-15);
  EXPECT_LT(relative_error(contact.approach, a * a / radius), 4e-15);
  EXPECT_LT(relative_error(contact.peak_pressure, std::cbrt(6 * force * modulus * modulus / (radius * radius)) / pi),
            4e-15);
}

TEST(Hertz, CrossedEqualCylindersAreASphereOnFlat) {
  const HertzContact crossed = hertz_from_load(gap_curvatures({0.3, infinity, infinity, 0.3}), steel, 1e4);
  expect_same(crossed, hertz_from_load(gap_curvatures({0.3, infinity, 0.3, infinity}), steel, 1e4), 4e-15);
}

TEST(Hertz, NearlyCircular) {
  // ln(A/B) = -3/2 ln(a/b) to second order in the distance from the circle.
  for (const double distance : {1e-9, 1e-7, 1e-5}) {
    const HertzContact contact = hertz_from_load({.x = 1, .y = 1 + distance}, steel, 1e4);
    EXPECT_NEAR((contact.a - contact.b) / contact.b, distance / 1.5, distance * distance + 1e-15);
  }
}

TEST(Hertz, SlenderEllipseIsALineContact) {
  for (const double ratio : {1e-3, 1e-4}) {
    const HertzContact contact = hertz_from_ellipse(0.01 * ratio, 0.01, steel, 1e3);
    const LineContact line = line_contact_from_half_width(contact.gap.x, steel, contact.a);
    EXPECT_LT(relative_error(contact.peak_pressure, line.peak_pressure), 10 * ratio * ratio);
    EXPECT_GT(relative_error(contact.peak_pressure, line.peak_pressure), ratio * ratio);
  }
}

TEST(Hertz, RadiiOfTheStandardCases) {
  // The five ellipses of the 3,220-case set: rho = 2/(A + B), published to seven digits.
  struct Case {
    double ratio, a, rho;
  };
  for (const auto& [ratio, a, rho] : {Case{0.2, 0.004, 1.772185}, Case{0.5, 0.006, 2.075275}, Case{1, 0.009, 2.7},
                                      Case{2, 0.012, 2.075275}, Case{5, 0.02, 1.772185}}) {
    const HertzContact contact = hertz_from_ellipse(a, a / ratio, steel, 82e3);
    EXPECT_NEAR(2 / (contact.gap.x + contact.gap.y), rho, 0.6e-6) << "a/b = " << ratio;
  }
  EXPECT_NEAR(hertz_from_ellipse(0.004, 0.02, steel, 82e3).approach, 5.18e-5, 0.5e-7);
}

TEST(Hertz, LoadGrowsWithApproachToThePowerThreeHalves) {
  const GapCurvatures gap{.x = 1.1, .y = 0.02};
  const HertzContact one = hertz_from_approach(gap, steel, 1e-5);
  const HertzContact four = hertz_from_approach(gap, steel, 4e-5);
  EXPECT_LT(relative_error(four.normal_force, 8 * one.normal_force), 4e-15);
  EXPECT_LT(relative_error(four.a, 2 * one.a), 4e-15);
  EXPECT_LT(relative_error(four.stiffness, 2 * one.stiffness), 4e-15);
}

TEST(Hertz, StiffnessIsTheSlopeOfTheLoad) {
  for (const double ratio : {1e-4, 0.3, 1.0, 7.0, 1e4}) {
    const HertzContact contact = hertz_from_ellipse(0.004 * ratio, 0.004, steel, 82e3);
    const double h = 1e-4 * contact.approach;
    const double above = hertz_from_approach(contact.gap, steel, contact.approach + h).normal_force;
    const double below = hertz_from_approach(contact.gap, steel, contact.approach - h).normal_force;
    EXPECT_LT(relative_error((above - below) / (2 * h), contact.stiffness), 1e-9);
  }
}

TEST(Hertz, UnitsDoNotMatter) {
  // Metres and newtons to millimetres and newtons: by powers of two, so that only the algorithm could make a
  // difference.
  const double length = 1024, stress = 1.0 / (1024.0 * 1024.0);
  const CombinedMaterial scaled{
      .shear_modulus = steel.shear_modulus * stress, .poisson_ratio = 0.28, .dissimilarity = 0};
  for (const double q : {1e-6, 0.01, 0.6, 1.0, 30.0}) {
    const HertzContact contact = hertz_from_load({.x = q, .y = 1}, steel, 82e3);
    const HertzContact other = hertz_from_load({.x = q / length, .y = 1 / length}, scaled, 82e3);
    EXPECT_DOUBLE_EQ(other.a, contact.a * length);
    EXPECT_DOUBLE_EQ(other.b, contact.b * length);
    EXPECT_DOUBLE_EQ(other.approach, contact.approach * length);
    EXPECT_DOUBLE_EQ(other.peak_pressure, contact.peak_pressure * stress);
    EXPECT_DOUBLE_EQ(other.stiffness, contact.stiffness / length);
  }
}

TEST(Hertz, AxesCanBeSwapped) {
  for (const double ratio : axis_ratios) {
    const HertzContact one = hertz_from_ellipse(0.004 * ratio, 0.004, steel, 82e3);
    const HertzContact other = hertz_from_ellipse(0.004, 0.004 * ratio, steel, 82e3);
    EXPECT_EQ(one.gap.x, other.gap.y);
    EXPECT_EQ(one.gap.y, other.gap.x);
    EXPECT_EQ(one.approach, other.approach);
    const HertzContact back = hertz_from_load({.x = other.gap.x, .y = other.gap.y}, steel, 82e3);
    const HertzContact swapped = hertz_from_load({.x = other.gap.y, .y = other.gap.x}, steel, 82e3);
    EXPECT_EQ(back.a, swapped.b);
    EXPECT_EQ(back.b, swapped.a);
    EXPECT_EQ(back.approach, swapped.approach);
  }
}

TEST(Hertz, LongAxisLiesAlongTheSmallCurvature) {
  EXPECT_GT(hertz_from_load({.x = 0.1, .y = 1}, steel, 1e4).a, hertz_from_load({.x = 0.1, .y = 1}, steel, 1e4).b);
  EXPECT_LT(hertz_from_load({.x = 1, .y = 0.1}, steel, 1e4).a, hertz_from_load({.x = 1, .y = 0.1}, steel, 1e4).b);
}

TEST(Hertz, RandomContactsFitTheirGap) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> exponent(-3, 3);
  for (int i = 0; i < 300; ++i) {
    const GapCurvatures gap{.x = std::pow(10, exponent(random)), .y = std::pow(10, exponent(random))};
    const CombinedMaterial material{
        .shear_modulus = 1e8 * std::pow(10, exponent(random)), .poisson_ratio = 0.5, .dissimilarity = 0};
    const HertzContact contact = hertz_from_load(gap, material, 1e3 * std::pow(10, exponent(random)));
    EXPECT_LT(misfit(contact, material.contact_modulus()), fit);
  }
}

TEST(Hertz, PressureCarriesTheLoad) {
  const HertzContact contact = hertz_from_ellipse(0.004, 0.02, steel, 82e3);
  const double force =
      integral_over_ellipse(contact.a, contact.b, [&](double x, double y) { return contact.pressure(x, y); });
  EXPECT_LT(relative_error(force, 82e3), 1e-13);
  EXPECT_EQ(contact.pressure(0, 0), contact.peak_pressure);
  EXPECT_EQ(contact.pressure(contact.a, 0), 0);
  EXPECT_EQ(contact.pressure(0, -contact.b), 0);
  EXPECT_EQ(contact.pressure(contact.a, contact.b), 0);
  EXPECT_EQ(contact.pressure(infinity, 0), 0);
}

TEST(GapCurvatures, AreHalfTheSumsOfTheBodiesCurvatures) {
  const GapCurvatures gap =
      gap_curvatures({.rolling1 = 0.46, .rolling2 = infinity, .transverse1 = -0.5, .transverse2 = 0.3});
  EXPECT_DOUBLE_EQ(gap.x, 0.5 / 0.46);
  EXPECT_DOUBLE_EQ(gap.y, (1 / 0.3 - 2) / 2);
  EXPECT_DOUBLE_EQ(gap_curvatures({-infinity, 0.4, infinity, 0.2}).x, 1.25);
  EXPECT_DOUBLE_EQ(gap_curvatures({1e308, 0.4, 0.2, -1e308}).x, 1.25);
  EXPECT_DOUBLE_EQ(gap_curvatures({1e308, 0.4, 0.2, -1e308}).y, 2.5);
}

TEST(GapCurvatures, NearlyConformingRadiiLoseNothing) {
  // (R2 - R1)/(2 R1 R2) with R1 = 1/2, R2 = 1/2 + 2^-30: the sum of the curvatures would lose nine digits.
  const double difference = std::ldexp(1.0, -30);
  const GapCurvatures gap = gap_curvatures({1, infinity, 0.5, -(0.5 + difference)});
  EXPECT_DOUBLE_EQ(gap.y, difference / (0.5 + difference));
}

TEST(LineContact, MatchesTheClosedForm) {
  // Johnson 1985, equations (4.43)-(4.45), for a roller of radius R on a flat.
  const double radius = 0.5, modulus = steel.contact_modulus(), force = 178.9e3;
  const LineContact contact = line_contact_from_load(1 / (2 * radius), steel, force);
  EXPECT_LT(relative_error(contact.half_width, std::sqrt(4 * force * radius / (pi * modulus))), 4e-15);
  EXPECT_LT(relative_error(contact.peak_pressure, std::sqrt(force * modulus / (pi * radius))), 4e-15);
}

TEST(LineContact, CartersExample) {
  // A published case: R = 500 mm, half-width 1 mm, 178.90 N/mm, 113.9 N/mm2.
  const LineContact contact = line_contact_from_half_width(1, steel, 1e-3);
  EXPECT_NEAR(contact.force_per_length, 178.90e3, 0.005e3);
  EXPECT_NEAR(contact.peak_pressure, 113.9e6, 0.05e6);
}

TEST(LineContact, ThereAndBackIsTheSame) {
  const LineContact contact = line_contact_from_load(1.7, steel, 3e5);
  const LineContact back = line_contact_from_half_width(1.7, steel, contact.half_width);
  EXPECT_LT(relative_error(back.force_per_length, 3e5), 4e-15);
  EXPECT_LT(relative_error(back.peak_pressure, contact.peak_pressure), 4e-15);
}

TEST(LineContact, PressureCarriesTheLoad) {
  const LineContact contact = line_contact_from_load(1.7, steel, 3e5);
  double force = 0;
  const int n = 2000;
  for (int i = 0; i < n; ++i) {
    const double t = -pi / 2 + (i + 0.5) / n * pi;
    force += contact.pressure(contact.half_width * std::sin(t)) * contact.half_width * std::cos(t) * pi / n;
  }
  EXPECT_LT(relative_error(force, 3e5), 1e-12);
  EXPECT_EQ(contact.pressure(contact.half_width), 0);
  EXPECT_EQ(contact.pressure(-2 * contact.half_width), 0);
}

TEST(Hertz, RefusesLoadsAndShapesThatMakeNoSense) {
  const GapCurvatures gap{.x = 1, .y = 2};
  for (const double bad : {0.0, -1.0, infinity, nan}) {
    const std::string positive = "must be positive and finite";
    expect_error([&] { hertz_from_load(gap, steel, bad); }, "normal_force", "[N]: " + positive);
    expect_error([&] { hertz_from_approach(gap, steel, bad); }, "approach", "[m]: " + positive);
    expect_error([&] { hertz_from_load({.x = bad, .y = 1}, steel, 1); }, "gap.x", "[1/m]: " + positive);
    expect_error([&] { hertz_from_load({.x = 1, .y = bad}, steel, 1); }, "gap.y", "[1/m]: " + positive);
    expect_error([&] { hertz_from_approach({.x = 1, .y = bad}, steel, 1); }, "gap.y", "[1/m]: " + positive);
    expect_error([&] { hertz_from_ellipse(bad, 1, steel, 1); }, "a", "[m]: " + positive);
    expect_error([&] { hertz_from_ellipse(1, bad, steel, 1); }, "b", "[m]: " + positive);
    expect_error([&] { hertz_from_ellipse(1, 1, steel, bad); }, "normal_force", "[N]: " + positive);
    expect_error([&] { line_contact_from_load(bad, steel, 1); }, "curvature", "[1/m]: " + positive);
    expect_error([&] { line_contact_from_load(1, steel, bad); }, "force_per_length", "[N/m]: " + positive);
    expect_error([&] { line_contact_from_half_width(bad, steel, 1); }, "curvature", "[1/m]: " + positive);
    expect_error([&] { line_contact_from_half_width(1, steel, bad); }, "half_width", "[m]: " + positive);
  }
}

TEST(Hertz, RefusesMaterialsThatMakeNoSense) {
  for (const double bad : {0.0, -1.0, infinity, nan}) {
    const CombinedMaterial material{.shear_modulus = bad, .poisson_ratio = 0.3, .dissimilarity = 0};
    expect_error([&] { hertz_from_load({.x = 1, .y = 1}, material, 1); }, "shear_modulus", "[Pa]: must be positive");
    expect_error([&] { hertz_from_ellipse(1, 1, material, 1); }, "shear_modulus", "[Pa]: must be positive");
    expect_error([&] { line_contact_from_load(1, material, 1); }, "shear_modulus", "[Pa]: must be positive");
  }
  for (const double bad : {-0.01, 0.51, infinity, nan}) {
    const CombinedMaterial material{.shear_modulus = 1, .poisson_ratio = bad, .dissimilarity = 0};
    expect_error([&] { hertz_from_approach({.x = 1, .y = 1}, material, 1); }, "poisson_ratio",
                 "[-]: must be in [0, 0.5]");
    expect_error([&] { line_contact_from_half_width(1, material, 1); }, "poisson_ratio", "[-]: must be in [0, 0.5]");
  }
}

TEST(Hertz, RefusesEllipsesThatAreLines) {
  for (const double ratio : {1e-6, 1e6}) {
    expect_error([&] { hertz_from_ellipse(0.01 * ratio, 0.01, steel, 1e4); }, "a/b", "[-]: must be in [1e-05, 1e+05]");
  }
  for (const double ratio : {1e-12, 1e12}) {
    expect_error([&] { hertz_from_load({.x = ratio, .y = 1}, steel, 1e4); }, "gap.x/gap.y",
                 "[-]: must be in [1e-09, 1e+09]");
    expect_error([&] { hertz_from_approach({.x = ratio, .y = 1}, steel, 1e-5); }, "gap.x/gap.y",
                 "[-]: must be in [1e-09, 1e+09]");
  }
  // Every ellipse that is accepted gives curvatures that are accepted.
  for (const double ratio : {1e-5, 1e5}) {
    const HertzContact contact = hertz_from_ellipse(0.01 * ratio, 0.01, steel, 1e4);
    expect_same(hertz_from_load(contact.gap, steel, 1e4), contact, 1e-12);
  }
}

TEST(Hertz, RefusesWhatLeavesTheRangeOfNumbers) {
  expect_error([&] { hertz_from_ellipse(1e-200, 1e-200, steel, 1e4); }, "approach", "[m]: must be positive");
  expect_error([&] { hertz_from_approach({.x = 1e300, .y = 1e300}, steel, 1e-300); }, "a", "[m]: must be positive");
  expect_error([&] { line_contact_from_half_width(1, steel, 1e-200); }, "force_per_length", "[N/m]: must be positive");
}

TEST(GapCurvatures, RefusesRadiiThatGiveNoEllipse) {
  for (const double bad : {0.0, nan}) {
    expect_error([&] { gap_curvatures({bad, 1, 1, 1}); }, "rolling1", "[m]: must be positive, negative");
    expect_error([&] { gap_curvatures({1, bad, 1, 1}); }, "rolling2", "[m]: must be positive, negative");
    expect_error([&] { gap_curvatures({1, 1, bad, 1}); }, "transverse1", "[m]: must be positive, negative");
    expect_error([&] { gap_curvatures({1, 1, 1, bad}); }, "transverse2", "[m]: must be positive, negative");
  }
  // Flat on flat, a hollow closer than the hump, and a hollow that fits exactly.
  expect_error([&] { gap_curvatures({infinity, infinity, 1, 1}); }, "(1/rolling1 + 1/rolling2)/2", "[1/m]: must be");
  expect_error([&] { gap_curvatures({1, 1, -0.2, 0.3}); }, "(1/transverse1 + 1/transverse2)/2", "[1/m]: must be");
  expect_error([&] { gap_curvatures({1, 1, -0.3, 0.3}); }, "(1/transverse1 + 1/transverse2)/2", "[1/m]: must be");
}

} // namespace
} // namespace microslip
