#pragma once

#include "microslip/numerics/inlined.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
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
template <class Real> constexpr int register_lanes = register_size / static_cast<int>(sizeof(Real));

template <class Real, int count> struct LaneVectorType {
  typedef Real type __attribute__((vector_size(count * sizeof(Real)))); // NOLINT(modernize-use-using)
};
/// A vector as g++ and clang have it.
template <class Real, int count> using LaneVector = typename LaneVectorType<Real, count>::type;
/// Whole numbers of the same size.
template <class Real> using WholeNumber = std::conditional_t<sizeof(Real) == 8, std::int64_t, std::int32_t>;
template <class Real, int count> using WholeLanes = LaneVector<WholeNumber<Real>, count>;

/// `count` numbers that the processor works on together. Both are part of the name, so that code compiled for several
/// instruction sets can be linked into one program.
template <class Real, int count = register_lanes<Real>> struct Lanes {
  using Vector = LaneVector<Real, count>;
  static constexpr int width = count;

  Vector v;

  Lanes() = default;
  template <class Value>
  requires std::is_arithmetic_v<Value> MICROSLIP_INLINE Lanes(Value value) : v(static_cast<Real>(value) - Vector{}) {}
  MICROSLIP_INLINE Lanes(const Vector& values) : v(values) {}

  /// Loads from and stores to memory of any alignment, in the same precision or another.
  template <class Value> MICROSLIP_INLINE static Lanes load(const Value* from) {
    Lanes lanes;
    if constexpr (std::is_same_v<Value, Real>)
      __builtin_memcpy(&lanes.v, from, sizeof lanes.v);
    else
      for (int i = 0; i < count; ++i) lanes.v[i] = static_cast<Real>(from[i]);
    return lanes;
  }
  template <class Value> MICROSLIP_INLINE void store(Value* to) const {
    if constexpr (std::is_same_v<Value, Real>)
      __builtin_memcpy(to, &v, sizeof v);
    else
      for (int i = 0; i < count; ++i) to[i] = static_cast<Value>(v[i]);
  }

  MICROSLIP_INLINE Lanes& operator+=(const Lanes& o) { return *this = *this + o; }

  MICROSLIP_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return a.v + b.v; }
  MICROSLIP_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return a.v - b.v; }
  MICROSLIP_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return a.v * b.v; }
  MICROSLIP_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) { return a.v / b.v; }
  MICROSLIP_INLINE friend Lanes operator-(const Lanes& a) { return -a.v; }
};

