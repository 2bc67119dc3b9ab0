#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace microslip::app {

/// Environment variables of this process, NAME=VALUE.
std::vector<std::string> environment_variables();

/// Runs a program, which is found as shells do, with nothing to read, its output and errors in files, and waits. The
/// first argument is the program. Returns its exit code, 128 and its number where a signal has ended it, or the
/// negative error number if it cannot be started. Throws Interrupted if this process is, which ends the child as well.
/// One at a time.
int run_child(std::vector<std::string> arguments, std::vector<std::string> environment, std::FILE* output,
              std::FILE* errors);

/// Runs another program instead of this one, with its arguments and streams; Ctrl-C meets the one or the other.
/// Returns only where the system cannot do that: the other's exit code, or the negative error number if it cannot be
/// started. Throws Interrupted.
int go_on_as(const std::filesystem::path& program);

/// Asks the program that run_child waits for to end, if any. For signal handlers: it makes one system call.
void end_child() noexcept;

/// Opens an address in the user's browser; false if none could be started.
bool open_in_browser(const std::string& address);

} // namespace microslip::app
