// The program's part with the studies, microslip-validate, which `microslip validate` and `microslip bench vehicle` go
// on as.

#include "app/commands.hpp"
#include "app/program.hpp"
#include "app/studies.hpp"

int main(int count, char** arguments) {
  using namespace microslip::app;
  return run_program(count, arguments, [](Command& program, int& exit_code) {
    add_validate_command(program, exit_code, run_studies);
    add_bench_command(program, exit_code, bench_vehicle);
  });
}
