#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

namespace microslip {

/// Returns true for equality to the last bit; NaN equals itself.
inline bool same_bits(double one, double other) {
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}
inline bool same_bits(std::span<const double> one, std::span<const double> other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](double x, double y) { return same_bits(x, y); });
}

} // namespace microslip