namespace detail {

/// Truth values of lanes: all bits of a whole number or none.
template <class Real, int count> struct LaneBits {
  using Numbers = LaneVector<Real, count>;
  using Type = WholeLanes<Real, count>;

  MICROSLIP_INLINE static Type all(bool value) { return Type{} - (value ? 1 : 0); }
  MICROSLIP_INLINE static Type less(const Numbers& a, const Numbers& b) { return a < b; }
  MICROSLIP_INLINE static Type at_most(const Numbers& a, const Numbers& b) { return a <= b; }
  MICROSLIP_INLINE static Numbers choose(const Type& bits, const Numbers& yes, const Numbers& no) {
    return bits ? yes : no;
  }
  MICROSLIP_INLINE static bool any(const Type& bits) {
    // By four bytes of every lane, for that of a float is no larger.
#ifdef __AVX__
    if constexpr (sizeof bits == 32) return __builtin_ia32_movmskps256(LaneVector<float, 8>(bits)) != 0;
#endif
#ifdef __SSE2__
    if constexpr (sizeof bits == 16) return __builtin_ia32_movmskps(LaneVector<float, 4>(bits)) != 0;
#endif
    bool is_any = false;
    for (int i = 0; i < count; ++i) is_any |= bits[i] != 0;
    return is_any;
  }
};

#if defined(__AVX512F__) && !defined(__clang__)
// Comparisons make a bit for each lane, from which g++ 12 would go to whole numbers and back.
template <class Mask> struct MaskRegister {
  using Type = Mask;
  static constexpr int less_than = 1, less_or_equal = 2, current_rounding = 4;

  MICROSLIP_INLINE static Type all(bool value) { return static_cast<Type>(value ? -1 : 0); }
  MICROSLIP_INLINE static bool any(Type bits) { return bits != 0; }
};
template <> struct LaneBits<double, 8> : MaskRegister<unsigned char> {
  using Numbers = LaneVector<double, 8>;
  MICROSLIP_INLINE static Type less(const Numbers& a, const Numbers& b) {
    return __builtin_ia32_cmppd512_mask(a, b, less_than, all(true), current_rounding);
  }
  MICROSLIP_INLINE static Type at_most(const Numbers& a, const Numbers& b) {
    return __builtin_ia32_cmppd512_mask(a, b, less_or_equal, all(true), current_rounding);
  }
  MICROSLIP_INLINE static Numbers choose(Type bits, const Numbers& yes, const Numbers& no) {
    return __builtin_ia32_blendmpd_512_mask(no, yes, bits);
  }
};
template <> struct LaneBits<float, 16> : MaskRegister<unsigned short> {
  using Numbers = LaneVector<float, 16>;
  MICROSLIP_INLINE static Type less(const Numbers& a, const Numbers& b) {
    return __builtin_ia32_cmpps512_mask(a, b, less_than, all(true), current_rounding);
  }
  MICROSLIP_INLINE static Type at_most(const Numbers& a, const Numbers& b) {
    return __builtin_ia32_cmpps512_mask(a, b, less_or_equal, all(true), current_rounding);
  }
  MICROSLIP_INLINE static Numbers choose(Type bits, const Numbers& yes, const Numbers& no) {
    return __builtin_ia32_blendmps_512_mask(no, yes, bits);
  }
};
#endif

} // namespace detail

/// One truth value per lane.
template <class Real, int count = register_lanes<Real>> struct LaneMask {
  using Bits = typename detail::LaneBits<Real, count>::Type;
  Bits bits;

  LaneMask() = default;
  MICROSLIP_INLINE explicit LaneMask(bool value) : bits(detail::LaneBits<Real, count>::all(value)) {}
  MICROSLIP_INLINE static LaneMask of(const Bits& bits) {
    LaneMask mask;
    mask.bits = bits;
    return mask;
  }

  MICROSLIP_INLINE friend LaneMask operator&(const LaneMask& a, const LaneMask& b) { return of(a.bits & b.bits); }
  MICROSLIP_INLINE friend LaneMask operator|(const LaneMask& a, const LaneMask& b) { return of(a.bits | b.bits); }
  MICROSLIP_INLINE friend LaneMask operator~(const LaneMask& a) { return of(static_cast<Bits>(~a.bits)); }
};

template <class R, int n> MICROSLIP_INLINE LaneMask<R, n> operator<(const Lanes<R, n>& a, const Lanes<R, n>& b) {
  return LaneMask<R, n>::of(detail::LaneBits<R, n>::less(a.v, b.v));
}
template <class R, int n> MICROSLIP_INLINE LaneMask<R, n> operator<=(const Lanes<R, n>& a, const Lanes<R, n>& b) {
  return LaneMask<R, n>::of(detail::LaneBits<R, n>::at_most(a.v, b.v));
}

template <class R, int n> MICROSLIP_INLINE bool any(const LaneMask<R, n>& m) {
  return detail::LaneBits<R, n>::any(m.bits);
}

/// `yes` where the mask is true, else `no`; what is not chosen may be anything, NaN too.
template <class R, int n>
MICROSLIP_INLINE Lanes<R, n> select(const LaneMask<R, n>& m, const Lanes<R, n>& yes, const Lanes<R, n>& no) {
  return Lanes<R, n>(detail::LaneBits<R, n>::choose(m.bits, yes.v, no.v));
}

