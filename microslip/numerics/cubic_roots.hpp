#pragma once

#include <array>
#include <span>

namespace microslip {

/// Zeros in an interval, ascending; at most three.
struct CubicRoots {
  std::array<double, 3> value{};
  int count = 0;

  const double* begin() const { return value.data(); }
  const double* end() const { return value.data() + count; }
};

/// The zeros of c0 + c1 t + c2 t^2 + c3 t^3 in [low, high], each once, to the rounding of the polynomial. Between
/// neighbouring extrema, which the quadratic formula gives, the polynomial is monotone: a zero is where its sign
/// changes, or where it is exactly zero at an end. A polynomial that vanishes everywhere has none. Cost some 10 steps
/// of Newton's method a zero.
CubicRoots cubic_roots(const std::array<double, 4>& c, double low, double high);

} // namespace microslip
