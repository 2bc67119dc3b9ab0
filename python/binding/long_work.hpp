#pragma once

#include "microslip/progress.hpp"

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

/// Works on items 0 to count - 1 in chunks, on several threads: `make_worker()` gives each of them a function (first,
/// n). The calling thread takes part and looks for Ctrl-C between its chunks, so these should take some milliseconds.
/// Passes on the first exception. Python's lock must not be held.
using Worker = std::function<void(std::size_t first, std::size_t n, const Progress& progress)>;
void share_out(std::size_t count, std::size_t chunk, int threads, const std::function<Worker()>& make_worker);

} // namespace microslip::python
