#pragma once

#include "microslip/numerics/inlined.hpp"

#include <utility>

namespace microslip {

/// Bytes of the widest registers of the instruction set that this is compiled for.
#if defined(__AVX512F__)
constexpr int register_size = 64;
#elif defined(__AVX2__)
constexpr int register_size = 32;
#else
constexpr int register_size = 16;
#endif

template <class Real, int width> struct LaneVectorType {
  typedef Real type __attribute__((vector_size(width * sizeof(Real)))); // NOLINT(modernize-use-using)
};
/// A vector register as g++ and clang have it: arithmetic of all lanes at once, as in `lanes.hpp`, and the exchange of
/// lanes between registers, which std::experimental::simd lacks.
template <class Real, int width> using LaneVector = typename LaneVectorType<Real, width>::type;

/// `width` numbers from memory of any alignment.
template <class Real, int width> MICROSLIP_INLINE LaneVector<Real, width> load_lanes(const Real* from) {
  LaneVector<Real, width> v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
template <class Real, int width> MICROSLIP_INLINE void store_lanes(const LaneVector<Real, width>& v, Real* to) {
  __builtin_memcpy(to, &v, sizeof v);
}

namespace detail {

template <class Real, int width, int apart, int... lane>
MICROSLIP_INLINE void exchange_lanes(LaneVector<Real, width>& a, LaneVector<Real, width>& b,
                                     std::integer_sequence<int, lane...>) {
  const LaneVector<Real, width> low =
      __builtin_shufflevector(a, b, ((lane & apart) != 0 ? width + lane - apart : lane)...);
  b = __builtin_shufflevector(a, b, ((lane & apart) != 0 ? width + lane : lane + apart)...);
  a = low;
}

} // namespace detail

/// Turns rows of a square into its columns: lane j of rows[i] becomes lane i of rows[j].
template <class Real, int width, int apart = 1> MICROSLIP_INLINE void transpose(LaneVector<Real, width>* rows) {
#pragma GCC unroll 16
  for (int i = 0; i < width; ++i)
    if ((i & apart) == 0)
      detail::exchange_lanes<Real, width, apart>(rows[i], rows[i + apart], std::make_integer_sequence<int, width>());
  if constexpr (2 * apart < width) transpose<Real, width, 2 * apart>(rows);
}

} // namespace microslip
