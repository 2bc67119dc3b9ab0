#pragma once

#include "microslip/numerics/dual.hpp"

#include <cmath>

namespace microslip {

/// Functions of angles [rad].
template <int N> Dual<double, N> sin(const Dual<double, N>& a) {
  return chain(a, std::sin(a.value), std::cos(a.value));
}
template <int N> Dual<double, N> cos(const Dual<double, N>& a) {
  return chain(a, std::cos(a.value), -std::sin(a.value));
}
template <int N> Dual<double, N> asin(const Dual<double, N>& a) {
  return chain(a, std::asin(a.value), 1 / std::sqrt((1 - a.value) * (1 + a.value)));
}
template <int N> Dual<double, N> atan2(const Dual<double, N>& y, const Dual<double, N>& x) {
  const double square = x.value * x.value + y.value * y.value;
  return Dual<double, N>::combine(std::atan2(y.value, x.value),
                                  [&](int k) { return (x.value * y.partial[k] - y.value * x.partial[k]) / square; });
}

} // namespace microslip
