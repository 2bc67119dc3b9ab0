#include "microslip/numerics/fftw.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <array>
#include <mutex>

namespace microslip::fftw {
namespace {

std::mutex& planner_lock() {
  static std::mutex mutex;
  return mutex;
}

} // namespace

void Destroy::operator()(fftw_plan plan) const {
  const std::lock_guard lock(planner_lock());
  fftw_destroy_plan(plan);
}

void Destroy::operator()(fftwf_plan plan) const {
  const std::lock_guard lock(planner_lock());
  fftwf_destroy_plan(plan);
}

Plan make(fftw_plan (*planner)(void*), void* what) {
  const std::lock_guard lock(planner_lock());
  Plan plan(planner(what));
  if (!plan) throw Error("fft: FFTW cannot plan this transform");
  return plan;
}

template <class Real> Transforms<Real>::Transforms(int n, int count, int sign, Complex* in, Complex* out) {
  const std::lock_guard lock(planner_lock());
  if constexpr (std::is_same_v<Real, float>)
    plan_.reset(fftwf_plan_many_dft(1, &n, count, reinterpret_cast<fftwf_complex*>(in), nullptr, 1, n,
                                    reinterpret_cast<fftwf_complex*>(out), nullptr, 1, n, sign, FFTW_ESTIMATE));
  else
    plan_.reset(fftw_plan_many_dft(1, &n, count, raw(in), nullptr, 1, n, raw(out), nullptr, 1, n, sign, FFTW_ESTIMATE));
  if (!plan_) throw Error("fft: FFTW cannot plan this transform");
}

template <class Real> void Transforms<Real>::execute(Complex* in, Complex* out) const {
  if constexpr (std::is_same_v<Real, float>)
    fftwf_execute_dft(plan_.get(), reinterpret_cast<fftwf_complex*>(in), reinterpret_cast<fftwf_complex*>(out));
  else
    fftw_execute_dft(plan_.get(), raw(in), raw(out));
}

template class Transforms<double>;
template class Transforms<float>;

int good_size(int n) {
  for (;; ++n) {
    int rest = n;
    for (int factor : {2, 3, 5, 7})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return n;
  }
}

int good_even_size(int n) {
  return 2 * good_size((n + 1) / 2);
}

int quick_size(int n) {
  // By trial with FFTW 3.3.10, in double and in single precision; from 128 on all of them times powers of 2.
  constexpr std::array small = {2, 4, 8, 12, 16, 20, 32, 48, 64, 80, 96};
  constexpr std::array large = {128, 160, 200, 224};
  const auto* found = std::lower_bound(small.begin(), small.end(), n);
  if (found != small.end()) return *found;
  int scale = 1;
  while (n > 2 * large.front() * scale) scale *= 2;
  for (const int size : large)
    if (n <= size * scale) return size * scale;
  return 2 * large.front() * scale;
}

} // namespace microslip::fftw
