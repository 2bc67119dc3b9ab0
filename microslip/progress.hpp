#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

namespace microslip {

/// Called now and then by long work with the fraction done, 0 to 1. Returning false asks the work to stop.
using Progress = std::function<bool(double fraction)>;

/// The fraction done of an iteration whose residual was `first`, is `now` and has to fall to `goal`: of the digits.
inline double digits_done(double first, double now, double goal) {
  return goal > 0 && now < first ? std::min(1.0, std::log(first / now) / std::log(first / goal)) : 0;
}

} // namespace microslip
