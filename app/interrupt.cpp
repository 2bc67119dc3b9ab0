#include "app/interrupt.hpp"

#include "app/child_process.hpp"
#include "app/exit_code.hpp"
#include "io/output_file.hpp"

#include <atomic>
#include <csignal>
#include <string_view>

#include <sys/time.h>
#include <unistd.h>

namespace microslip::app {
namespace {

constexpr timeval patience = {.tv_sec = 0, .tv_usec = 150000};

std::atomic<bool> was_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "the signal handler may not wait");

struct sigaction old_interrupt, old_termination, old_alarm;

/// Calls only what a signal handler may call.
[[noreturn]] void end_at_once(int) {
  constexpr std::string_view message = "microslip: interrupted\n";
  io::remove_temporary_files();
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(ExitCode::interrupted);
}

/// SIGALRM after a time; none after no time. A mere system call, which a signal handler may make.
void set_alarm(const timeval& after) {
  const itimerval once = {.it_interval = {}, .it_value = after};
  ::setitimer(ITIMER_REAL, &once, nullptr);
}

void note(int signal) {
  if (was_interrupted.exchange(true)) end_at_once(signal);
  end_child();
  set_alarm(patience);
}

void handle(int signal, void (*handler)(int), struct sigaction& old) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, &old);
}

} // namespace

InterruptGuard::InterruptGuard() {
  was_interrupted = false;
  handle(SIGALRM, end_at_once, old_alarm);
  handle(SIGINT, note, old_interrupt);
  handle(SIGTERM, note, old_termination);
  sigset_t held_back; // by go_on_as
  sigemptyset(&held_back);
  sigaddset(&held_back, SIGINT);
  sigaddset(&held_back, SIGTERM);
  sigprocmask(SIG_UNBLOCK, &held_back, nullptr);
}

InterruptGuard::~InterruptGuard() {
  // A signal until here may set the alarm, which must not outlive its handler: SIGALRM would end the process.
  sigaction(SIGINT, &old_interrupt, nullptr);
  sigaction(SIGTERM, &old_termination, nullptr);
  set_alarm({});
  sigaction(SIGALRM, &old_alarm, nullptr);
}

bool InterruptGuard::interrupted() {
  return was_interrupted;
}

void InterruptGuard::throw_if_interrupted() {
  if (interrupted()) throw Interrupted();
}

} // namespace microslip::app
