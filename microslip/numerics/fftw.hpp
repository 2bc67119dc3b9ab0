#pragma once

#include "microslip/numerics/transform_plans.hpp"

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
/// not in place, in memory as aligned as that from `allocate`.
template <class Real> class Transforms {
public:
  using Complex = std::complex<Real>;
  using PlanOf = std::conditional_t<std::is_same_v<Real, float>, fftwf_plan_s, fftw_plan_s>;

  /// `sign`: FFTW_FORWARD or FFTW_BACKWARD.
  Transforms(int n, int count, int sign, const TransformPlans& plans = {});
  void execute(Complex* in, Complex* out) const;

private:
  std::shared_ptr<PlanOf> plan_;
};

/// Unscaled transforms of `count` sequences of n real numbers to n/2 + 1 complex ones each and back, which destroys
/// them. Sequences follow one another; of real numbers each has room for 2 (n/2 + 1). As Transforms otherwise.
class RealTransforms {
public:
  RealTransforms(int n, int count, const TransformPlans& plans = {});
  void forward(double* in, std::complex<double>* out) const;
  void backward(std::complex<double>* in, double* out) const;

private:
  std::shared_ptr<fftw_plan_s> forward_, backward_;
};

/// The smallest number from n on that has only the factors 2, 3, 5, 7, for which transforms are fast.
int good_size(int n);
/// The smallest even one.
int good_even_size(int n);
/// The smallest even number from n on for which FFTW's estimated plans of complex transforms are quick: other factors
/// than 2, 5 and 7, and more than one of these, make many of them slower than those of a size half as large again.
int quick_size(int n);

} // namespace microslip::fftw
