#include "microslip/numerics/hankel_nodes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace microslip {
namespace {

/// Integral over k of f(k) J0(k r) and of f(k) J1(k r).
template <class Function> std::pair<double, double> transforms(double r_min, double r, double r_max, Function f) {
  std::pair<double, double> sum{};
  for (const auto& [k, weight] : hankel_nodes(r_min, r_max, 40)) {
    sum.first += weight * f(k) * ::j0(k * r);
    sum.second += weight * f(k) * ::j1(k * r);
  }
  return sum;
}

TEST(HankelNodes, TransformsOfAnExponentialAreThoseOfLipschitz) {
  for (const double r : {0.0, 1e-3, 0.1, 1.0, 3.3, 30.0, 1e3, 1e6}) {
    const auto [zero, one] = transforms(r / 1.4, r, 1.4 * r + 1e-3, [](double k) { return std::exp(-k); });
    const double distance = std::hypot(1, r);
    EXPECT_NEAR(zero * distance, 1, 1e-12) << r;
    EXPECT_NEAR(one, r / (distance * (1 + distance)), 1e-12 / distance) << r;
  }
}

TEST(HankelNodes, ResolveWhatChangesAtLongWaves) {
  // Exponentials of very different rates: 1e-4 of the longest distance, and a thousand times that.
  for (const double r : {1.0, 40.0, 1e4}) {
    const auto f = [](double k) { return std::exp(-k) + std::exp(-1e6 * k); };
    const auto [zero, one] = transforms(r / 1.4, r, 1.4 * r, f);
    EXPECT_NEAR(zero, 1 / std::hypot(1, r) + 1 / std::hypot(1e6, r), 1e-12 / std::hypot(1, r)) << r;
  }
}

TEST(HankelNodes, AreNoMoreAtALargerDistance) {
  EXPECT_EQ(hankel_nodes(1e3, 1.6e3, 40).size(), hankel_nodes(1e7, 1.6e7, 40).size());
  EXPECT_LT(hankel_nodes(1e3, 1.6e3, 40).size(), 1000U);
}

} // namespace
} // namespace microslip
