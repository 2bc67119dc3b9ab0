#include "app/commands.hpp"

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/json_document.hpp"
#include "app/measured_points.hpp"
#include "app/pictures.hpp"
#include "campaign/sweep_file.hpp"
#include "io/output_file.hpp"
#include "io/result_attribute.hpp"
#include "microslip/error.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {
namespace {

struct PlotArguments {
  std::string result, folder, spins, style;
  std::filesystem::path points;
  std::vector<std::string> fields, surfaces, formats, others;
  std::optional<int> dpi;
  std::vector<double> cut, stresses; ///< one value, if given
  bool convergence = false, json = false;
};

/// Arguments as microslip.plot takes them.
std::vector<std::string> python_arguments(const PlotArguments& given) {
  std::vector<std::string> arguments = {given.result};
  const auto add = [&](const std::string& name, const std::string& value) {
    if (!value.empty()) arguments.push_back("--" + name + "=" + value);
  };
  add("output", given.folder);
  for (const auto& format : given.formats) add("format", format);
  if (given.dpi) add("dpi", fmt::format("{}", *given.dpi));
  add("style", given.style);
  for (const auto& name : given.fields) add("field", name);
  for (const auto& name : given.surfaces) add("surface", name);
  for (const double y : given.cut) add("cut", fmt::format("{}", y));
  for (const double y : given.stresses) add("stresses", fmt::format("{}", y));
  add("creep-curves", given.spins);
  for (const auto& other : given.others) add("compare", other);
  if (given.convergence) arguments.emplace_back("--convergence");
  return arguments;
}

/// Format, resolution and style alone.
PlotArguments how_it_is_drawn(const PlotArguments& given) {
  PlotArguments how;
  how.formats = given.formats, how.dpi = given.dpi, how.style = given.style;
  return how;
}

void print_document(const PlotArguments& arguments, const Pictures& pictures) {
  auto document = json_document("plot");
  document["input"] = arguments.result;
  document["files"] = pictures.files;
  print_json(document);
}

/// Results beside measured points: cases of two bodies, and the curves of sweeps.
int plot_points(const PlotArguments& arguments, const std::filesystem::path& folder) {
  PlotArguments alone = how_it_is_drawn(arguments);
  alone.result = arguments.result, alone.folder = arguments.folder, alone.others = arguments.others;
  if (python_arguments(arguments) != python_arguments(alone))
    throw Error("--points: goes with --compare, --style, --format and --dpi; draw fields and cuts without it");
  std::vector<std::string> results = {arguments.result};
  results.insert(results.end(), arguments.others.begin(), arguments.others.end());
  const auto curves = arguments.others.empty() ? compare_result(arguments.result, arguments.points)
                                               : compare_results(results, arguments.points);
  const auto attribute = [&](const char* name) { return io::result_attribute(arguments.result, name).value_or(""); };
  const io::Provenance provenance = {.kind = "",
                                     .title = attribute("title"),
                                     .command_line = command_line(),
                                     .case_file = attribute("case_file"),
                                     .case_text = attribute("case_text")};
  PlotArguments of_points = how_it_is_drawn(arguments);
  of_points.result = write_comparison(curves, provenance, folder).string(), of_points.folder = folder.string();
  Pictures pictures = draw_pictures(python_arguments(of_points));
  pictures.files.insert(pictures.files.begin(), of_points.result);
  const bool is_sum = arguments.others.empty() && attribute("kind") != campaign::sweep_kind; // as `solve` has it
  if (arguments.json) {
    auto document = json_document("plot");
    document["input"] = arguments.result;
    document["measured_points"] = is_sum ? comparison_document(deviations_of(curves)) : comparison_document(curves);
    document["files"] = pictures.files;
    print_json(document);
  } else {
    fmt::print("{}\n{}\n", is_sum ? comparison_text(deviations_of(curves)) : comparison_text(curves),
               fmt::join(pictures.files, "\n"));
  }
  if (!pictures.problem.empty()) fmt::print(stderr, "microslip: warning: {}\n", pictures.problem);
  return ExitCode::done;
}

int plot(const PlotArguments& arguments) {
  if (arguments.dpi) require_count("--dpi", *arguments.dpi, 10, 2400);
  const std::filesystem::path folder = arguments.folder, beside = std::filesystem::path(arguments.result).parent_path();
  io::require_writable_folder(folder.empty() ? beside : folder);
  if (!arguments.points.empty()) return plot_points(arguments, folder.empty() ? beside : folder);
  const auto pictures = draw_pictures(python_arguments(arguments));
  if (!arguments.json)
    for (const auto& picture : pictures.files) fmt::print("{}\n", picture);
  else if (pictures.problem.empty())
    print_document(arguments, pictures);
  if (pictures.problem.empty()) return ExitCode::done;
  fmt::print(stderr, "microslip: {}\n", pictures.problem);
  return ExitCode::bad_input;
}

constexpr const char* drawn_fields =
    " pressure|bound|traction|px|py|slip|sx|sy|power|gap|ux|uy|friction_work|wear_depth|shear_excess";

constexpr const char* footer =
    R"(Draws all pictures of the file's kind, or those that the options ask for. Fields, cuts and comparisons
are of two bodies, of wheels on rails in one state, and of the first 12 cases of a run whose elements are stored;
stresses are of the former two, the others of two bodies. With --compare each --field is drawn for both results with
their difference, which needs the same elements. Creep curves, convergence and stresses are computed by the Python
module. Prints the names of the files.

Example:
  microslip plot results/hertzian_contact/result.h5 --field pressure --cut 0 --stresses 0
  microslip plot results/hertzian_contact/result.h5 --style paper --format pdf --format png)";

} // namespace

