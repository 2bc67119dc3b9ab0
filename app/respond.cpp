#include "app/commands.hpp"

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/hertz.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/pictures.hpp"
#include "app/progress_bar.hpp"
#include "app/quantity_table.hpp"
#include "app/tables.hpp"
#include "cases/frequency_response_result.hpp"
#include "io/case_file.hpp"
#include "io/output_file.hpp"
#include "io/receptance_file.hpp"
#include "io/result_file.hpp"
#include "io/text_line.hpp"
#include "io/units.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/error.hpp"

#include <cmath>
#include <complex>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

constexpr int most_wavelengths = 10'000, most_poles = 100;
constexpr double shortest = 1e-6, longest = 1e6; // [m]

struct RespondArguments {
  fs::path case_file, folder, receptance;
  std::vector<std::string> wavelengths; ///< from, to
  int points = 40, poles = 0;
  double wear_coefficient = cases::ResponseQuestions{}.wear_coefficient; ///< [m^3/J]
  std::vector<std::string> band_width;                                   ///< one, if given
  bool no_pictures = false, json = false;
};

/// A length [m], in metres or with its unit.
double length_of(std::string_view option, std::string_view text) {
  const std::optional<double> number = io::parse_number(text);
  return number ? *number : io::number_in_unit(option, text, "m");
}

/// Wavelengths in a geometric sequence.
std::vector<double> wavelengths_of(const RespondArguments& arguments) {
  std::vector<double> ends;
  for (const std::string& text : arguments.wavelengths) {
    ends.push_back(length_of("--wavelength", text));
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

cases::ResponseQuestions questions_of(const RespondArguments& arguments) {
  cases::ResponseQuestions out{.wavelengths = wavelengths_of(arguments)};
  out.poles = require_count("--poles", arguments.poles, 0, most_poles);
  const bool alike = out.wavelengths.front() == out.wavelengths.back();
  if (out.poles > 0 && (arguments.points < out.poles || (alike && out.poles > 1)))
    throw Error(
        fmt::format("--poles: {} need as many different wavelengths at least, --points {}", out.poles, out.poles));
  out.wear_coefficient = require_positive("--wear-coefficient", arguments.wear_coefficient, "m^3/J");
  if (!arguments.band_width.empty())
    out.band_width = require_positive("--band-width", length_of("--band-width", arguments.band_width[0]), "m");
  if (arguments.receptance.empty() &&
      (!arguments.band_width.empty() || arguments.wear_coefficient != RespondArguments{}.wear_coefficient))
    throw Error("--wear-coefficient, --band-width: are for the growth of corrugation, which needs --receptance");
  if (!arguments.receptance.empty())
    out.receptance = io::read_receptance(io::read_case_text(arguments.receptance), arguments.receptance.string());
  return out;
}

/// A case's result and its title.
struct Found {
  cases::FrequencyResponseResult result;
  std::string title;
};

Found solve(const std::string& name, const std::string& text, const cases::ResponseQuestions& questions) {
  if (io::is_wheelset_case(text, name))
    throw Error(name + ": responses are those of two bodies or of one wheel, not of a wheelset");
  ProgressBar bar("responses");
  const Progress progress = [&](double fraction) {
    bar.update(fraction);
    InterruptGuard::throw_if_interrupted();
    return true;
  };
  const auto solved = [&](const auto& input) {
    return Found{cases::find_frequency_response(input, questions, progress), input.title};
  };
  Found out = io::is_wheel_rail_case(text, name) ? solved(io::parse_wheel_rail_case(text, name))
                                                 : solved(io::parse_case(text, name));
  InterruptGuard::throw_if_interrupted();
  return out;
}

/// The size in parts of that of very long waves and the lag, "0.532, 47".
std::string size_and_lag(std::complex<double> response, std::complex<double> quasistatic) {
  const std::complex<double> ratio = response / quasistatic;
  if (!std::isfinite(std::abs(ratio))) return "-";
  return fmt::format("{:.4f}, {:.1f}", std::abs(ratio), -std::arg(ratio) * 180 / std::numbers::pi + 0.0);
}

/// At most some 15 wavelengths.
void print_contact(const std::vector<double>& wavelengths, const cases::ContactResponse& contact) {
  std::vector<std::string> heads = {"frequency", "Fx by xi", "Fy by eta", "Fx by Fn", "filter", "Remington"};
  if (!contact.growth.empty()) heads.emplace_back("growth");
  QuantityTable table((contact.name.empty() ? "" : contact.name + ": ") +
                          "responses of the forces, in parts of those of very long waves, and their lags [deg]",
                      heads);
  const ForceResponse& still = contact.quasistatic;
  const std::size_t stride = (contact.response.at.size() + 14) / 15;
  for (std::size_t k = 0; k < contact.response.at.size(); k += stride) {
    const ForceResponse& r = contact.response.at[k];
    std::vector<std::string> values = {fmt::format("{:.4g} Hz", contact.frequencies[k]),
                                       size_and_lag(r.by_creepage[0][0], still.by_creepage[0][0]),
                                       size_and_lag(r.by_creepage[1][1], still.by_creepage[1][1]),
                                       size_and_lag(r.by_load[0], still.by_load[0]),
                                       fmt::format("{:.4f}", contact.filter[k]),
                                       fmt::format("{:.4f}", contact.remington[k])};
    if (!contact.growth.empty()) values.push_back(fmt::format("{:.3e}", contact.growth[k].rate.real()));
    table.add(fmt::format("{:.4g} mm", 1e3 * wavelengths[k]), values);
  }
  table.print();
  if (contact.element)
    fmt::print("\nRational fit: {} poles, largest error {:.2e} of a response's largest size\n",
               contact.element->count(), contact.element->largest_error());
}

void print_text(const cases::FrequencyResponseResult& result) {
  for (const cases::ContactResponse& contact : result.contacts) {
    if (&contact != &result.contacts.front()) fmt::print("\n");
    print_contact(result.wavelengths, contact);
  }
}

/// The fits as texts, which force elements are made of.
void write_elements(const fs::path& folder, const cases::FrequencyResponseResult& result,
                    std::vector<std::string>& files) {
  for (const cases::ContactResponse& contact : result.contacts) {
    if (!contact.element) continue;
    const fs::path path = folder / ((contact.name.empty() ? "" : contact.name + "_") + "force_element.txt");
    io::OutputFile file(path);
    file.write(text_of(*contact.element));
    file.commit();
    files.push_back(path.string());
  }
}

std::vector<std::string> write_files(const RespondArguments& arguments, const std::string& text, const Found& found) {
  if (arguments.folder.empty()) return {};
  io::create_folder(arguments.folder);
  const fs::path path = arguments.folder / io::result_name;
  io::ResultFile file(path, {.kind = "frequency_response",
                             .title = found.title,
                             .command_line = command_line(),
                             .case_file = arguments.case_file.string(),
                             .case_text = text});
  cases::write_frequency_response(file, found.result);
  file.commit();
  InterruptGuard::throw_if_interrupted();
  std::vector<std::string> files{path.string()};
  write_elements(arguments.folder, found.result, files);
  if (arguments.no_pictures) return files;
  for (const auto& picture : draw_pictures(path, arguments.folder)) files.push_back(picture);
  return files;
}

int run(const RespondArguments& arguments) {
  const cases::ResponseQuestions questions = questions_of(arguments);
  if (!arguments.folder.empty()) io::require_writable_file_in(arguments.folder, io::result_name);
  const std::string text = io::read_case_text(arguments.case_file), name = arguments.case_file.string();
  const Found found = solve(name, text, questions);
  if (found.result.contacts.empty())
    throw Error(fmt::format("{}: the steady state is not solved: {}", name, found.result.unsolved));
  if (!arguments.json) print_text(found.result);
  const auto files = write_files(arguments, text, found);
  if (arguments.json) {
    auto document = json_document("frequency_response");
    document.update(cases::frequency_response_document(found.result));
    document["files"] = files;
    print_json(document);
  } else if (!files.empty()) {
    fmt::print("\nWritten\n");
    print_files(files);
  }
  print_warnings("respond", found.result.warnings);
  return ExitCode::done;
}

constexpr const char* footer =
    R"(The forces' complex amplitudes where creepages, spin, normal force or roughness oscillate a little about steady
rolling, e^(i omega t) with omega = 2 pi V/wavelength, and the contact filter, the share of a roughness wave that the
normal force feels at a given approach, with Remington's beside it. By the exact theory, for elastically similar bodies
with Coulomb friction, or each patch of a wheel on a rail; adhesion and slip are those of the steady state.

With a receptance, a table of frequency [Hz], receptance_real and receptance_imaginary [m/N], the growth of corrugation
in a passage, over its height: > 0 where it grows. With --poles a rational fit of the responses, which is a force
element with memory: -o writes it as force_element.txt, of a wheel's patches as patch1_force_element.txt and so on. With --json all of it in SI units.

Example:
  microslip respond examples/hertzian_contact.toml --wavelength 10mm 1m -o filter)";

} // namespace

