// Roots in a bracket: of smooth functions in few evaluations, of any function in no more than bisection and one more.

#include "microslip/numerics/bracketed_root.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace microslip {
namespace {

struct Counted {
  BracketedRoot root;
  int evaluations = 0;
};

Counted find(double low, double high, double tolerance, double precision, const std::function<double(double)>& f) {
  Counted out;
  out.root = find_bracketed_root({low, f(low)}, {high, f(high)}, tolerance, precision, [&](double x) {
    ++out.evaluations;
    return f(x);
  });
  return out;
}

TEST(BracketedRoot, OfASmoothFunctionTakesFewEvaluations) {
  const auto [root, evaluations] = find(0, 2, 1e-12, 1e-14, [](double x) { return x * x * x - 2; });
  EXPECT_TRUE(root.found);
  EXPECT_NEAR(root.side.at, std::cbrt(2), 1e-12);
  EXPECT_LE(evaluations, 12);
}

TEST(BracketedRoot, FindsFallingFunctionsAndReversedEnds) {
  const auto f = [](double x) { return std::cos(x); };
  for (const auto& [low, high] : {std::pair{0.0, 3.0}, std::pair{3.0, 0.0}}) {
    const auto [root, evaluations] = find(low, high, 1e-13, 1e-14, f);
    EXPECT_TRUE(root.found);
    EXPECT_NEAR(root.side.at, std::acos(0), 1e-12);
  }
}

/// Flat over most of the bracket, where false position and its kin creep.
TEST(BracketedRoot, NeverTakesMoreThanBisectionAndOneMore) {
  constexpr double precision = 0x1p-40;
  for (const double power : {9.0, 31.0, 101.0}) {
    const auto [root, evaluations] =
        find(-1, 1, 0, precision, [=](double x) { return std::copysign(std::pow(std::abs(x + 0.3), power), x + 0.3); });
    EXPECT_LE(evaluations, 41 + 1 + 1) << power;                                           // the nearer side again
    EXPECT_TRUE(root.found || std::abs(root.side.at + 0.3) <= precision * 1.001) << power; // powers underflow
  }
}

TEST(BracketedRoot, ClosesInOnAJumpAndTakesItsNearerSide) {
  const auto [root, evaluations] = find(0, 1, 1e-6, 1e-12, [](double x) { return x < 0.7 ? -2.0 : 0.5; });
  EXPECT_FALSE(root.found);
  EXPECT_EQ(root.side.value, 0.5);
  EXPECT_NEAR(root.side.at, 0.7, 1e-12);
}

TEST(BracketedRoot, TakesNoNumberAsAValue) {
  const auto [root, evaluations] = find(0, 1, 1e-6, 1e-12, [](double x) {
    return x < 0.3 ? -1.0 : x < 0.6 ? std::nan("") : 1.0;
  });
  EXPECT_FALSE(root.found);
  EXPECT_NEAR(root.side.at, 0.3, 1e-12);
  EXPECT_EQ(root.side.value, -1);
}

TEST(BracketedRoot, IsFoundNearbyWithoutABracket) {
  for (const double start : {-3.0, 0.2, 5.0}) {
    const auto f = [](double x) { return 0.7 - x - 0.1 * x * x * x; };
    const auto found = find_root_nearby(start, 0.01, -10, 10, 1e-13, f);
    ASSERT_TRUE(found && found->found) << start;
    EXPECT_NEAR(f(found->side.at), 0, 1e-13);
  }
  const auto at_start = find_root_nearby(1, 0.01, 0, 2, 1e-6, [](double x) { return 1 - x; });
  ASSERT_TRUE(at_start);
  EXPECT_EQ(at_start->side.at, 1);
}

TEST(BracketedRoot, IsNotFoundNearbyWhereTheFunctionHasOneSign) {
  int evaluations = 0;
  const auto f = [&](double x) {
    ++evaluations;
    return 3 - x;
  };
  EXPECT_FALSE(find_root_nearby(1, 0.01, 0, 2, 1e-6, f));
  EXPECT_LT(evaluations, 12);
}

} // namespace
} // namespace microslip
