#include "microslip/numerics/dual_angles.hpp"

#include "microslip/numerics/lanes.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Number = Dual<double, 2>;

/// A function of (x, y) with its exact partial derivatives.
struct Known {
  const char* text;
  Number (*of)(const Number& x, const Number& y);
  double (*to_x)(double x, double y);
  double (*to_y)(double x, double y);
};

const std::vector<Known> functions = {
    {"x + y", [](auto& x, auto& y) { return x + y; }, [](double, double) { return 1.0; },
     [](double, double) { return 1.0; }},
    {"x - y", [](auto& x, auto& y) { return x - y; }, [](double, double) { return 1.0; },
     [](double, double) { return -1.0; }},
    {"-x", [](auto& x, auto&) { return -x; }, [](double, double) { return -1.0; }, [](double, double) { return 0.0; }},
    {"x y", [](auto& x, auto& y) { return x * y; }, [](double, double y) { return y; },
     [](double x, double) { return x; }},
    {"x/y", [](auto& x, auto& y) { return x / y; }, [](double, double y) { return 1 / y; },
     [](double x, double y) { return -x / (y * y); }},
    {"2 + x", [](auto& x, auto&) { return 2.0 + x; }, [](double, double) { return 1.0; },
     [](double, double) { return 0.0; }},
    {"2 x", [](auto& x, auto&) { return 2.0 * x; }, [](double, double) { return 2.0; },
     [](double, double) { return 0.0; }},
    {"x 2", [](auto& x, auto&) { return x * 2.0; }, [](double, double) { return 2.0; },
     [](double, double) { return 0.0; }},
    {"2/y", [](auto&, auto& y) { return 2.0 / y; }, [](double, double) { return 0.0; },
     [](double, double y) { return -2 / (y * y); }},
    {"x/2", [](auto& x, auto&) { return x / 2.0; }, [](double, double) { return 0.5; },
     [](double, double) { return 0.0; }},
    {"x - 2", [](auto& x, auto&) { return x - 2.0; }, [](double, double) { return 1.0; },
     [](double, double) { return 0.0; }},
    {"sqrt(x x + y y)", [](auto& x, auto& y) { return sqrt(x * x + y * y); },
     [](double x, double y) { return x / std::hypot(x, y); }, [](double x, double y) { return y / std::hypot(x, y); }},
    {"abs(x) y", [](auto& x, auto& y) { return abs(x) * y; }, [](double x, double y) { return x < 0 ? -y : y; },
     [](double x, double) { return std::abs(x); }},
    {"2^(x y)", [](auto& x, auto& y) { return exp2(x * y); },
     [](double x, double y) { return y * std::log(2.0) * std::exp2(x * y); },
     [](double x, double y) { return x * std::log(2.0) * std::exp2(x * y); }},
    {"x += y x",
     [](auto& x, auto& y) {
       Number sum = x;
       sum += y * x;
       return sum;
     },
     [](double, double y) { return 1 + y; }, [](double x, double) { return x; }},
};

TEST(Dual, CarriesTheExactDerivatives) {
  for (const Known& f : functions)
    for (const double x : {-3.7, -0.2, 1.1})
      for (const double y : {0.3, 2.5}) {
        SCOPED_TRACE(f.text);
        const Number value = f.of(Number::variable(x, 0), Number::variable(y, 1));
        EXPECT_DOUBLE_EQ(value.partial[0], f.to_x(x, y));
        EXPECT_DOUBLE_EQ(value.partial[1], f.to_y(x, y));
      }
}

TEST(Dual, HasTheValueOfPlainArithmetic) {
  const Number x = Number::variable(-3.7, 0), y = Number::variable(0.3, 1);
  EXPECT_EQ((x + y).value, -3.7 + 0.3);
  EXPECT_EQ((x - y).value, -3.7 - 0.3);
  EXPECT_EQ((x * y).value, -3.7 * 0.3);
  EXPECT_EQ((x / y).value, -3.7 / 0.3);
  EXPECT_EQ((2.0 / y).value, 2 / 0.3);
  EXPECT_EQ(sqrt(y).value, std::sqrt(0.3));
  EXPECT_EQ(abs(x).value, 3.7);
  EXPECT_EQ(exp2(x).value, std::exp2(-3.7));
  EXPECT_EQ(value_of(x), -3.7);
}

TEST(Dual, AnglesCarryTheExactDerivatives) {
  for (const double angle : {-2.5, -0.3, 0.7, 3.0}) {
    const Number a = Number::variable(angle, 0), r = Number::variable(1.7, 1);
    EXPECT_EQ(sin(a).value, std::sin(angle));
    EXPECT_EQ(cos(a).value, std::cos(angle));
    EXPECT_DOUBLE_EQ(sin(a).partial[0], std::cos(angle));
    EXPECT_DOUBLE_EQ(cos(a).partial[0], -std::sin(angle));
    const Number back = atan2(r * sin(a), r * cos(a));
    EXPECT_NEAR(back.value, angle, 1e-15);
    EXPECT_NEAR(back.partial[0], 1, 1e-15);
    EXPECT_NEAR(back.partial[1], 0, 1e-15);
    const Number slope = Number::variable(angle / 4, 0);
    EXPECT_DOUBLE_EQ(asin(slope).value, std::asin(angle / 4));
    EXPECT_NEAR(asin(slope).partial[0], 1 / std::sqrt(1 - angle * angle / 16), 1e-14);
  }
}

TEST(Dual, OfAConstantHasNoDerivative) {
  const Number constant(4.0);
  for (const Number& f : {constant, sqrt(constant), constant * constant, exp2(constant), constant / 3.0}) {
    EXPECT_EQ(f.partial[0], 0);
    EXPECT_EQ(f.partial[1], 0);
  }
}

/// x^7 by repeated products, differentiated through every one of them.
TEST(Dual, FollowsALoop) {
  Number power(1.0);
  for (int k = 0; k < 7; ++k) power = power * Number::variable(1.3, 1);
  EXPECT_DOUBLE_EQ(power.partial[1], 7 * std::pow(1.3, 6));
  EXPECT_EQ(power.partial[0], 0);
}

/// What is not chosen may be infinite or not a number, as beyond a guarded division: nothing of it comes through.
TEST(Dual, SelectTakesValueAndDerivativesFromTheSameSide) {
  using Vector = Lanes<double, 2>;
  using VectorDual = Dual<Vector, 1>;
  const double values[] = {-1, 0, 4, 9};
  double value[4], slope[4];
  for (const int first : {0, 2}) {
    const VectorDual x = VectorDual::variable(Vector::load(values + first), 0);
    const VectorDual root = select(Vector(0.0) < x.value, sqrt(x), VectorDual(Vector(7.0)));
    root.value.store(value + first);
    root.partial[0].store(slope + first);
  }
  const double expected_value[] = {7, 7, 2, 3}, expected_slope[] = {0, 0, 1. / 4, 1. / 6};
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(value[k], expected_value[k]);
    EXPECT_DOUBLE_EQ(slope[k], expected_slope[k]);
  }
}

} // namespace
} // namespace microslip
