#pragma once

#include "microslip/numerics/inlined.hpp"

#include <cmath>

namespace microslip {

/// A number with its derivatives with respect to N variables (forward mode). `Value` is double or Lanes. Comparisons
/// look at the value.
template <class Value, int N> struct Dual {
  Value value;
  Value partial[N];

  Dual() = default;
  MICROSLIP_INLINE Dual(const Value& constant) : value(constant) {
    for (int k = 0; k < N; ++k) partial[k] = Value(0.0);
  }

  /// The variable number k.
  static Dual variable(const Value& value, int k) {
    Dual d(value);
    d.partial[k] = Value(1.0);
    return d;
  }

  MICROSLIP_INLINE Dual& operator+=(const Dual& o) { return *this = *this + o; }

  MICROSLIP_INLINE friend Dual operator+(const Dual& a, const Dual& b) {
    return combine(a.value + b.value, [&](int k) { return a.partial[k] + b.partial[k]; });
  }
  MICROSLIP_INLINE friend Dual operator+(const Value& a, const Dual& b) {
    return combine(a + b.value, [&](int k) { return b.partial[k]; });
  }
  MICROSLIP_INLINE friend Dual operator-(const Dual& a, const Dual& b) {
    return combine(a.value - b.value, [&](int k) { return a.partial[k] - b.partial[k]; });
  }
  MICROSLIP_INLINE friend Dual operator-(const Dual& a, const Value& b) {
    return combine(a.value - b, [&](int k) { return a.partial[k]; });
  }
  MICROSLIP_INLINE friend Dual operator-(const Dual& a) {
    return combine(-a.value, [&](int k) { return -a.partial[k]; });
  }
  MICROSLIP_INLINE friend Dual operator*(const Dual& a, const Dual& b) {
    return combine(a.value * b.value, [&](int k) { return a.value * b.partial[k] + a.partial[k] * b.value; });
  }
  MICROSLIP_INLINE friend Dual operator*(const Dual& a, const Value& b) {
    return combine(a.value * b, [&](int k) { return a.partial[k] * b; });
  }
  MICROSLIP_INLINE friend Dual operator*(const Value& a, const Dual& b) { return b * a; }
  MICROSLIP_INLINE friend Dual operator/(const Dual& a, const Dual& b) {
    const Value inverse = Value(1.0) / b.value;
    const Value quotient = a.value / b.value;
    return combine(quotient, [&](int k) { return (a.partial[k] - quotient * b.partial[k]) * inverse; });
  }
  MICROSLIP_INLINE friend Dual operator/(const Value& a, const Dual& b) {
    const Value quotient = a / b.value;
    const Value slope = -(quotient / b.value);
    return combine(quotient, [&](int k) { return slope * b.partial[k]; });
  }

  /// Combines the value with a function that returns the derivative with respect to variable k.
  template <class Partial> MICROSLIP_INLINE static Dual combine(const Value& value, Partial partial) {
    Dual d;
    d.value = value;
    for (int k = 0; k < N; ++k) d.partial[k] = partial(k);
    return d;
  }
};

/// f(a) from its value and its slope f'(a).
template <class V, int N> MICROSLIP_INLINE Dual<V, N> chain(const Dual<V, N>& a, const V& value, const V& slope) {
  return Dual<V, N>::combine(value, [&](int k) { return slope * a.partial[k]; });
}

template <class V, int N> MICROSLIP_INLINE Dual<V, N> sqrt(const Dual<V, N>& a) {
  using std::sqrt;
  const V root = sqrt(a.value);
  return chain(a, root, V(0.5) / root);
}
template <int N> Dual<double, N> abs(const Dual<double, N>& a) {
  return chain(a, std::abs(a.value), a.value < 0 ? -1.0 : 1.0);
}
template <int N> Dual<double, N> exp2(const Dual<double, N>& a) {
  const double value = std::exp2(a.value);
  return chain(a, value, value * 0.69314718055994530942);
}

template <class Mask, class V, int N>
MICROSLIP_INLINE Dual<V, N> select(const Mask& mask, const Dual<V, N>& yes, const Dual<V, N>& no) {
  return Dual<V, N>::combine(select(mask, yes.value, no.value),
                             [&](int k) { return select(mask, yes.partial[k], no.partial[k]); });
}

/// The plain value of a number, dual or not.
inline double value_of(double a) {
  return a;
}
template <class V, int N> MICROSLIP_INLINE const V& value_of(const Dual<V, N>& a) {
  return a.value;
}

} // namespace microslip
