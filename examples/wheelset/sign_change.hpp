#pragma once

#include <stdexcept>

/// Where a function of the speed changes from negative to positive [m/s], to `accuracy`.
template <class Function> double sign_change(double low, double high, double accuracy, Function function) {
  if (!(function(low) < 0 && function(high) > 0)) throw std::runtime_error("no change of stability between the speeds");
  while (high - low > accuracy) {
    const double middle = (low + high) / 2;
    (function(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}