template <class R, int n> MICROSLIP_INLINE Lanes<R, n> sqrt(const Lanes<R, n>& all) {
  Lanes<R, n> a = all;
  for (int i = 0; i < n; ++i) a.v[i] = std::sqrt(a.v[i]);
  return a;
}
template <class R, int n> MICROSLIP_INLINE Lanes<R, n> abs(const Lanes<R, n>& a) {
  return LaneVector<R, n>(WholeLanes<R, n>(a.v) & std::numeric_limits<WholeNumber<R>>::max()); // without the sign's bit
}

namespace detail {

template <int apart, class R, int n, int... lane>
MICROSLIP_INLINE void exchange_lanes(Lanes<R, n>& a, Lanes<R, n>& b, std::integer_sequence<int, lane...>) {
  const Lanes<R, n> low = __builtin_shufflevector(a.v, b.v, ((lane & apart) != 0 ? n + lane - apart : lane)...);
  b.v = __builtin_shufflevector(a.v, b.v, ((lane & apart) != 0 ? n + lane : lane + apart)...);
  a = low;
}

} // namespace detail

/// Turns rows of a square into its columns: lane j of rows[i] becomes lane i of rows[j].
template <int apart = 1, class R, int n> MICROSLIP_INLINE void transpose(Lanes<R, n>* rows) {
#pragma GCC unroll 16
  for (int i = 0; i < n; ++i)
    if ((i & apart) == 0) detail::exchange_lanes<apart>(rows[i], rows[i + apart], std::make_integer_sequence<int, n>());
  if constexpr (2 * apart < n) transpose<2 * apart>(rows);
}

/// Numbers in as many registers as they need, with less arithmetic.
template <class Real, int count> struct WideLanes {
  using Part = Lanes < Real, count<register_lanes<Real> ? count : register_lanes<Real>>;
  static constexpr int width = count, parts = count / Part::width;

  Part part[parts];

  WideLanes() = default;
  MICROSLIP_INLINE WideLanes(Real value) {
    for (Part& p : part) p = value;
  }
  template <class Parts> MICROSLIP_INLINE static WideLanes of(Parts part_of) {
    WideLanes lanes;
    for (int k = 0; k < parts; ++k) lanes.part[k] = part_of(k);
    return lanes;
  }

  template <class Value> MICROSLIP_INLINE static WideLanes load(const Value* from) {
    return of([from](int k) { return Part::load(from + k * Part::width); });
  }
  template <class Value> MICROSLIP_INLINE void store(Value* to) const {
    for (int k = 0; k < parts; ++k) part[k].store(to + k * Part::width);
  }

  MICROSLIP_INLINE WideLanes& operator+=(const WideLanes& o) { return *this = *this + o; }
  MICROSLIP_INLINE WideLanes& operator-=(const WideLanes& o) { return *this = *this - o; }

  MICROSLIP_INLINE friend WideLanes operator+(const WideLanes& a, const WideLanes& b) {
    return of([&](int k) { return a.part[k] + b.part[k]; });
  }
  MICROSLIP_INLINE friend WideLanes operator-(const WideLanes& a, const WideLanes& b) {
    return of([&](int k) { return a.part[k] - b.part[k]; });
  }
  MICROSLIP_INLINE friend WideLanes operator*(const WideLanes& a, const WideLanes& b) {
    return of([&](int k) { return a.part[k] * b.part[k]; });
  }
};

/// The sum of all lanes, halves first.
template <class R, int n> MICROSLIP_INLINE R sum(const WideLanes<R, n>& all) {
  using Vector = WideLanes<R, n>;
  Vector a = all;
  for (int half = Vector::parts / 2; half > 0; half /= 2)
    for (int k = 0; k < half; ++k) a.part[k] += a.part[k + half];
  auto last = a.part[0].v;
  for (int half = Vector::Part::width / 2; half > 0; half /= 2)
    for (int i = 0; i < half; ++i) last[i] += last[i + half];
  return last[0];
}

/// The plain value of a number that may be a dual one, as in dual.hpp.
template <class R, int n> MICROSLIP_INLINE const Lanes<R, n>& value_of(const Lanes<R, n>& a) {
  return a;
}

} // namespace microslip
