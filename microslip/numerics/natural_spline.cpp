#include "microslip/numerics/natural_spline.hpp"

#include <cstddef>
#include <vector>

namespace microslip {

void natural_spline(std::span<const double> steps, std::span<const double> values, std::span<double> second) {
  const std::size_t last = values.size() - 1;
  std::vector<double> factor(values.size());
  second.front() = second.back() = 0;
  const auto slope = [&](std::size_t k) { return (values[k + 1] - values[k]) / steps[k]; };
  for (std::size_t k = 1; k < last; ++k) {
    const double pivot = 2 * (steps[k - 1] + steps[k]) - steps[k - 1] * factor[k - 1];
    factor[k] = steps[k] / pivot;
    second[k] = (6 * (slope(k) - slope(k - 1)) - steps[k - 1] * second[k - 1]) / pivot;
  }
  for (std::size_t k = last; k-- > 1;) second[k] -= factor[k] * second[k + 1];
}

} // namespace microslip
