#pragma once

#include <cstddef>

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
template <class Work> void share_out(int count, int threads, const Work& work) {
  if (threads == 1) {
    for (int i = 0; i < count; ++i) work(i, 0);
    return;
  }
#pragma omp parallel for num_threads(threads)
  for (int i = 0; i < count; ++i) work(i, omp_get_thread_num());
}

} // namespace microslip