void add_plot_command(Command& program, int& exit_code) {
  Command command = program.add_subcommand("plot", "Draw the pictures of a result file", footer);
  PlotArguments& arguments = command.arguments(exit_code, plot);
  command.add_option("RESULT.h5", arguments.result, "a result file of solve, run, sweep, profile, conicity or validate")
      .required();
  command.add_option("-o,--output FOLDER", arguments.folder, "folder for the pictures; default: beside RESULT.h5");
  command.add_option("--format pdf|png|svg", arguments.formats, "of the files; may be given again; default: png")
      .expected(1)
      .take_all();
  command.add_option("--style page|paper|slides", arguments.style,
                     "sizes for the screen, for a paper's column or page, or for slides; default: page");
  command.add_option("--dpi COUNT", arguments.dpi,
                     "pixels in an inch of PNG, 10 to 2400; default: 150, paper 300, slides 200");
  const auto field_option = [&](const std::string& name, std::vector<std::string>& fields, const char* what) {
    command.add_option(name + drawn_fields, fields, what).expected(1).take_all();
  };
  field_option("--field", arguments.fields, "a field as a map; may be given again");
  field_option("--surface", arguments.surfaces, "a field as a surface; may be given again");
  command
      .add_option("--cut Y", arguments.cut,
                  "tractions with their bound and slip along the row at y [mm], on a rail in the frame of each patch")
      .expected(1);
  command
      .add_option("--stresses Y", arguments.stresses,
                  "stresses inside both bodies in the plane of y [mm], on a rail below each patch")
      .expected(1);
  command.add_option("--creep-curves SPINS", arguments.spins,
                     "Fx and Fy over the longitudinal creepage by both theories, for spins [1/m], e.g. 0,0.2,0.4");
  command.add_flag("--convergence", arguments.convergence, "errors of the exact theory over the number of elements");
  command
      .add_option("--compare OTHER.h5", arguments.others,
                  "another result file beside this one; may be given again for curves and sweeps")
      .expected(1)
      .take_all();
  command.add_option("--points POINTS.csv", arguments.points,
                     "measured creep curves as of `fit`, beside those of cases of two bodies and of sweeps over the "
                     "creepage, with rms and bias");
  add_json_flag(command, arguments.json);
}

} // namespace microslip::app
