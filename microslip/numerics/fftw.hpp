#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <type_traits>

#include <fftw3.h>

/// FFTW's memory and plans as owned objects.
namespace microslip::fftw {

struct Free {
  template <class T> void operator()(T* memory) const { fftw_free(memory); }
};
/// Memory aligned for transforms.
template <class T> using Buffer = std::unique_ptr<T[], Free>;
template <class T> Buffer<T> allocate(std::size_t n) {
  auto* memory = static_cast<T*>(fftw_malloc(n * sizeof(T)));
  if (memory == nullptr) throw std::bad_alloc();
  return Buffer<T>(memory);
}

struct Destroy {
  void operator()(fftw_plan plan) const;
  void operator()(fftwf_plan plan) const;
};
using Plan = std::unique_ptr<fftw_plan_s, Destroy>;

inline fftw_complex* raw(std::complex<double>* z) {
  return reinterpret_cast<fftw_complex*>(z);
}

/// Runs FFTW's planner, which is not safe from several threads, under a lock. Throws Error if there is no plan.
Plan make(fftw_plan (*planner)(void*), void* what);
template <class Planner> Plan make(Planner planner) {
  return make([](void* what) { return (*static_cast<Planner*>(what))(); }, &planner);
}

/// Unscaled transforms of `count` sequences of n complex numbers, one after another, in double or single precision;
/// made for memory from `allocate`, in place if `in` is `out`.
template <class Real> class Transforms {
public:
  using Complex = std::complex<Real>;

  /// `sign`: FFTW_FORWARD or FFTW_BACKWARD.
  Transforms(int n, int count, int sign, Complex* in, Complex* out);
  /// For memory as aligned as that, and in place where that was.
  void execute(Complex* in, Complex* out) const;

private:
  std::unique_ptr<std::conditional_t<std::is_same_v<Real, float>, fftwf_plan_s, fftw_plan_s>, Destroy> plan_;
};

/// The smallest number from n on that has only the factors 2, 3, 5, 7, for which transforms are fast.
int good_size(int n);
/// The smallest even one.
int good_even_size(int n);
/// The smallest even number from n on for which FFTW's estimated plans of complex transforms are quick: other factors
/// than 2, 5 and 7, and more than one of these, make many of them slower than those of a size half as large again.
int quick_size(int n);

} // namespace microslip::fftw
