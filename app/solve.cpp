#include "app/solve.hpp"

#include "app/command_line.hpp"
#include "app/hertz.hpp"
#include "app/interrupt.hpp"
#include "app/pictures.hpp"
#include "app/quantity_table.hpp"
#include "app/rolling_contact_result.hpp"
#include "io/option_words.hpp"
#include "io/output_file.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;

struct SolveArguments {
  fs::path case_file;
  fs::path folder;
  bool no_pictures = false;
};

std::string in_units_of(double value, double unit, const std::string& name) {
  return unit == 0 ? "" : fmt::format("{:.4f} {}", value / unit, name);
}

std::string percent(double part, double whole) {
  return fmt::format("{:.1f} %", 100 * part / whole);
}

void print_hertz(const RollingContactResult& result) {
  QuantityTable table("Hertz");
  table.add("normal force", result.contact.normal_force, "N");
  add_hertz(table, result.hertz);
  table.print();
}

void print_forces(const RollingCase& input, const RollingContactResult& result) {
  const auto& options = input.options;
  const auto& forces = result.fields.forces;
  const auto limit = result.contact.friction.static_coefficient() * result.contact.normal_force;
  const auto moment = limit * std::sqrt(result.contact.a * result.contact.b);
  const auto area = forces.adhesion_area + forces.slip_area;
  QuantityTable table(fmt::format("{}, {} x {} cells, {} bound, flexibility: {}", to_word(input.theory), options.mx,
                                  options.my, to_word(options.bound), to_word(options.flexibility)));
  table.add("longitudinal force fx", forces.fx, "N", in_units_of(forces.fx, limit, "mu Fn"));
  table.add("lateral force fy", forces.fy, "N", in_units_of(forces.fy, limit, "mu Fn"));
  table.add("spin moment mz", forces.mz, "N m", in_units_of(forces.mz, moment, "mu Fn sqrt(a b)"));
  table.add("adhesion area", forces.adhesion_area * 1e6, "mm^2", percent(forces.adhesion_area, area));
  table.add("slip area", forces.slip_area * 1e6, "mm^2", percent(forces.slip_area, area));
  table.add("frictional power", result.fields.frictional_power, "W");
  table.add("discretisation error of fx", result.grid_error.fx, "mu Fn");
  table.add("discretisation error of fy", result.grid_error.fy, "mu Fn");
  table.add("discretisation error of mz", result.grid_error.mz, "mu Fn sqrt(a b)");
  table.add("status", std::string(to_string(forces.status)));
  table.print();
}

void write(const SolveArguments& arguments, const RollingCase& input, const RollingContactResult& result,
           const std::string& case_text, const fs::path& file) {
  const InterruptGuard guard;
  create_folder(arguments.folder);
  write_result(input, result,
               {.kind = "rolling_contact",
                .title = input.title,
                .command_line = command_line(),
                .case_file = arguments.case_file.string(),
                .case_text = case_text},
               file);
  InterruptGuard::throw_if_interrupted();
}

int solve(SolveArguments arguments) {
  if (arguments.folder.empty()) arguments.folder = fs::path("results") / arguments.case_file.stem();
  const auto text = read_case_text(arguments.case_file);
  const auto input = parse_case(text, arguments.case_file.string());
  const auto result = solve_case(input);

  if (!input.title.empty()) fmt::print("{}\n\n", input.title);
  print_hertz(result);
  fmt::print("\n");
  print_forces(input, result);

  const auto file = arguments.folder / "result.h5";
  write(arguments, input, result, text, file);
  fmt::print("\n{}\n", file.string());
  std::fflush(stdout);
  if (!arguments.no_pictures) {
    const auto pictures = draw_pictures(file, arguments.folder);
    for (const auto& picture : pictures.files) fmt::print("{}\n", picture);
    if (!pictures.problem.empty()) fmt::print(stderr, "microslip: warning: {}\n", pictures.problem);
  }
  if (result.fields.forces.status == Status::ok) return 0;
  fmt::print(stderr, "microslip: warning: {}: the numbers are too large or too small to compute with\n",
             arguments.case_file.string());
  return 1;
}

} // namespace

void add_solve_command(CLI::App& program, int& exit_code) {
  auto* command = program.add_subcommand("solve", "Solve a case of rolling contact: forces, fields and pictures");
  const auto arguments = std::make_shared<SolveArguments>();
  command->add_option("CASE.toml", arguments->case_file, "case file (microslip init writes one)")->required();
  command->add_option("-o,--output", arguments->folder,
                      "folder for result.h5 and the pictures; default: results/NAME for NAME.toml");
  command->add_flag("--no-pictures", arguments->no_pictures, "write result.h5 only");
  command->footer(
      "Solves Hertz's problem and then the simplified theory that the case file asks for. Prints forces on\n"
      "body 1 [N], the moment [N m], areas [mm^2] and the frictional power [W]. Writes result.h5 (SI) and\n"
      "tractions.png, areas.png, creep_curve.png.\n\n"
      "Example:\n  microslip solve examples/wheel_on_rail.toml -o results/wheel");
  command->callback([arguments, &exit_code] { exit_code = solve(*arguments); });
}

} // namespace microslip
