#pragma once

#include <algorithm>
#include <limits>

namespace microslip {

/// An interval of numbers and what arithmetic makes of it: every operation encloses all results, to rounding.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity(); ///< empty unless at least low

  static Range between(double a, double b) { return {std::min(a, b), std::max(a, b)}; }
  bool holds(double value) const { return low <= value && value <= high; }
  bool meets(const Range& o) const { return low <= o.high && o.low <= high; }
  double width() const { return high - low; }

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void include(const Range& o) {
    low = std::min(low, o.low);
    high = std::max(high, o.high);
  }

  friend Range operator+(const Range& a, const Range& b) { return {a.low + b.low, a.high + b.high}; }
  friend Range operator+(const Range& a, double b) { return {a.low + b, a.high + b}; }
  friend Range operator-(const Range& a, const Range& b) { return {a.low - b.high, a.high - b.low}; }
  friend Range operator*(const Range& a, const Range& b) {
    const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
    return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
  }
  friend Range operator*(double f, const Range& a) { return between(f * a.low, f * a.high); }
  /// b must not hold 0.
  friend Range operator/(const Range& a, const Range& b) { return a * Range{1 / b.high, 1 / b.low}; }
};

} // namespace microslip
