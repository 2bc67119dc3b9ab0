#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "io/output_file.hpp"

#include <atomic>
#include <cstdio>

#include <windows.h>

namespace microslip::app {
namespace {

constexpr DWORD patience = 150; // [ms]

std::atomic<bool> was_interrupted = false;
std::atomic<int> guards = 0; ///< raised where one begins or ends: what the guard was for is over

[[noreturn]] void end_at_once() {
  io::remove_temporary_files();
  std::fputs("microslip: interrupted\n", stderr);
  std::fflush(stderr);
  ::TerminateProcess(::GetCurrentProcess(), ExitCode::interrupted);
  for (;;) ::Sleep(INFINITE);
}

/// Windows calls it in a separate thread.
BOOL WINAPI note(DWORD) {
  if (was_interrupted.exchange(true)) end_at_once();
  const int guard = guards;
  ::Sleep(patience);
  if (guard == guards) end_at_once();
  return TRUE;
}

} // namespace

InterruptGuard::InterruptGuard() {
  was_interrupted = false;
  ++guards;
  ::SetConsoleCtrlHandler(note, TRUE);
}

InterruptGuard::~InterruptGuard() {
  ++guards;
  ::SetConsoleCtrlHandler(note, FALSE);
}

bool InterruptGuard::interrupted() {
  return was_interrupted;
}

void InterruptGuard::throw_if_interrupted() {
  if (interrupted()) throw Interrupted();
}

} // namespace microslip::app
