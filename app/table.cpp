#include "app/commands.hpp"

#include "app/exit_code.hpp"
#include "app/input_options.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/pictures.hpp"
#include "app/progress_bar.hpp"
#include "io/creep_table_file.hpp"
#include "io/output_file.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/description/input.hpp"
#include "microslip/error.hpp"
#include "microslip/table/making/creep_table_maker.hpp"

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

struct MakeArguments {
  fs::path output;
  InputOptions inputs{description::creep_table_inputs()};
  CreepTableMaking making = {};
  std::vector<double> range; ///< least and largest a/b
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool json = false;
};

struct ShowArguments {
  fs::path file;
  bool json = false;
};

struct DrawArguments {
  fs::path file, folder = ".";
  double axis_ratio = 1, poisson_ratio = 0.28;
  std::vector<double> spins{0, 0.5, 1};
  bool json = false;
};

void print_text(const CreepTableNodes& nodes) {
  const CreepTableAxes& axes = nodes.axes;
  fmt::print("a/b              {:g} to {:g}, {} nodes\n", axes.least_ratio, axes.largest_ratio, axes.ratios);
  fmt::print("Poisson's ratio  {}\n", fmt::join(axes.poisson_ratios, ", "));
  fmt::print("creepages        {} levels from no slip to full sliding, {} elevations, {} azimuths\n", axes.levels,
             axes.elevations, axes.azimuths);
  fmt::print("nodes            {}, {:.1f} MB\n", axes.blocks() * axes.nodes(),
             static_cast<double>(nodes.values.size_bytes()) / 1e6);
  const CreepTableOrigin& origin = nodes.origin;
  fmt::print("computed from    {} contacts on {} and {} elements across, {} not converged\n", origin.solved,
             origin.elements, origin.elements / 2, origin.not_converged);
  fmt::print("estimated error  rms {:.5f} {:.5f} {:.5f}, worst {:.4f} {:.4f} {:.4f} of Fx, Fy, Mz\n",
             origin.error_rms[0], origin.error_rms[1], origin.error_rms[2], origin.error_worst[0],
             origin.error_worst[1], origin.error_worst[2]);
}

void print_document(const CreepTableNodes& nodes, const fs::path& file) {
  const CreepTableAxes& axes = nodes.axes;
  const CreepTableOrigin& origin = nodes.origin;
  auto document = json_document("table");
  document["file"] = file.string();
  document["axis_ratios"] = {{"least", axes.least_ratio}, {"largest", axes.largest_ratio}, {"nodes", axes.ratios}};
  document["poisson_ratios"] = axes.poisson_ratios;
  document["levels"] = axes.levels;
  document["elevations"] = axes.elevations;
  document["azimuths"] = axes.azimuths;
  document["elements"] = origin.elements;
  document["contacts_solved"] = origin.solved;
  document["contacts_not_converged"] = origin.not_converged;
  document["estimated_error"] = {{"rms", origin.error_rms}, {"worst", origin.error_worst}};
  print_json(document);
}

void print(const CreepTableNodes& nodes, const fs::path& file, bool json) {
  if (json)
    print_document(nodes, file);
  else
    print_text(nodes);
}

int make(const MakeArguments& arguments) {
  arguments.inputs.require();
  require_count("--threads", arguments.threads, 1, most_threads);
  CreepTableMaking making = arguments.making;
  making.axes.least_ratio = arguments.range[0];
  making.axes.largest_ratio = arguments.range[1];
  std::sort(making.axes.poisson_ratios.begin(), making.axes.poisson_ratios.end());
  making.threads = arguments.threads;
  io::OutputFile file(arguments.output); // refused now and not when all is computed
  CreepTableNodes nodes;
  {
    ProgressBar bar("table");
    making.progress = [&bar](double fraction) {
      bar.update(fraction);
      return !InterruptGuard::interrupted();
    };
    try {
      nodes = make_creep_table(making);
    } catch (const Stopped&) {
      InterruptGuard::throw_if_interrupted();
      throw;
    }
  }
  io::write_creep_table(nodes, file);
  print(nodes, arguments.output, arguments.json);
  return ExitCode::done;
}

void show(const ShowArguments& arguments) {
  const fs::path file = io::creep_table_or_shipped(arguments.file);
  print(io::read_creep_table(file), file, arguments.json);
}

void add_show(Command& table) {
  Command command = table.add_subcommand("show", "Print what a creep-force table covers and how it was computed");
  ShowArguments& arguments = command.arguments(show);
  command.add_option("FILE", arguments.file, "a creep-force table; default: the one that microslip has");
  add_json_flag(command, arguments.json);
}

