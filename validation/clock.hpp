#pragma once

#include <chrono>
#include <ctime>

namespace microslip::validation {

/// Processor time of all threads, and of this one or where that is not known of all [s]. Other work on the machine
/// changes it less than elapsed time.
#ifdef CLOCK_THREAD_CPUTIME_ID
inline double time_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}
inline double processor_time() {
  return time_of(CLOCK_PROCESS_CPUTIME_ID);
}
inline double thread_time() {
  return time_of(CLOCK_THREAD_CPUTIME_ID);
}
#else
inline double processor_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}
inline double thread_time() {
  return processor_time();
}
#endif

/// Elapsed time of some work [s].
template <class Work> double seconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace microslip::validation
