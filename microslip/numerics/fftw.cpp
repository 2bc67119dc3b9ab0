#include "microslip/numerics/fftw.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <tuple>

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

namespace {

/// The plan of `plans` for a key, made at its first use for memory of some size, which FFTW asks for though it does
/// not touch it.
template <class Real, class Key, class Make>
auto kept_plan(std::map<Key, std::shared_ptr<typename Transforms<Real>::PlanOf>>& plans, const Key& key,
               std::size_t size, Make make_plan) {
  const std::lock_guard lock(planner_lock());
  auto& plan = plans[key];
  if (!plan) {
    const auto in = allocate<std::complex<Real>>(size), out = allocate<std::complex<Real>>(size);
    plan = {make_plan(in.get(), out.get()), Destroy()};
    if (!plan) throw Error("fft: FFTW cannot plan this transform");
  }
  return plan;
}

fftw_plan plan_complex(int n, int count, int sign, std::complex<double>* in, std::complex<double>* out) {
  return fftw_plan_many_dft(1, &n, count, raw(in), nullptr, 1, n, raw(out), nullptr, 1, n, sign, FFTW_ESTIMATE);
}
fftwf_plan plan_complex(int n, int count, int sign, std::complex<float>* in, std::complex<float>* out) {
  return fftwf_plan_many_dft(1, &n, count, reinterpret_cast<fftwf_complex*>(in), nullptr, 1, n,
                             reinterpret_cast<fftwf_complex*>(out), nullptr, 1, n, sign, FFTW_ESTIMATE);
}

} // namespace

} // namespace microslip::fftw

namespace microslip {

/// By n, count and sign; for real numbers by n, count and whether the transform is back.
struct TransformPlans::Kept {
  using Key = std::tuple<int, int, int>;
  std::map<Key, std::shared_ptr<fftw_plan_s>> double_precision, of_real;
  std::map<Key, std::shared_ptr<fftwf_plan_s>> single_precision;
};

TransformPlans::TransformPlans() : kept_(std::make_shared<Kept>()) {}

} // namespace microslip

namespace microslip::fftw {

template <class Real> Transforms<Real>::Transforms(int n, int count, int sign, const TransformPlans& plans) {
  const std::size_t size = static_cast<std::size_t>(n) * count;
  const auto make_plan = [&](Complex* in, Complex* out) { return plan_complex(n, count, sign, in, out); };
  const TransformPlans::Kept::Key key{n, count, sign};
  if constexpr (std::is_same_v<Real, float>)
    plan_ = kept_plan<float>(plans.kept().single_precision, key, size, make_plan);
  else
    plan_ = kept_plan<double>(plans.kept().double_precision, key, size, make_plan);
}

template <class Real> void Transforms<Real>::execute(Complex* in, Complex* out) const {
  if constexpr (std::is_same_v<Real, float>)
    fftwf_execute_dft(plan_.get(), reinterpret_cast<fftwf_complex*>(in), reinterpret_cast<fftwf_complex*>(out));
  else
    fftw_execute_dft(plan_.get(), raw(in), raw(out));
}

RealTransforms::RealTransforms(int n, int count, const TransformPlans& plans) {
  const int columns = n / 2 + 1;
  const std::size_t size = static_cast<std::size_t>(columns) * count;
  auto& kept = plans.kept().of_real;
  forward_ = kept_plan<double>(kept, {n, count, FFTW_FORWARD}, size, [&](auto* in, auto* out) {
    return fftw_plan_many_dft_r2c(1, &n, count, reinterpret_cast<double*>(in), nullptr, 1, 2 * columns, raw(out),
                                  nullptr, 1, columns, FFTW_ESTIMATE);
  });
  backward_ = kept_plan<double>(kept, {n, count, FFTW_BACKWARD}, size, [&](auto* in, auto* out) {
    return fftw_plan_many_dft_c2r(1, &n, count, raw(in), nullptr, 1, columns, reinterpret_cast<double*>(out), nullptr,
                                  1, 2 * columns, FFTW_ESTIMATE);
  });
}

void RealTransforms::forward(double* in, std::complex<double>* out) const {
  fftw_execute_dft_r2c(forward_.get(), in, raw(out));
}
void RealTransforms::backward(std::complex<double>* in, double* out) const {
  fftw_execute_dft_c2r(backward_.get(), raw(in), out);
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
