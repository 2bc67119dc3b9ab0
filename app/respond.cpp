#include "app/commands.hpp"

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/hertz.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/pictures.hpp"
#include "app/progress_bar.hpp"
#include "app/quantity_table.hpp"
#include "cases/frequency_response_result.hpp"
#include "io/case_file.hpp"
#include "io/output_file.hpp"
#include "io/result_file.hpp"
#include "io/units.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/error.hpp"

#include <cmath>
#include <complex>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

constexpr int most_wavelengths = 10'000;
constexpr double shortest = 1e-6, longest = 1e6; // [m]

struct RespondArguments {
  fs::path case_file, folder;
  std::vector<std::string> wavelengths; ///< from, to
  int points = 40;
  bool no_pictures = false, json = false;
};

/// Wavelengths in a geometric sequence.
std::vector<double> wavelengths_of(const RespondArguments& arguments) {
  std::vector<double> ends;
  for (const std::string& text : arguments.wavelengths) {
    ends.push_back(io::number_in_unit("--wavelength", text, "m"));
    require_between("--wavelength", ends.back(), "m", shortest, longest);
  }
  require_count("--points", arguments.points, 1, most_wavelengths);
  std::vector<double> out;
  for (int i = 0; i < arguments.points; ++i) {
    const double share = arguments.points > 1 ? static_cast<double>(i) / (arguments.points - 1) : 0;
    out.push_back(ends[0] * std::pow(ends[1] / ends[0], share));
  }
  return out;
}

io::RollingCase read_case(const fs::path& path, const std::string& text) {
  const std::string name = path.string();
  if (io::is_wheelset_case(text, name) || io::is_wheel_rail_case(text, name))
    throw Error(name +
                ": responses are those of two bodies, [body1] and [body2]; of a wheel on a rail by the ellipse and "
                "the load of one of its patches, which `microslip solve` prints");
  return io::parse_case(text, name);
}

cases::FrequencyResponseResult solve(const io::RollingCase& input, const std::vector<double>& wavelengths) {
  ProgressBar bar("responses");
  auto result = cases::find_frequency_response(input, wavelengths, [&](double fraction) {
    bar.update(fraction);
    InterruptGuard::throw_if_interrupted();
    return true;
  });
  InterruptGuard::throw_if_interrupted();
  return result;
}

/// The size in parts of that of very long waves and the lag, "0.532, 47 deg".
std::string size_and_lag(std::complex<double> response, std::complex<double> quasistatic) {
  const std::complex<double> ratio = response / quasistatic;
  if (!std::isfinite(std::abs(ratio))) return "-";
  return fmt::format("{:.4f}, {:.1f}", std::abs(ratio), -std::arg(ratio) * 180 / std::numbers::pi + 0.0);
}

void print_text(const cases::FrequencyResponseResult& result) {
  const ForceResponse& still = result.quasistatic;
  fmt::print("Responses of the forces, in parts of those of very long waves, and their lags\n");
  fmt::print("{:>12} {:>12} {:>16} {:>16} {:>16} {:>10}\n", "wavelength", "frequency", "Fx by xi", "Fy by eta",
             "Fx by Fn", "filter");
  fmt::print("{:>12} {:>12} {:>16} {:>16} {:>16} {:>10}\n", "[mm]", "[Hz]", "[-], [deg]", "[-], [deg]", "[-], [deg]",
             "[-]");
  const std::size_t stride = (result.response.at.size() + 14) / 15; // at most some 15 lines
  for (std::size_t k = 0; k < result.response.at.size(); k += stride) {
    const ForceResponse& r = result.response.at[k];
    fmt::print("{:>12.4g} {:>12.4g} {:>16} {:>16} {:>16} {:>10.4f}\n", 1e3 * result.wavelengths[k],
               result.frequencies[k], size_and_lag(r.by_creepage[0][0], still.by_creepage[0][0]),
               size_and_lag(r.by_creepage[1][1], still.by_creepage[1][1]), size_and_lag(r.by_load[0], still.by_load[0]),
               result.filter[k]);
  }
}

std::vector<std::string> write_files(const RespondArguments& arguments, const io::RollingCase& input,
                                     const std::string& text, const cases::FrequencyResponseResult& result) {
  if (arguments.folder.empty()) return {};
  io::create_folder(arguments.folder);
  const fs::path path = arguments.folder / io::result_name;
  io::ResultFile file(path, {.kind = "frequency_response",
                             .title = input.title,
                             .command_line = command_line(),
                             .case_file = arguments.case_file.string(),
                             .case_text = text});
  cases::write_frequency_response(file, result);
  file.commit();
  InterruptGuard::throw_if_interrupted();
  std::vector<std::string> files{path.string()};
  if (arguments.no_pictures) return files;
  for (const auto& picture : draw_pictures(path, arguments.folder)) files.push_back(picture);
  return files;
}

int run(const RespondArguments& arguments) {
  const std::vector<double> wavelengths = wavelengths_of(arguments);
  if (!arguments.folder.empty()) io::require_writable_file_in(arguments.folder, io::result_name);
  const std::string text = io::read_case_text(arguments.case_file);
  const io::RollingCase input = read_case(arguments.case_file, text);
  const auto result = solve(input, wavelengths);
  if (result.response.at.empty())
    throw Error(fmt::format("{}: the steady state is not solved: {}", arguments.case_file.string(),
                            result.response.solution.report.reason));
  if (!arguments.json) print_text(result);
  const auto files = write_files(arguments, input, text, result);
  if (arguments.json) {
    auto document = json_document("frequency_response");
    document.update(cases::frequency_response_document(result));
    document["files"] = files;
    print_json(document);
  } else if (!files.empty()) {
    fmt::print("\nWritten\n");
    for (const auto& file : files) fmt::print("  {}\n", file);
  }
  print_warnings("respond", result.warnings);
  return ExitCode::done;
}

constexpr const char* footer =
    R"(The forces' complex amplitudes where creepages, spin or normal force oscillate a little about steady rolling,
e^(i omega t) with omega = 2 pi V/wavelength, and the contact filter, the share of a roughness wave that the normal
force feels at a given approach. By the exact theory, for Hertzian contacts of elastically similar bodies with
Coulomb friction; adhesion and slip are those of the steady state. With --json all of it in SI units.

Example:
  microslip respond examples/hertzian_contact.toml --wavelength 10mm 1m -o filter)";

} // namespace

void add_respond_command(Command& program, int& exit_code) {
  Command command = program.add_subcommand(
      "respond", "Responses of a contact's forces to creepages and load that oscillate, over the wavelength", footer);
  RespondArguments& arguments = command.arguments(exit_code, run);
  command.add_option("CASE.toml", arguments.case_file, "case of two bodies").required();
  command
      .add_option("--wavelength FROM TO", arguments.wavelengths,
                  "wavelengths along the track [m], or with their unit as 10mm 1m; 1e-6 to 1e6")
      .required()
      .expected(2);
  command.add_option("--points COUNT", arguments.points, "wavelengths, in a geometric sequence, 1 to 10000");
  command.add_option("-o,--output FOLDER", arguments.folder,
                     "folder for result.h5 and pictures; default: none is written");
  command.add_flag("--no-pictures", arguments.no_pictures, "write result.h5 only");
  add_json_flag(command, arguments.json);
}

} // namespace microslip::app
