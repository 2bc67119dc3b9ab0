// The cubic spline whose third derivative is continuous next to its ends.

#include "microslip/numerics/not_a_knot_spline.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

std::vector<double> second_derivatives(const std::vector<double>& x, const std::function<double(double)>& f) {
  std::vector<double> steps, values, second(x.size());
  for (std::size_t k = 1; k < x.size(); ++k) steps.push_back(x[k] - x[k - 1]);
  for (const double at : x) values.push_back(f(at));
  not_a_knot_spline(steps, values, second);
  return second;
}

TEST(NotAKnotSpline, ReproducesCubics) {
  const auto f = [](double x) { return 3 - x + 0.5 * x * x - 0.7 * x * x * x; };
  for (const std::vector<double>& x :
       {std::vector<double>{0, 0.3, 1.1, 1.5}, {-1, 0, 0.2, 0.9, 2}, {0, 1, 1.5, 2.5, 2.7, 4, 4.1}}) {
    const auto second = second_derivatives(x, f);
    for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(second[k], 1 - 4.2 * x[k], 1e-11) << x.size();
  }
}

TEST(NotAKnotSpline, OfFewValuesIsTheirPolynomial) {
  const auto f = [](double x) { return 1 + 2 * x + 3 * x * x; };
  for (const double m : second_derivatives({0, 0.5, 2}, f)) EXPECT_NEAR(m, 6, 1e-12);
  for (const double m : second_derivatives({0, 0.5}, f)) EXPECT_EQ(m, 0);
  for (const double m : second_derivatives({0.5}, f)) EXPECT_EQ(m, 0);
}

TEST(NotAKnotSpline, SecondDerivativesConvergeWithOrderTwo) {
  const auto error = [](int n) {
    std::vector<double> x;
    for (int k = 0; k <= n; ++k) x.push_back(3.0 * k / n);
    const auto second = second_derivatives(x, [](double t) { return std::sin(t); });
    double worst = 0;
    for (std::size_t k = 0; k < x.size(); ++k) worst = std::max(worst, std::abs(second[k] + std::sin(x[k])));
    return worst;
  };
  EXPECT_NEAR(std::log2(error(40) / error(80)), 2, 0.3);
}

} // namespace
} // namespace microslip
