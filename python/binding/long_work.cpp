#include "binding/long_work.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"

#include <algorithm>

#include <omp.h>

namespace microslip::python {

void SignalCheck::operator()() {
  constexpr auto apart = std::chrono::milliseconds(20);
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < apart) return;
  last_ = now;
  const pybind11::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

int thread_count(int threads) {
  require_count("threads", threads, 0, most_threads);
  return threads > 0 ? threads : std::max(1, omp_get_num_procs());
}

void run_batch(std::size_t count, std::size_t chunk, int threads, const std::function<BatchWorker()>& make_worker) {
  long_work([&](const Progress& progress) {
    microslip::run_batch(count, {.chunk = chunk, .threads = threads, .progress = progress}, make_worker);
  });
}

} // namespace microslip::python
