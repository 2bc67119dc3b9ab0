#include "app/commands.hpp"

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/hertz.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/option_text.hpp"
#include "app/pictures.hpp"
#include "app/profile_folder.hpp"
#include "app/profile_options.hpp"
#include "app/profile_slices.hpp"
#include "app/quantity_table.hpp"
#include "cases/profile_result.hpp"
#include "io/output_file.hpp"
#include "io/profile_writer.hpp"
#include "io/result_file.hpp"
#include "io/slices_file.hpp"
#include "microslip/description/input.hpp"
#include "microslip/error.hpp"

#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

struct ProfileArguments {
  fs::path file, folder, converted;
  std::string role;
  ProfileOptions options;
  std::vector<double> tape_line; ///< one value, if given
  InputOptions inputs{description::conicity_inputs()};
  PartnerOptions partner;
  double gauge_height = 0;
  bool no_pictures = false, json = false;
};

io::ProfileFileOptions options_of(const ProfileArguments& arguments) {
  std::optional<ProfileRole> role;
  if (!arguments.role.empty()) role = io::from_word<ProfileRole>("--role", arguments.role);
  return file_options(arguments.options, role);
}

cases::ProfileMeasures measures_of(const ProfileArguments& arguments) {
  arguments.inputs.require();
  cases::ProfileMeasures measures{.gauge_height = arguments.gauge_height};
  if (!arguments.tape_line.empty()) measures.tape_line = arguments.tape_line.front();
  return measures;
}

// The table

void add_length(QuantityTable& table, const std::string& name, const std::optional<double>& length) {
  length ? table.add(name, *length * 1e3, "mm") : table.add(name, std::vector<std::string>{"not reached"});
}

void add_dimensions(QuantityTable& table, const cases::ProfileFindings& findings) {
  if (findings.wheel) {
    table.add("y of the tape line", findings.wheel->tape_line * 1e3, "mm");
    add_length(table, "z of the tape circle", findings.wheel->tape_circle);
    add_length(table, "flange height Sh", findings.wheel->flange_height);
    add_length(table, "flange thickness Sd", findings.wheel->flange_thickness);
    add_length(table, "flange gradient qR", findings.wheel->flange_gradient);
    if (const auto angle = findings.wheel->flange_angle)
      table.add("flange angle", *angle * 180 / std::numbers::pi, "deg");
  }
  if (findings.gauge) {
    table.add("y of the gauge point", findings.gauge->point.y * 1e3, "mm",
              findings.gauge->reaches_height ? "" : "the profile ends above the gauge's height");
    table.add("z of the gauge point", findings.gauge->point.z * 1e3, "mm");
    table.add("y of the top", findings.gauge->top.y * 1e3, "mm");
    table.add("z of the top", findings.gauge->top.z * 1e3, "mm");
  }
}

void print_table(const cases::ProfileFindings& findings) {
  const auto& profile = findings.prepared.profile;
  const auto& report = findings.prepared.report;
  QuantityTable table(fmt::format("{}, {}", to_string(profile.role()), report.format));
  table.round_to_zero("mm", 1e6); // 0.1 nm
  table.add("points read", static_cast<double>(report.points_read), "-");
  table.add("points of the spline", static_cast<double>(report.points), "-");
  table.add("length of the curve", profile.length() * 1e3, "mm");
  table.add("kinks", static_cast<double>(report.kinks.size()), "-");
  table.add("scatter of the points", report.noise.deviation * 1e6, "um");
  table.add("scatter of curvature", report.noise.curvature, "1/m");
  if (report.smoothing.by_noise) {
    table.add("curvature, 6 mm +-", report.smoothing.curvature_left, "1/m");
    table.add("peak pressure +-", report.smoothing.pressure_left * 100, "%", "straight tread on head of 300 mm");
  }
  add_dimensions(table, findings);
  table.print();
}

void print_list(const std::string& heading, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  fmt::print("\n{}\n", heading);
  for (const auto& line : lines) fmt::print("  {}\n", line);
}

std::vector<std::string> kink_lines(const std::vector<ProfileKink>& kinks) {
  std::vector<std::string> lines;
  for (const auto& kink : kinks)
    lines.push_back(fmt::format("({:.4g}, {:.4g}) mm, by {:.3g} deg", kink.point.y * 1e3, kink.point.z * 1e3,
                                kink.angle * 180 / std::numbers::pi));
  return lines;
}

void print_text(const cases::ProfileFindings& findings) {
  const auto& report = findings.prepared.report;
  if (!report.comment.empty()) fmt::print("{}\n\n", report.comment);
  print_table(findings);
  print_list("Done to the points", report.steps);
  print_list("Assumed, since neither the file nor an option says it", report.assumptions);
  print_list("Kinks", kink_lines(report.kinks));
}

// The document

void print_document(const ProfileArguments& arguments, const cases::ProfileFindings& findings,
                    const std::vector<std::string>& files) {
  auto document = json_document("profile");
  document["input"] = arguments.file.string();
  document.update(cases::profile_document(findings));
  document["files"] = files;
  print_json(document);
}

// Files

void write_result(const ProfileArguments& arguments, const cases::ProfileFindings& findings, const fs::path& path) {
  io::create_folder(arguments.folder);
  io::ResultFile file(path, {.kind = "profile",
                             .title = arguments.file.filename().string(),
                             .command_line = command_line(),
                             .case_file = arguments.file.string()});
  cases::write_result(findings, file);
  file.commit();
  InterruptGuard::throw_if_interrupted();
}

