#include "microslip/friction/friction_law.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace microslip {
namespace {

/// The makers of laws that fall with the slip velocity.
constexpr auto falling = {FrictionLaw::linear, FrictionLaw::rational, FrictionLaw::exponential};

struct NamedLaw {
  std::string name;
  FrictionLaw law;
  double limit; ///< at infinite slip velocity
};

std::vector<NamedLaw> falling_laws() {
  const FrictionTerm first{.drop = 0.12, .half_velocity = 0.4}, second{.drop = 0.05, .half_velocity = 3};
  return {{"linear", FrictionLaw::linear(0.2, first, second), 0.2},
          {"rational", FrictionLaw::rational(0.2, first, second), 0.2},
          {"exponential", FrictionLaw::exponential(0.2, first, second), 0.2},
          {"one term", FrictionLaw::exponential(0, first), 0},
          {"Polach", FrictionLaw::polach(0.4, 0.3, 0.6), 0.12}};
}

TEST(FrictionLaw, IsFrictionlessUnlessToldOtherwise) {
  EXPECT_EQ(FrictionLaw().coefficient(0.0), 0);
  EXPECT_EQ(FrictionLaw().coefficient(2.0), 0);
}

TEST(FrictionLaw, CoulombDoesNotDependOnTheVelocity) {
  const FrictionLaw law = FrictionLaw::coulomb(0.3);
  for (const double v : {0.0, 1e-9, 1.0, 1e9, infinity}) EXPECT_EQ(law.coefficient(v), 0.3);
  EXPECT_EQ(law.static_coefficient(), 0.3);
  EXPECT_EQ(law.kinetic_coefficient(), 0.3);
  EXPECT_EQ(law.kind(), FrictionLaw::Kind::coulomb);
}

TEST(FrictionLaw, IsMadeByItsKindAsByItsName) {
  const FrictionTerm first{.drop = 0.12, .half_velocity = 0.4}, second{.drop = 0.05, .half_velocity = 3};
  ASSERT_EQ(std::size_t{FrictionLaw::falling}, falling.size());
  EXPECT_EQ(FrictionLaw::make(FrictionLaw::Kind::coulomb, 0.2, first, second).coefficient(1.0), 0.2);
  auto kind = static_cast<int>(FrictionLaw::Kind::coulomb);
  for (const auto make : falling) {
    const FrictionLaw law = FrictionLaw::make(static_cast<FrictionLaw::Kind>(++kind), 0.2, first, second);
    EXPECT_EQ(static_cast<int>(law.kind()), kind);
    EXPECT_EQ(law.coefficient(1.0), make(0.2, first, second).coefficient(1.0));
  }
}

TEST(FrictionLaw, StartsAtTheStaticAndEndsAtTheKineticCoefficient) {
  for (const auto& [name, law, limit] : falling_laws()) {
    SCOPED_TRACE(name);
    EXPECT_EQ(law.coefficient(0.0), law.static_coefficient());
    EXPECT_DOUBLE_EQ(law.coefficient(infinity), limit);
    EXPECT_DOUBLE_EQ(law.kinetic_coefficient(), limit);
  }
}

TEST(FrictionLaw, NeverRises) {
  for (const auto& [name, law, limit] : falling_laws()) {
    SCOPED_TRACE(name);
    double previous = law.coefficient(0.0);
    for (int i = -40; i < 80; ++i) {
      const double v = std::pow(10, i / 20.0);
      const double now = law.coefficient(v);
      EXPECT_LE(now, previous) << v;
      EXPECT_GE(now, limit - 1e-16) << v;
      previous = now;
    }
    EXPECT_LT(previous, law.static_coefficient());
  }
}

TEST(FrictionLaw, HalfOfATermIsLeftAtItsHalfVelocity) {
  // The other term is switched off, so that each is seen alone.
  const FrictionTerm none, term{.drop = 0.2, .half_velocity = 0.7};
  for (const auto make : falling) {
    EXPECT_DOUBLE_EQ(make(0.1, term, none).coefficient(0.7), 0.2);
    EXPECT_DOUBLE_EQ(make(0.1, none, term).coefficient(0.7), 0.2);
  }
}

TEST(FrictionLaw, MatchesItsFormula) {
  const FrictionTerm first{.drop = 0.12, .half_velocity = 0.4}, second{.drop = 0.05, .half_velocity = 3};
  for (const double v : {0.1, 0.79, 0.81, 2.0, 5.9, 6.1, 50.0}) {
    EXPECT_DOUBLE_EQ(FrictionLaw::linear(0.2, first, second).coefficient(v),
                     0.2 + (v < 0.8 ? 0.12 * (1 - v / 0.8) : 0) + (v < 6 ? 0.05 * (1 - v / 6) : 0));
    EXPECT_DOUBLE_EQ(FrictionLaw::rational(0.2, first, second).coefficient(v),
                     0.2 + 0.12 * 0.4 / (0.4 + v) + 0.05 * 9 / (9 + v * v));
    EXPECT_DOUBLE_EQ(FrictionLaw::exponential(0.2, first, second).coefficient(v),
                     0.2 + 0.12 * std::pow(0.5, v / 0.4) + 0.05 * std::pow(0.5, v / 3));
  }
}

TEST(FrictionLaw, PolachMatchesItsFormula) {
  for (const double ratio : {0.0, 0.4, 1.0}) {
    const FrictionLaw law = FrictionLaw::polach(0.55, ratio, 0.6);
    EXPECT_DOUBLE_EQ(law.static_coefficient(), 0.55);
    for (const double v : {0.0, 0.01, 0.5, 3.0, 20.0}) {
      const double expected = 0.55 * ((1 - ratio) * std::exp(-0.6 * v) + ratio);
      EXPECT_NEAR(law.coefficient(v), expected, 1e-14 * expected) << "A = " << ratio << ", v = " << v;
    }
  }
  EXPECT_EQ(FrictionLaw::polach(0.55, 0.4, 0.6).kind(), FrictionLaw::Kind::exponential);
}

TEST(FrictionLaw, LinearLawIsConstantBeyondTwiceItsHalfVelocity) {
  const FrictionLaw law = FrictionLaw::linear(0.25, {.drop = 0.1, .half_velocity = 1.5});
  EXPECT_EQ(law.coefficient(3.0), 0.25);
  EXPECT_EQ(law.coefficient(100.0), 0.25);
  EXPECT_GT(law.coefficient(2.999), 0.25);
}

TEST(FrictionLaw, UnitsOfVelocityDoNotMatter) {
  const FrictionLaw metres = FrictionLaw::rational(0.2, {.drop = 0.1, .half_velocity = 0.5});
  const FrictionLaw other = FrictionLaw::rational(0.2, {.drop = 0.1, .half_velocity = 512});
  for (const double v : {0.0, 0.3, 1.0, 7.0}) EXPECT_EQ(metres.coefficient(v), other.coefficient(1024 * v));
}

TEST(FrictionLaw, DerivativeIsTheSlope) {
  using Number = Dual<double, 1>;
  for (const auto& [name, law, limit] : falling_laws()) {
    SCOPED_TRACE(name);
    for (const double v : {0.05, 0.6, 4.0, 11.0}) {
      const double h = 1e-5;
      const double slope = (law.coefficient(v + h) - law.coefficient(v - h)) / (2 * h);
      const Number result = law.coefficient(Number::variable(v, 0));
      EXPECT_EQ(result.value, law.coefficient(v));
      EXPECT_NEAR(result.partial[0], slope, 1e-9);
    }
  }
}

TEST(FrictionLaw, ATableHasItsCoefficientsAndIsNoOtherKind) {
  const FrictionLaw law = FrictionLaw::table({{0.1, 1, 3}, {0.2, 0.4, 0.3}});
  EXPECT_EQ(law.kind(), FrictionLaw::Kind::table);
  for (const double v : {0.0, 0.5, 2.0, 3.0, infinity}) EXPECT_EQ(law.coefficient(v), law.table()->coefficient(v));
  EXPECT_EQ(law.static_coefficient(), 0.2);
  EXPECT_EQ(law.kinetic_coefficient(), 0.3);
  EXPECT_EQ(law.peak_coefficient(), 0.4);
  EXPECT_EQ(law.least_coefficient(), 0.2);
  EXPECT_EQ(FrictionLaw::linear(0.2, {.drop = 0.1, .half_velocity = 1}).table(), nullptr);
  EXPECT_EQ(FrictionLaw::linear(0.2, {.drop = 0.1, .half_velocity = 1}).peak_coefficient(), 0.2 + 0.1);
  EXPECT_NE(error_of([] { FrictionLaw::make(FrictionLaw::Kind::table, 0.2, {}); }).find("kind"), std::string::npos);
}

TEST(FrictionLaw, AcceptsTheEndsOfItsRanges) {
  EXPECT_EQ(FrictionLaw::coulomb(0).coefficient(1.0), 0);
  EXPECT_EQ(FrictionLaw::coulomb(10).coefficient(1.0), 10);
  EXPECT_EQ(FrictionLaw::polach(10, 0.3, 1).static_coefficient(), 10);
  EXPECT_EQ(FrictionLaw::linear(0, {.drop = 10, .half_velocity = 1}).static_coefficient(), 10);
}

TEST(FrictionLaw, RefusesCoefficientsOutOfRange) {
  const std::string range = "[-]: must be in [0, 10]";
  for (const double bad : {-0.1, 10.1, infinity, -infinity, nan}) {
    const FrictionTerm good{.drop = 0.1, .half_velocity = 1}, wrong{.drop = bad, .half_velocity = 1};
    expect_error([&] { FrictionLaw::coulomb(bad); }, "coefficient", range);
    expect_error([&] { FrictionLaw::polach(bad, 0.5, 1); }, "static_coefficient", range);
    for (const auto make : falling) {
      expect_error([&] { make(bad, good, good); }, "kinetic", range);
      expect_error([&] { make(0.2, wrong, good); }, "first.drop", range);
      expect_error([&] { make(0.2, good, wrong); }, "second.drop", range);
    }
  }
  expect_error([] { FrictionLaw::linear(6, {.drop = 5, .half_velocity = 1}); }, "kinetic + first.drop + second.drop",
               range);
}

TEST(FrictionLaw, RefusesVelocitiesOutOfRange) {
  for (const double bad : {0.0, -1.0, infinity, nan}) {
    const FrictionTerm good{.drop = 0.1, .half_velocity = 1}, wrong{.drop = 0.1, .half_velocity = bad};
    for (const auto make : falling) {
      expect_error([&] { make(0.2, wrong, good); }, "first.half_velocity", "[m/s]: must be positive and finite");
      expect_error([&] { make(0.2, good, wrong); }, "second.half_velocity", "[m/s]: must be positive and finite");
    }
    expect_error([&] { FrictionLaw::polach(0.4, 0.5, bad); }, "decay", "[s/m]: must be positive and finite");
  }
  expect_error([] { FrictionLaw::polach(0.4, 0.5, 1e-310); }, "ln(2)/decay", "[m/s]: must be positive and finite");
  for (const double bad : {-0.1, 1.1, infinity, nan}) {
    expect_error([&] { FrictionLaw::polach(0.4, bad, 1); }, "ratio", "[-]: must be in [0, 1]");
  }
}

} // namespace
} // namespace microslip
