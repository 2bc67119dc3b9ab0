#include "microslip/numerics/gauss_legendre.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace microslip {
namespace {

TEST(GaussLegendre, IntegratesPolynomialsUpToTwiceItsNodes) {
  for (const int n : {1, 2, 3, 6, 16, 24}) {
    const GaussLegendre rule(n);
    for (int power = 0; power < 2 * n; ++power) {
      double sum = 0;
      for (std::size_t k = 0; k < rule.count(); ++k) sum += rule.weight(k, 1, 3) * std::pow(rule.node(k, 1, 3), power);
      EXPECT_NEAR(sum * (power + 1) / (std::pow(3, power + 1) - 1), 1, 2e-14) << n << " nodes, power " << power;
    }
  }
}

TEST(GaussLegendre, NodesAscendWithinTheInterval) {
  const GaussLegendre rule(16);
  double before = -2;
  for (std::size_t k = 0; k < rule.count(); ++k) {
    EXPECT_GT(rule.node(k, -2, 5), before);
    before = rule.node(k, -2, 5);
  }
  EXPECT_LT(before, 5);
}

} // namespace
} // namespace microslip
