#pragma once

#include <algorithm>
#include <type_traits>

namespace microslip {

/// Precision of a calculation.
enum class Precision { full, single };

/// to = factor from, in the precision of `to`, which holds as many numbers.
template <class From, class To> void convert(const From& from, double factor, To&& to) {
  using Real = typename std::remove_cvref_t<To>::value_type;
  std::transform(from.begin(), from.end(), to.begin(),
                 [factor](double value) { return static_cast<Real>(factor * value); });
}

} // namespace microslip
