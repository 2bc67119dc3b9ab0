#pragma once

#include <limits>
#include <vector>

namespace microslip {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// `count` numbers at equal distances, from the first to the last.
inline std::vector<double> equal_steps(double first, double last, int count) {
  std::vector<double> all;
  for (int k = 0; k < count; ++k) all.push_back(first + (last - first) * k / (count - 1));
  return all;
}

} // namespace microslip
