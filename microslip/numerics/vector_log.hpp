#pragma once

#include "microslip/numerics/bits.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace microslip {

/// ln v for normal numbers v > 0, to 2 units in the last digit of the larger of |ln v| and 1/2. Without branches and
/// calls: the compiler vectorises loops over it with any instruction set.
inline double vector_log(double v) {
  // v = 2^k m with m from sqrt(1/2) to sqrt(2), by the bits: those of sqrt(1/2), less the exponent's bias, come off.
  constexpr std::uint64_t lowest = bit_cast<std::uint64_t>(std::numbers::sqrt2 / 2), bias = 1023, mantissa = 52;
  constexpr double count = 0x1p52; // with integers below this as its last bits, 2^52 is the greater by them
  const auto bits = bit_cast<std::uint64_t>(v);
  const std::uint64_t shifted = (bits - lowest + (bias << mantissa)) >> mantissa;
  const double k = bit_cast<double>(shifted | bit_cast<std::uint64_t>(count)) - (count + double(bias));
  const double m = bit_cast<double>(bits - ((shifted - bias) << mantissa));
  // ln m = 2 artanh s = 2 (s + s^3/3 + s^5/5 + ...), |s| < 0.172; s itself comes last, and as f - s f, which is exact
  // near m = 1.
  const double f = m - 1, s = f / (m + 1), z = s * s;
  double rest = 2.0 / 21;
#pragma GCC unroll 16
  for (int n = 19; n >= 3; n -= 2) rest = rest * z + 2.0 / n;
  return k * std::numbers::ln2 + (f - s * (f - z * rest));
}

} // namespace microslip
