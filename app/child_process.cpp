#include "app/child_process.hpp"

#include "app/interrupt.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <fstream>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace microslip::app {
namespace {

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (auto& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

std::atomic<pid_t> running = 0;
static_assert(std::atomic<pid_t>::is_always_lock_free, "a signal handler may not wait");

/// Waits until a child has ended; its number is not reused.
void wait_for(pid_t child) {
  siginfo_t ended{};
  while (waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
  }
}

} // namespace

void end_child() noexcept {
  if (const pid_t child = running; child > 0) ::kill(child, SIGTERM);
}

std::vector<std::string> environment_variables() {
  std::vector<std::string> variables;
  for (auto** variable = environ; *variable != nullptr; ++variable) variables.emplace_back(*variable);
  return variables;
}

int run_child(std::vector<std::string> arguments, std::vector<std::string> environment, std::FILE* output,
              std::FILE* errors) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(output), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(errors), STDERR_FILENO);
  pid_t child = 0;
  const int error = posix_spawnp(&child, arguments[0].c_str(), &actions, nullptr, pointers(arguments).data(),
                                 pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return -error;
  running = child;
  if (InterruptGuard::interrupted()) end_child();
  wait_for(child);
  running = 0;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  InterruptGuard::throw_if_interrupted();
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int go_on_as(const std::filesystem::path& program) {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> arguments;
  for (std::string argument; std::getline(file, argument, '\0');) arguments.push_back(argument);
  sigset_t ends, before;
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  sigprocmask(SIG_BLOCK, &ends, &before); // until the other program's InterruptGuard lives
  InterruptGuard::throw_if_interrupted();
  ::execv(program.c_str(), pointers(arguments).data());
  const int error = errno;
  sigprocmask(SIG_SETMASK, &before, nullptr);
  return -error;
}

bool open_in_browser(const std::string& address) {
  return run_child({"xdg-open", address}, environment_variables(), stdout, stderr) == 0;
}

} // namespace microslip::app