int draw(const DrawArguments& arguments) {
  const fs::path file = io::creep_table_or_shipped(arguments.file);
  const CreepTableAxes axes = io::read_creep_table(file).axes;
  require_between("--axis-ratio", arguments.axis_ratio, "-", 1e-3, 1e3);
  require_between("--poisson-ratio", arguments.poisson_ratio, "-", 0, 0.5);
  io::require_writable_folder(arguments.folder);
  const auto pictures = draw_pictures({file.string(), "--output=" + arguments.folder.string(),
                                       fmt::format("--axis-ratio={}", arguments.axis_ratio),
                                       fmt::format("--poisson-ratio={}", arguments.poisson_ratio),
                                       fmt::format("--spins={}", fmt::join(arguments.spins, ","))});
  if (!pictures.problem.empty()) throw Error(pictures.problem);
  const bool in_range = arguments.axis_ratio >= axes.least_ratio && arguments.axis_ratio <= axes.largest_ratio &&
                        arguments.poisson_ratio >= axes.poisson_ratios.front() &&
                        arguments.poisson_ratio <= axes.poisson_ratios.back();
  if (!in_range)
    fmt::print(stderr,
               "microslip: warning: {}: axis ratio {} or Poisson's ratio {} is beyond its range, {} to {} and {} to "
               "{}: drawn are limits\n",
               file.string(), arguments.axis_ratio, arguments.poisson_ratio, axes.least_ratio, axes.largest_ratio,
               axes.poisson_ratios.front(), axes.poisson_ratios.back());
  if (arguments.json) {
    auto document = json_document("table");
    document["input"] = file.string();
    document["in_range"] = in_range;
    document["files"] = pictures.files;
    print_json(document);
  } else {
    for (const auto& picture : pictures.files) fmt::print("{}\n", picture);
  }
  return ExitCode::done;
}

constexpr const char* draw_footer =
    R"(Draws Fx over the longitudinal creepage, Fy and Mz over the lateral one: lines by the table, points by the exact
theory on 24 x 24 elements, and writes their largest distance above.

Example:
  microslip table draw -o pictures --axis-ratio 2 --spin 0 1 2)";

void add_draw(Command& table, int& exit_code) {
  Command command =
      table.add_subcommand("draw", "Draw creep curves of a creep-force table beside the exact theory", draw_footer);
  DrawArguments& arguments = command.arguments(exit_code, draw);
  command.add_option("FILE", arguments.file, "a creep-force table; default: the one that microslip has");
  command.add_option("-o,--output FOLDER", arguments.folder, "folder for the picture").capture_default_str();
  command
      .add_option("--axis-ratio RATIO", arguments.axis_ratio, "a/b of the ellipse, along over across the rolling [-]")
      .capture_default_str();
  command.add_option("--poisson-ratio NU", arguments.poisson_ratio, "Poisson's ratio [-]").capture_default_str();
  command.add_option("--spin SPIN...", arguments.spins, "spins, scaled with G (a b)^(3/2)/(mu Fn) [-]")
      .capture_default_str();
  add_json_flag(command, arguments.json);
}

void add_make(Command& table, int& exit_code) {
  Command command = table.add_subcommand("make", "Compute a creep-force table by the exact theory");
  MakeArguments& arguments = command.arguments(exit_code, make);
  CreepTableMaking& making = arguments.making;
  command.add_option("-o,--output FILE", arguments.output, "the table").required();
  InputOptions& inputs = arguments.inputs;
  inputs.add(command, "poisson_ratio", making.axes.poisson_ratios, "NU...");
  inputs.add(command, "axis_ratio", arguments.range, "LEAST LARGEST").expected(2);
  inputs.add(command, "ratios", making.axes.ratios, "COUNT");
  inputs.add(command, "levels", making.axes.levels, "COUNT");
  inputs.add(command, "elevations", making.axes.elevations, "COUNT");
  inputs.add(command, "azimuths", making.axes.azimuths, "COUNT");
  inputs.add(command, "elements", making.elements, "COUNT");
  command.add_option("--threads COUNT", arguments.threads, "threads, 1 to 1024; default: one for each processor");
  add_json_flag(command, arguments.json);
}

constexpr const char* table_footer =
    R"(A creep-force table has results of the exact theory, between which --theory table interpolates. The one that
microslip has was made by the defaults of table make.

Example:
  microslip table make -o steel.creep --poisson-ratio 0.28)";

} // namespace

void add_table_command(Command& program, int& exit_code) {
  Command command = program.add_subcommand("table", "Show, draw or make a creep-force table", table_footer);
  command.require_subcommand(1);
  add_show(command);
  add_draw(command, exit_code);
  add_make(command, exit_code);
}

} // namespace microslip::app
