#pragma once

#include "microslip/batch/batch.hpp"

#include <pybind11/pybind11.h>

#include <chrono>
#include <concepts>
#include <cstddef>
#include <functional>
#include <mutex>

namespace microslip::python {

/// Checks for Ctrl-C repeatedly: throws what Python's signal handlers raise, KeyboardInterrupt. Python runs them in
/// its main thread only.
class SignalCheck {
public:
  /// Cheap: looks at most 50 times a second. With or without Python's lock, which it takes for that.
  void operator()();
  /// Progress function of solvers that call one.
  Progress progress() {
    return [this](double) {
      (*this)();
      return true;
    };
  }

private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Calls work(progress) without Python's lock; Python objects may not be touched in it. Every call that may take longer
/// than a tenth of a second goes through here, OneAtATime, run_batch or mapped, and reports its progress as often:
/// so Ctrl-C ends it.
template <class Work> auto long_work(const Work& work) {
  const pybind11::gil_scoped_release release;
  SignalCheck signals;
  return work(signals.progress());
}

/// An object whose calls change it, made safe from many Python threads: one long call at a time.
template <class Object> struct OneAtATime {
  template <class... Arguments>
  requires std::constructible_from<Object, Arguments...>
  explicit OneAtATime(Arguments&&... arguments) : object(std::forward<Arguments>(arguments)...) {}

  /// long_work as work(object, progress). Ctrl-C ends the wait for others as well.
  template <class Work> auto run(const Work& work) {
    return long_work([&](const Progress& progress) {
      constexpr auto patience = std::chrono::milliseconds(20);
      std::unique_lock lock(busy, std::defer_lock);
      while (!lock.try_lock_for(patience)) progress(0);
      return work(object, progress);
    });
  }

  Object object;
  std::timed_mutex busy; ///< taken only without Python's lock
};

/// The number of threads for an argument where 0 means one for each processor. Throws Error unless it is in [0, 1024].
int thread_count(int threads);

/// A batch that Ctrl-C ends: long work whose calling thread checks for it.
void run_batch(std::size_t count, std::size_t chunk, int threads, const std::function<BatchWorker()>& make_worker);

} // namespace microslip::python
