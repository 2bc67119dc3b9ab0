#pragma once

#include <stdexcept>

namespace microslip::app {

/// Ctrl-C, or a request to end: work stops where it can leave nothing half-written.
class Interrupted : public std::runtime_error {
public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// While it lives, SIGINT and SIGTERM are noted for work to see, and end a child. If the program does not end within
/// 0.15 s, as within one long transform, or if there is a second signal, it ends there and then, with the same message
/// and exit code, and without temporary files. One at a time: main has one, around all commands.
class InterruptGuard {
public:
  InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  ~InterruptGuard();

  static bool interrupted();
  static void throw_if_interrupted();
};

} // namespace microslip::app