void add_respond_command(Command& program, int& exit_code) {
  Command command = program.add_subcommand(
      "respond", "Responses of a contact's forces to what oscillates, over the wavelength", footer);
  RespondArguments& arguments = command.arguments(exit_code, run);
  command.add_option("CASE.toml", arguments.case_file, "case of two bodies, or of a wheel on a rail").required();
  command
      .add_option("--wavelength FROM TO", arguments.wavelengths,
                  "wavelengths along the track [m], or with their unit as 10mm 1m; 1e-6 to 1e6")
      .required()
      .expected(2);
  command.add_option("--points COUNT", arguments.points, "wavelengths, in a geometric sequence, 1 to 10000");
  command.add_option("--receptance TABLE.csv", arguments.receptance,
                     "receptance of wheel and rail, by how far they part for each newton, for corrugation's growth");
  command.add_option("--wear-coefficient NUMBER", arguments.wear_coefficient,
                     "volume worn off by the frictional work [m^3/J]");
  command
      .add_option("--band-width WIDTH", arguments.band_width,
                  "width that wear is spread over [m], or with its unit as 20mm; default: the contact's width")
      .expected(1);
  command.add_option("--poles COUNT", arguments.poles, "order of a rational fit, 1 to 100; default: no fit");
  command.add_option("-o,--output FOLDER", arguments.folder,
                     "folder for result.h5, force elements and pictures; default: none is written");
  command.add_flag("--no-pictures", arguments.no_pictures, "write no pictures");
  add_json_flag(command, arguments.json);
}

} // namespace microslip::app