void convert(const ProfileArguments& arguments, const PreparedProfile& prepared) {
  const auto format = io::format_of_ending(arguments.converted, prepared.profile.role());
  io::OutputFile file(arguments.converted);
  file.write(io::profile_text(prepared, format));
  file.commit();
}

std::vector<std::string> write_files(const ProfileArguments& arguments, const cases::ProfileFindings& findings) {
  std::vector<std::string> files;
  if (!arguments.converted.empty()) {
    convert(arguments, findings.prepared);
    files.push_back(arguments.converted.string());
  }
  if (arguments.folder.empty()) return files;
  const auto path = arguments.folder / io::result_name;
  write_result(arguments, findings, path);
  files.push_back(path.string());
  if (arguments.no_pictures) return files;
  for (const auto& picture : draw_pictures(path, arguments.folder)) files.push_back(picture);
  return files;
}

/// A file of slices is shown as a whole; the other things are done with each of its profiles.
void run_slices(const ProfileArguments& arguments) {
  if (!arguments.converted.empty())
    throw Error(arguments.file.string() + ": --convert needs the file of one profile, not of slices");
  show_slices({.file = arguments.file,
               .options = options_of(arguments),
               .folder = arguments.folder,
               .no_pictures = arguments.no_pictures,
               .json = arguments.json});
}

int run_folder(const ProfileArguments& arguments) {
  if (!arguments.converted.empty())
    throw Error(arguments.file.string() + ": --convert needs the file of one profile, not a folder");
  return show_profile_folder({.input = arguments.file,
                              .options = options_of(arguments),
                              .measures = measures_of(arguments),
                              .partner = &arguments.partner,
                              .folder = arguments.folder,
                              .no_pictures = arguments.no_pictures,
                              .json = arguments.json});
}

void run_profile(const ProfileArguments& arguments) {
  if (!arguments.converted.empty()) {
    io::require_other_file(arguments.converted, arguments.file);
    io::require_writable_file(arguments.converted);
  }
  if (!arguments.folder.empty()) io::require_writable_file_in(arguments.folder, io::result_name);
  const auto findings =
      cases::find_dimensions(io::read_profile(arguments.file, options_of(arguments)), measures_of(arguments));
  if (!arguments.json) print_text(findings);
  const auto files = write_files(arguments, findings);
  if (arguments.json)
    print_document(arguments, findings, files);
  else
    print_list("Written", files);
  print_warnings(arguments.file.string(), findings.prepared.report.warnings);
}

int run(const ProfileArguments& arguments) {
  if (fs::is_directory(arguments.file) && !io::names_standard(arguments.file)) return run_folder(arguments);
  if (!arguments.partner.file.empty())
    throw Error("--partner: needs a folder; microslip conicity WHEEL RAIL is for two profiles");
  io::names_slices(arguments.file) ? run_slices(arguments) : run_profile(arguments);
  return ExitCode::done;
}

constexpr const char* footer =
    R"(Prints what was read and done to the points, what was assumed, kinks, the scatter of the points, and the flange's
dimensions (EN 15313) or the gauge point [mm]; warnings name what looks wrong. Points that scatter are smoothed, unless
--smoothing-length 0 is given. With --json the same in SI units.
Axes of a profile: y to the field side, z up. A name in place of FILE, S1002, 60E1, 54E1, cone-1:20 or cone-1:40, is the
profile of a standard, if there is no such file. Of a FOLDER all files are measured: a table of them, profiles.csv and all
of them in profiles.png; the exit code is 1 if one could not be read.

Example:
  microslip profile examples/profiles/s1002.prw -o results/s1002
  microslip profile S1002 --flange-thickness 0.0305 --convert thin.prw
  microslip profile measured --partner 60E1 --cant 0.025 -o results/measured)";

} // namespace

void add_profile_command(Command& program, int& exit_code) {
  Command command =
      program.add_subcommand("profile", "Read, check, draw and convert the profile of a wheel or rail", footer);
  ProfileArguments& arguments = command.arguments(exit_code, run);
  command
      .add_option("FILE", arguments.file,
                  "Simpack .prr .prw, MiniProf .ban .whl .mpt, columns of y and z, slices .slcs .slcw, the name of a "
                  "standard's "
                  "profile, or a folder of files")
      .required();
  command.add_option("-o,--output FOLDER", arguments.folder,
                     "folder for result.h5 and profile.png, of slices surface.png; default: none is written");
  command.add_flag("--no-pictures", arguments.no_pictures, "write result.h5 only");
  command.add_option("--convert OUT", arguments.converted,
                     "write the spline's points as .prr, .prw, .ban, .whl, or columns with any other ending");
  command.add_option("--role " + choices<ProfileRole>(), arguments.role,
                     "what it is; default: by the file or its name");
  add_profile_options(command, arguments.options);
  command.add_option("--tape-line Y", arguments.tape_line, "y of a wheel's tape line [m], 70 mm from the flange's back")
      .expected(1);
  arguments.inputs.add(command, "gauge_height", arguments.gauge_height);
  add_partner_options(command, arguments.partner);
  add_json_flag(command, arguments.json);
}

} // namespace microslip::app
