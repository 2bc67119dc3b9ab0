#pragma once

#include "microslip/progress.hpp"

#include <atomic>
#include <cstddef>
#include <exception>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace microslip {

#ifndef _OPENMP // as in WebAssembly
inline int omp_get_max_threads() {
  return 1;
}
inline int omp_get_thread_num() {
  return 0;
}
#endif

/// OpenMP's threads for work on so many numbers; a single one below `least`.
inline int threads_for(std::size_t numbers, std::size_t least) {
  return numbers >= least ? omp_get_max_threads() : 1;
}

/// Calls work(i, thread) for i = 0 .. count - 1, with `threads` of OpenMP's, thread = 0 .. threads - 1. One thread does
/// it without OpenMP, whose barriers cost system calls even with a single thread.
template <class Work> void distribute(int count, int threads, const Work& work) {
  if (threads == 1) {
    for (int i = 0; i < count; ++i) work(i, 0);
    return;
  }
#pragma omp parallel for num_threads(threads)
  for (int i = 0; i < count; ++i) work(i, omp_get_thread_num());
}

/// Calls work(i, thread, progress) likewise, in any order. Thread 0 is the calling one and the only one that tells
/// `progress`: before each i, and where the work reports itself. When that returns false or throws, the others' throws
/// Stopped, nothing more is begun, and Stopped or what was thrown is thrown here; as is the first that work throws.
template <class Work> void distribute(int count, int threads, const Progress& progress, const Work& work) {
  std::atomic<bool> ended = false;
  std::exception_ptr reason;
  const auto begin = [&](int i, int thread) {
    if (ended) return;
    const Progress on = [&, i, thread](double part) {
      if (ended) throw Stopped();
      if (thread == 0) go_on(progress, (i + part) / count);
      return true;
    };
    try {
      on(0);
      work(i, thread, on);
    } catch (...) {
      if (!ended.exchange(true)) reason = std::current_exception();
    }
  };
#pragma omp parallel for num_threads(threads) schedule(dynamic) if (threads > 1)
  for (int i = 0; i < count; ++i) begin(i, omp_get_thread_num());
  if (reason) std::rethrow_exception(reason);
}

} // namespace microslip
