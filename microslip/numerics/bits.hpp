#pragma once

#include "microslip/numerics/inlined.hpp"

namespace microslip {

/// std::bit_cast, which the standard library of some clang 14 lacks.
template <class To, class From> MICROSLIP_INLINE constexpr To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

} // namespace microslip
