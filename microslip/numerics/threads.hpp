#pragma once

#include <omp.h>

namespace microslip {

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
