#include "microslip/numerics/fftw.hpp"

#include "microslip/error.hpp"

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

Plan make(fftw_plan (*planner)(void*), void* what) {
  const std::lock_guard lock(planner_lock());
  Plan plan(planner(what));
  if (!plan) throw Error("fft: FFTW cannot plan this transform");
  return plan;
}

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

} // namespace microslip::fftw
