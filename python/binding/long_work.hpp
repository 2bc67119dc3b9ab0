#pragma once

#include "microslip/batch/batch.hpp"

#include <pybind11/pybind11.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>

namespace microslip::python {

/// Looks for Ctrl-C now and then while work runs without Python's lock: throws what Python's signal handlers raise,
/// KeyboardInterrupt. Python runs them in its main thread only.
class SignalCheck {
public:
  /// Cheap: looks at most 50 times a second. The calling thread must not hold Python's lock.
  void operator()();
  /// For solvers that tell of their progress.
  Progress progress() {
    return [this](double) {
      (*this)();
      return true;
    };
  }

private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// An object whose calls change it, made safe from many Python threads: one long call at a time.
template <class Object> struct OneAtATime {
  template <class... Arguments>
  explicit OneAtATime(Arguments&&... arguments) : object(std::forward<Arguments>(arguments)...) {}

  /// Runs `work(object)` without Python's lock; Python objects may not be touched in it.
  template <class Work> auto run(const Work& work) {
    const pybind11::gil_scoped_release release;
    const std::scoped_lock lock(busy);
    return work(object);
  }

  Object object;
  std::mutex busy; ///< taken only without Python's lock
};

/// The number of threads for an argument where 0 means one for each processor. Throws Error unless it is in [0, 1024].
int thread_count(int threads);

/// A batch that Ctrl-C ends: the calling thread looks for it. Python's lock must not be held.
void run_batch(std::size_t count, std::size_t chunk, int threads, const std::function<BatchWorker()>& make_worker);

} // namespace microslip::python
