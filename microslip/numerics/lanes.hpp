#pragma once

#include "microslip/numerics/inlined.hpp"
#include "microslip/numerics/simd.hpp"

namespace microslip {

/// A vector register of numbers in double or single precision that march together, loaded from and stored to doubles.
/// The type of the register is part of the name, so that code compiled for several instruction sets can be linked into
/// one program.
template <class Register> struct Lanes {
  static constexpr int width = static_cast<int>(Register::size());

  Register r;

  Lanes() = default;
  MICROSLIP_INLINE Lanes(double value) : r(static_cast<typename Register::value_type>(value)) {}
  MICROSLIP_INLINE Lanes(const Register& values) : r(values) {}

  MICROSLIP_INLINE static Lanes load(const double* from) { return Register(from, simd::element_aligned); }
  MICROSLIP_INLINE void store(double* to) const { r.copy_to(to, simd::element_aligned); }

  MICROSLIP_INLINE Lanes& operator+=(const Lanes& o) { return *this = *this + o; }

  MICROSLIP_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return a.r + b.r; }
  MICROSLIP_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return a.r - b.r; }
  MICROSLIP_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return a.r * b.r; }
  MICROSLIP_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) { return a.r / b.r; }
  MICROSLIP_INLINE friend Lanes operator-(const Lanes& a) { return -a.r; }
};

/// One truth value per lane.
template <class Register> struct LaneMask {
  using Bits = typename Register::mask_type;
  Bits r;

  LaneMask() = default;
  MICROSLIP_INLINE explicit LaneMask(bool value) : r(value) {}
  MICROSLIP_INLINE LaneMask(const Bits& values) : r(values) {}

  MICROSLIP_INLINE friend LaneMask operator&(const LaneMask& a, const LaneMask& b) { return a.r && b.r; }
  MICROSLIP_INLINE friend LaneMask operator|(const LaneMask& a, const LaneMask& b) { return a.r || b.r; }
  MICROSLIP_INLINE friend LaneMask operator~(const LaneMask& a) { return !a.r; }
};

template <class R> MICROSLIP_INLINE LaneMask<R> operator<(const Lanes<R>& a, const Lanes<R>& b) {
  return a.r < b.r;
}
template <class R> MICROSLIP_INLINE LaneMask<R> operator<=(const Lanes<R>& a, const Lanes<R>& b) {
  return a.r <= b.r;
}

template <class R> MICROSLIP_INLINE bool any(const LaneMask<R>& m) {
  return any_of(m.r);
}

/// `yes` where the mask is true, else `no`; what is not chosen may be anything, NaN too.
template <class R> MICROSLIP_INLINE Lanes<R> select(const LaneMask<R>& m, const Lanes<R>& yes, const Lanes<R>& no) {
  Lanes<R> v = no;
  where(m.r, v.r) = yes.r;
  return v;
}

template <class R> MICROSLIP_INLINE Lanes<R> sqrt(const Lanes<R>& a) {
  return sqrt(a.r); // of the register's library
}
template <class R> MICROSLIP_INLINE Lanes<R> abs(const Lanes<R>& a) {
  return abs(a.r);
}

/// The plain value of a number that may be a dual one, as in dual.hpp.
template <class R> MICROSLIP_INLINE const Lanes<R>& value_of(const Lanes<R>& a) {
  return a;
}

} // namespace microslip
