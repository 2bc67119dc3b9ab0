#pragma once

#include <algorithm>

namespace microslip {

/// 1 up to low, 0 from high, with continuous slope.
inline double fade(double value, double low, double high) {
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return 1 - t * t * (3 - 2 * t);
}

} // namespace microslip
