#pragma once

#include <omp.h>

namespace microslip {

/// Number of OpenMP threads while it lives.
class OmpThreads {
public:
  explicit OmpThreads(int count) : before_(omp_get_max_threads()) { omp_set_num_threads(count); }
  OmpThreads(const OmpThreads&) = delete;
  OmpThreads& operator=(const OmpThreads&) = delete;
  ~OmpThreads() { omp_set_num_threads(before_); }

private:
  int before_;
};

} // namespace microslip
