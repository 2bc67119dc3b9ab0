#pragma once

#include <algorithm>
#include <array>
#include <thread>

namespace microslip {

/// The largest error(thread, round) of 40 rounds in two threads at once.
template <class Error> double worst_in_two_threads(const Error& error) {
  std::array<double, 2> worst{};
  const auto work = [&](unsigned thread) {
    for (unsigned round = 0; round < 40; ++round) worst[thread] = std::max(worst[thread], error(thread, round));
  };
  std::thread first(work, 0U), second(work, 1U);
  first.join();
  second.join();
  return std::max(worst[0], worst[1]);
}

} // namespace microslip
