#include "microslip/numerics/not_a_knot_spline.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace microslip {

/// The end conditions m_0 = ((h_0 + h_1) m_1 - h_0 m_2)/h_1 are put into the first and the last of the inner equations.
void not_a_knot_spline(std::span<const double> h, std::span<const double> values, std::span<double> second) {
  const std::size_t n = values.size();
  std::fill(second.begin(), second.end(), 0);
  if (n < 3) return;
  const auto slope = [&](std::size_t k) { return (values[k + 1] - values[k]) / h[k]; };
  if (n == 3) {
    std::fill(second.begin(), second.end(), 2 * (slope(1) - slope(0)) / (h[0] + h[1]));
    return;
  }
  std::vector<double> pivot(n), upper(n);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    double lower = h[k - 1], diagonal = 2 * (h[k - 1] + h[k]);
    upper[k] = h[k];
    if (k == 1) {
      diagonal += h[0] * (h[0] + h[1]) / h[1];
      upper[k] -= h[0] * h[0] / h[1];
      lower = 0;
    }
    if (k + 2 == n) {
      diagonal += h[k] * (h[k] + h[k - 1]) / h[k - 1];
      lower -= h[k] * h[k] / h[k - 1];
    }
    const double factor = k > 1 ? lower / pivot[k - 1] : 0;
    pivot[k] = diagonal - factor * (k > 1 ? upper[k - 1] : 0);
    second[k] = 6 * (slope(k) - slope(k - 1)) - factor * (k > 1 ? second[k - 1] : 0);
  }
  second[n - 2] /= pivot[n - 2];
  for (std::size_t k = n - 2; k-- > 1;) second[k] = (second[k] - upper[k] * second[k + 1]) / pivot[k];
  second[0] = ((h[0] + h[1]) * second[1] - h[0] * second[2]) / h[1];
  second[n - 1] = ((h[n - 2] + h[n - 3]) * second[n - 2] - h[n - 2] * second[n - 3]) / h[n - 3];
}

} // namespace microslip
