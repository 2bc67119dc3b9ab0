#include "app/batch.hpp"
#include "app/bench.hpp"
#include "app/completion.hpp"
#include "app/conicity.hpp"
#include "app/convert.hpp"
#include "app/exit_code.hpp"
#include "app/explore.hpp"
#include "app/hertz.hpp"
#include "app/init.hpp"
#include "app/interrupt.hpp"
#include "app/manual.hpp"
#include "app/option_text.hpp"
#include "app/plot.hpp"
#include "app/profile.hpp"
#include "app/program_arguments.hpp"
#include "app/run.hpp"
#include "app/solve.hpp"
#include "app/sweep.hpp"
#include "app/table.hpp"
#include "app/usage_error.hpp"
#include "app/validate.hpp"
#include "io/hdf5_exit.hpp"
#include "microslip/version.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

constexpr const char* output_lost = "standard output cannot be written";

std::string version_text() {
  const auto build = build_info();
  return fmt::format("microslip {} (commit {}, {}, {})", build.version, build.commit, build.compiler, build.build_type);
}

void add_commands(CLI::App& program, int& exit_code) {
  program.formatter(std::make_shared<HelpFormatter>()); // inherited by the commands that follow
  add_solve_command(program, exit_code);
  add_hertz_command(program);
  add_batch_command(program, exit_code);
#ifndef _WIN32
  add_sweep_command(program, exit_code);
#endif
  add_init_command(program);
  add_run_command(program, exit_code);
  add_profile_command(program);
  add_conicity_command(program);
  add_plot_command(program, exit_code);
  add_explore_command(program);
  add_convert_command(program, exit_code);
  add_table_command(program, exit_code);
  add_validate_command(program, exit_code);
  add_bench_command(program);
  add_completion_command(program);
  add_manual_command(program);
  program.require_subcommand(1);
  program.set_version_flag("--version", version_text(), "Print version, commit and compiler and exit");
  program.footer(
      "Exit codes: 0 done, 1 a result is not converged or figures are not met, 2 bad input, 130 interrupted.\n"
      "microslip COMMAND --help describes a command.\n\n"
      "Example:\n  microslip init wheel.toml && microslip solve wheel.toml");
}

/// Whether all that was printed has arrived. An earlier flush may have lost it, which only the stream remembers.
bool output_is_written() {
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

int fail(const char* message, int exit_code) {
  std::fflush(stdout);
  std::fprintf(stderr, "microslip: %s\n", message);
  return exit_code;
}

/// Throws Interrupted, at the latest when a command has done all.
int run(std::vector<std::string> arguments) {
  CLI::App program("Frictional rolling contact of two bodies: forces, tractions and slip.", "microslip");
  int exit_code = ExitCode::done;
  program.allow_windows_style_options(false); // /name is a path, there too
  add_commands(program, exit_code);
  std::reverse(arguments.begin(), arguments.end()); // as the parser takes them
  try {
    program.parse(std::move(arguments));
  } catch (const CLI::Success& success) {
    exit_code = program.exit(success);
  } catch (const CLI::ParseError& error) {
    return fail(usage_error(program, error).c_str(), ExitCode::bad_input);
  }
  InterruptGuard::throw_if_interrupted();
  return exit_code;
}

} // namespace
} // namespace microslip::app

int main(int count, char** arguments) {
  using namespace microslip;
  using namespace microslip::app;
  io::leave_hdf5_at_exit();
  const InterruptGuard guard;
  try {
    const int exit_code = run(program_arguments(count, arguments));
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
