#pragma once

#include "microslip/numerics/inlined.hpp"
#include "microslip/numerics/lane_vector.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

/// The part of std::experimental::simd that the library needs, on the vector types of g++ and clang: for standard
/// libraries that have less of it.
namespace microslip::vector_simd {

struct ElementAligned {};
inline constexpr ElementAligned element_aligned;

/// A truth value for each of `count` numbers: all bits of its lane or none.
template <class Real, int count> struct Mask {
  using Bits = LaneVector<std::conditional_t<sizeof(Real) == sizeof(std::int64_t), std::int64_t, std::int32_t>, count>;
  Bits bits;

  Mask() = default;
  MICROSLIP_INLINE explicit Mask(bool value) : bits(Bits{} - (value ? 1 : 0)) {}
  MICROSLIP_INLINE explicit Mask(const Bits& values) : bits(values) {}

  MICROSLIP_INLINE friend Mask operator&&(const Mask& a, const Mask& b) { return Mask(a.bits & b.bits); }
  MICROSLIP_INLINE friend Mask operator||(const Mask& a, const Mask& b) { return Mask(a.bits | b.bits); }
  MICROSLIP_INLINE Mask operator!() const { return Mask(~bits); }
};

/// `count` numbers that the processor works on together.
template <class Real, int count> struct Simd {
  using value_type = Real;
  using mask_type = Mask<Real, count>;
  using Lanes = LaneVector<Real, count>;
  template <class Value> static constexpr bool is_stored_as = std::is_same_v<std::remove_const_t<Value>, Real>;

  Lanes lanes;

  static constexpr std::size_t size() { return count; }

  Simd() = default;
  template <class Value>
  requires std::is_arithmetic_v<Value> MICROSLIP_INLINE Simd(Value value) : lanes(Lanes{} + static_cast<Real>(value)) {}
  MICROSLIP_INLINE explicit Simd(const Lanes& values) : lanes(values) {}
  template <class Value, class Alignment> MICROSLIP_INLINE Simd(const Value* from, Alignment) {
    const auto values = load_lanes<Value, count>(from);
    if constexpr (is_stored_as<Value>)
      lanes = values;
    else
      lanes = __builtin_convertvector(values, Lanes);
  }
  template <class Value, class Alignment> MICROSLIP_INLINE void copy_to(Value* to, Alignment) const {
    using Stored = LaneVector<Value, count>;
    if constexpr (is_stored_as<Value>)
      store_lanes<Value, count>(lanes, to);
    else
      store_lanes<Value, count>(__builtin_convertvector(lanes, Stored), to);
  }

  MICROSLIP_INLINE Simd& operator+=(const Simd& o) { return *this = *this + o; }
  MICROSLIP_INLINE Simd& operator-=(const Simd& o) { return *this = *this - o; }

  MICROSLIP_INLINE friend Simd operator+(const Simd& a, const Simd& b) { return Simd(a.lanes + b.lanes); }
  MICROSLIP_INLINE friend Simd operator-(const Simd& a, const Simd& b) { return Simd(a.lanes - b.lanes); }
  MICROSLIP_INLINE friend Simd operator*(const Simd& a, const Simd& b) { return Simd(a.lanes * b.lanes); }
  MICROSLIP_INLINE friend Simd operator/(const Simd& a, const Simd& b) { return Simd(a.lanes / b.lanes); }
  MICROSLIP_INLINE friend Simd operator-(const Simd& a) { return Simd(-a.lanes); }
  MICROSLIP_INLINE friend mask_type operator<(const Simd& a, const Simd& b) { return mask_type(a.lanes < b.lanes); }
  MICROSLIP_INLINE friend mask_type operator<=(const Simd& a, const Simd& b) { return mask_type(a.lanes <= b.lanes); }
};

/// As many as the widest registers hold.
template <class Real> using native_simd = Simd<Real, register_size / static_cast<int>(sizeof(Real))>;
template <class Real, int count> using fixed_size_simd = Simd<Real, count>;

template <class Real, int count> MICROSLIP_INLINE Simd<Real, count> sqrt(Simd<Real, count> a) {
  for (int i = 0; i < count; ++i) a.lanes[i] = std::sqrt(a.lanes[i]);
  return a;
}
template <class Real, int count> MICROSLIP_INLINE Simd<Real, count> abs(Simd<Real, count> a) {
  for (int i = 0; i < count; ++i) a.lanes[i] = std::abs(a.lanes[i]);
  return a;
}
template <class Real, int count> MICROSLIP_INLINE bool any_of(const Mask<Real, count>& mask) {
  bool any = false;
  for (int i = 0; i < count; ++i) any |= mask.bits[i] != 0;
  return any;
}

/// The sum, halves first.
template <class Real, int count> MICROSLIP_INLINE Real reduce(Simd<Real, count> a) {
  for (int half = count / 2; half > 0; half /= 2)
    for (int i = 0; i < half; ++i) a.lanes[i] += a.lanes[i + half];
  return a.lanes[0];
}

/// The lanes of `values` for which the mask is true, to assign to.
template <class Real, int count> struct Chosen {
  const Mask<Real, count>& mask;
  Simd<Real, count>& values;
  MICROSLIP_INLINE void operator=(const Simd<Real, count>& others) const { // NOLINT: as where(mask, v) = w has it
    values.lanes = mask.bits ? others.lanes : values.lanes;
  }
};
template <class Real, int count>
MICROSLIP_INLINE Chosen<Real, count> where(const Mask<Real, count>& mask, Simd<Real, count>& values) {
  return {mask, values};
}

} // namespace microslip::vector_simd
