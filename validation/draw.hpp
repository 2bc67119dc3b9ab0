#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace microslip::validation {

/// Random numbers that are the same with every standard library.
class Draw {
public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  double number(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  double power(double low, double high) { return std::exp(number(std::log(low), std::log(high))); }
  int count(int low, int high) { return low + static_cast<int>(number(0, 1) * (high - low + 1)); }
  bool chance(double share) { return number(0, 1) < share; }
  /// Normally distributed, of deviation 1 (Box and Muller 1958).
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - number(0, 1)));
    return radius * std::cos(2 * std::numbers::pi * number(0, 1));
  }
  double sign() { return chance(0.5) ? 1 : -1; }

private:
  std::mt19937_64 engine_;
};

} // namespace microslip::validation
