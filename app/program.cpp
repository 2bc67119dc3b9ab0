#include "app/program.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/option_text.hpp"
#include "app/program_arguments.hpp"
#include "app/usage_error.hpp"
#include "io/hdf5_exit.hpp"
#include "microslip/version.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace microslip::app {
namespace {

constexpr const char* output_lost = "standard output cannot be written";

std::string version_text() {
  const auto build = build_info();
  return fmt::format("microslip {} (commit {}, {}, {})", build.version, build.commit, build.compiler, build.build_type);
}

/// Returns true if all output has arrived. An earlier flush may have lost it, which only the stream remembers.
bool output_is_written() {
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

int fail(const char* message, int exit_code) {
  std::fflush(stdout);
  std::fprintf(stderr, "microslip: %s\n", message);
  return exit_code;
}

/// Throws Interrupted, at the latest when a command has done all.
int run(std::vector<std::string> arguments, void (*add_commands)(Command& program, int& exit_code)) {
  CLI::App parser("Frictional rolling contact of two bodies: forces, tractions and slip.", "microslip");
  parser.allow_windows_style_options(false); // /name is a path, there too
  parser.formatter(help_formatter());        // inherited by the commands that follow
  int exit_code = ExitCode::done;
  Command program(parser);
  add_commands(program, exit_code);
  parser.require_subcommand(1);
  parser.set_version_flag("--version", version_text(), "Print version, commit and compiler and exit");
  std::reverse(arguments.begin(), arguments.end()); // as the parser takes them
  try {
    parser.parse(std::move(arguments));
  } catch (const CLI::Success& success) {
    exit_code = parser.exit(success);
  } catch (const CLI::ParseError& error) {
    return fail(usage_error(parser, error).c_str(), ExitCode::bad_input);
  }
  InterruptGuard::throw_if_interrupted();
  return exit_code;
}

} // namespace

int run_program(int count, char** arguments, void (*add_commands)(Command& program, int& exit_code)) {
  io::leave_hdf5_at_exit();
  const InterruptGuard guard;
  try {
    const int exit_code = run(program_arguments(count, arguments), add_commands);
    return output_is_written() ? exit_code : fail(output_lost, ExitCode::bad_input);
  } catch (const Interrupted& error) {
    return fail(error.what(), ExitCode::interrupted);
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory", ExitCode::bad_input);
  } catch (const std::exception& error) {
    if (!output_is_written()) fail(output_lost, ExitCode::bad_input);
    return fail(error.what(), ExitCode::bad_input);
  }
}

} // namespace microslip::app
