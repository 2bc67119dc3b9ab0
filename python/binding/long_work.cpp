#include "binding/long_work.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

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
  require_count("threads", threads, 0, 1024);
  return threads > 0 ? threads : std::max(1, omp_get_num_procs());
}

void share_out(std::size_t count, std::size_t chunk, int threads, const std::function<Worker()>& make_worker) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stopped = false;
  std::exception_ptr error;
  SignalCheck signals;
  const auto own_progress = signals.progress();
  const Progress others_progress = [&](double) { return !stopped; };
  const auto chunks = (count + chunk - 1) / chunk;
  const int used =
      static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(threads), std::max<std::size_t>(1, chunks)));
#pragma omp parallel num_threads(used)
  try {
    const bool is_caller = omp_get_thread_num() == 0;
    const auto worker = make_worker();
    for (std::size_t first = next.fetch_add(chunk); first < count && !stopped; first = next.fetch_add(chunk)) {
      worker(first, std::min(chunk, count - first), is_caller ? own_progress : others_progress);
      if (is_caller) signals();
    }
  } catch (...) {
#pragma omp critical(microslip_share_out)
    if (!error) error = std::current_exception();
    stopped = true;
  }
  if (error) std::rethrow_exception(error);
}

} // namespace microslip::python
