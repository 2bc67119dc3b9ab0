#include "app/interrupt.hpp"

#include <atomic>
#include <csignal>

namespace microslip {
namespace {

std::atomic<bool> was_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "the signal handler may not wait");

struct sigaction old_interrupt, old_termination;

void note(int) {
  was_interrupted = true;
}

} // namespace

InterruptGuard::InterruptGuard() {
  was_interrupted = false;
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART | SA_RESETHAND;
  sigaction(SIGINT, &action, &old_interrupt);
  sigaction(SIGTERM, &action, &old_termination);
}

InterruptGuard::~InterruptGuard() {
  sigaction(SIGINT, &old_interrupt, nullptr);
  sigaction(SIGTERM, &old_termination, nullptr);
}

bool InterruptGuard::interrupted() {
  return was_interrupted;
}

void InterruptGuard::throw_if_interrupted() {
  if (interrupted()) throw Interrupted();
}

} // namespace microslip
