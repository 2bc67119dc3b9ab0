#include "app/commands.hpp"
#include "app/program.hpp"
#include "app/validate.hpp"

namespace microslip::app {
namespace {

constexpr const char* footer =
    R"(Exit codes: 0 done, 1 a result is not converged or figures are not met, 2 bad input, 130 interrupted.
microslip COMMAND --help describes a command.

Example:
  microslip init wheel.toml && microslip solve wheel.toml)";

void add_commands(Command& program, int& exit_code) {
  add_solve_command(program, exit_code);
  add_hertz_command(program);
  add_batch_command(program, exit_code);
#ifndef _WIN32
  add_sweep_command(program, exit_code);
  add_statistics_command(program);
#endif
  add_init_command(program);
  add_run_command(program, exit_code);
  add_profile_command(program, exit_code);
  add_conicity_command(program);
  add_fit_command(program);
  add_plot_command(program, exit_code);
  add_report_command(program, exit_code);
  add_respond_command(program, exit_code);
  add_explore_command(program);
  add_convert_command(program, exit_code);
  add_table_command(program, exit_code);
  add_validate_command(program, exit_code, run_studies_program);
  add_bench_command(program, exit_code, [](bool) { return go_on_as_studies(); });
  add_completion_command(program);
  add_manual_command(program);
  program.footer(footer);
}

} // namespace
} // namespace microslip::app

int main(int count, char** arguments) {
  return microslip::app::run_program(count, arguments, microslip::app::add_commands);
}
