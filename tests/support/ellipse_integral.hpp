#pragma once

#include <cmath>
#include <numbers>

namespace microslip {

/// Integral over the ellipse (x/a)^2 + (y/b)^2 <= 1, on curves where 1 - (x/a)^2 - (y/b)^2 = w^2: exact for polynomials
/// of degree below 3 in w, for which Simpson's rule is.
template <class Function> double integral_over_ellipse(double a, double b, const Function& value) {
  constexpr int n = 20;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    const double w = static_cast<double>(i) / n;
    const double simpson = (i == 0 || i == n ? 1 : i % 2 == 0 ? 2 : 4) / (3.0 * n);
    const double r = std::sqrt(1 - w * w);
    for (int j = 0; j < n; ++j) {
      const double theta = (j + 0.5) * 2 * std::numbers::pi / n;
      sum += value(a * r * std::cos(theta), b * r * std::sin(theta)) * w * simpson;
    }
  }
  return sum * a * b * 2 * std::numbers::pi / n;
}

} // namespace microslip
