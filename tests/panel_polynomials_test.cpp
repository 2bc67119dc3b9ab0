#include "microslip/numerics/panel_polynomials.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace microslip {
namespace {

template <class One, class Two> PanelPolynomials two_functions(double from, double to, double width, One one, Two two) {
  return {from, to, width, 2, [&](std::span<const double, PanelPolynomials::nodes> at, std::span<double> values) {
            for (std::size_t k = 0; k < at.size(); ++k) values[2 * k] = one(at[k]), values[2 * k + 1] = two(at[k]);
          }};
}

TEST(PanelPolynomials, ReproduceTheirDegree) {
  const auto one = [](double t) { return std::pow(t, 11) - 3 * t; };
  const auto two = [](double t) { return 5 - t * t; };
  const PanelPolynomials panels = two_functions(-1, 2, 0.7, one, two);
  double values[2];
  for (double t = -1; t <= 2; t += 0.01) {
    panels.evaluate(t, values);
    EXPECT_NEAR(values[0], one(t), 1e-12 * (1 + std::pow(std::abs(t), 11)));
    EXPECT_NEAR(values[1], two(t), 1e-13);
  }
}

TEST(PanelPolynomials, ErrorsOfAnalyticFunctionsKeepToTheirBound) {
  // 1/(1 + t^2) has poles at the distance 1: rho of panels of half width 1/4 is 8.1, rho^-12 is 1e-11.
  const auto pole = [](double t) { return 1 / (1 + t * t); };
  const PanelPolynomials panels = two_functions(-2, 3, 0.5, pole, [](double t) { return std::cos(t); });
  double values[2];
  for (double t = -2; t <= 3; t += 0.003) {
    panels.evaluate(t, values);
    EXPECT_NEAR(values[0], pole(t), 1e-10);
    EXPECT_NEAR(values[1], std::cos(t), 1e-14);
  }
}

TEST(PanelPolynomials, StayAsAtTheirEndsBeyondThem) {
  const auto line = [](double t) { return t; };
  const PanelPolynomials panels = two_functions(1, 2, 0.25, line, line);
  double values[2];
  panels.evaluate(-7, values);
  EXPECT_NEAR(values[0], 1, 1e-14);
  panels.evaluate(9, values);
  EXPECT_NEAR(values[1], 2, 1e-14);
}

} // namespace
} // namespace microslip
