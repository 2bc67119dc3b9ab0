#include "app/profile_folder.hpp"

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/hertz.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/pictures.hpp"
#include "cases/conicity_result.hpp"
#include "io/csv_text.hpp"
#include "io/output_file.hpp"
#include "io/result_file.hpp"
#include "io/slices_file.hpp"
#include "microslip/decimal.hpp"
#include "microslip/description/input.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

constexpr double amplitude = 3e-3; // at which EN 15302 names an equivalent conicity
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A file that was read.
struct MeasuredProfile {
  std::string file;
  cases::ProfileFindings findings;
  double conicity = none;
};

struct RefusedFile {
  std::string file, error;
};

struct ProfileFolder {
  std::vector<MeasuredProfile> profiles;
  std::vector<RefusedFile> refused;
};

/// A number of each profile: its column in tables, in the document's unit and in the one that is printed.
struct Column {
  const char *name, *unit, *head, *shown_unit;
  double factor;
  int decimals;                    ///< that are printed
  std::optional<ProfileRole> role; ///< of both if empty
  std::function<double(const MeasuredProfile&)> value;
};

double or_none(const std::optional<double>& value) {
  return value.value_or(none);
}

std::vector<Column> columns() {
  const auto of_wheel = [](std::optional<double> WheelDimensions::*member) {
    return
        [=](const MeasuredProfile& one) { return one.findings.wheel ? or_none((*one.findings.wheel).*member) : none; };
  };
  const auto of_gauge = [](ProfilePoint GaugePoint::*point, double ProfilePoint::*coordinate) {
    return [=](const MeasuredProfile& one) {
      return one.findings.gauge ? ((*one.findings.gauge).*point).*coordinate : none;
    };
  };
  constexpr auto wheel = ProfileRole::wheel, rail = ProfileRole::rail;
  constexpr double degree = 180 / std::numbers::pi;
  return {
      {"points",
       "-",
       "points",
       "",
       1,
       0,
       {},
       [](auto& one) { return static_cast<double>(one.findings.prepared.report.points); }},
      {"flange_height", "m", "Sh", "mm", 1e3, 3, wheel, of_wheel(&WheelDimensions::flange_height)},
      {"flange_thickness", "m", "Sd", "mm", 1e3, 3, wheel, of_wheel(&WheelDimensions::flange_thickness)},
      {"flange_gradient", "m", "qR", "mm", 1e3, 3, wheel, of_wheel(&WheelDimensions::flange_gradient)},
      {"flange_angle", "rad", "angle", "deg", degree, 2, wheel, of_wheel(&WheelDimensions::flange_angle)},
      {"tape_line", "m", "tape y", "mm", 1e3, 3, wheel,
       [](auto& one) { return one.findings.wheel ? one.findings.wheel->tape_line : none; }},
      {"tape_circle", "m", "tape z", "mm", 1e3, 3, wheel, of_wheel(&WheelDimensions::tape_circle)},
      {"gauge_y", "m", "gauge y", "mm", 1e3, 3, rail, of_gauge(&GaugePoint::point, &ProfilePoint::y)},
      {"gauge_z", "m", "gauge z", "mm", 1e3, 3, rail, of_gauge(&GaugePoint::point, &ProfilePoint::z)},
      {"top_y", "m", "top y", "mm", 1e3, 3, rail, of_gauge(&GaugePoint::top, &ProfilePoint::y)},
      {"top_z", "m", "top z", "mm", 1e3, 3, rail, of_gauge(&GaugePoint::top, &ProfilePoint::z)},
      {"noise",
       "m",
       "scatter",
       "um",
       1e6,
       2,
       {},
       [](auto& one) { return one.findings.prepared.report.noise.deviation; }},
      {"equivalent_conicity", "-", "conicity", "", 1, 4, {}, [](auto& one) { return one.conicity; }},
      {"warnings",
       "-",
       "warnings",
       "",
       1,
       0,
       {},
       [](auto& one) { return static_cast<double>(one.findings.prepared.report.warnings.size()); }},
  };
}

ProfileRole role_of(const MeasuredProfile& one) {
  return one.findings.prepared.profile.role();
}

// Reading

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && !entry.path().filename().string().starts_with('.') &&
        !io::names_slices(entry.path()))
      files.push_back(entry.path());
  if (files.empty()) throw Error(folder.string() + ": has no files of profiles");
  std::sort(files.begin(), files.end());
  return files;
}

/// The equivalent conicity of wheelsets with both wheels alike, on rails alike.
class Conicities {
public:
  explicit Conicities(const PartnerOptions& options) : options_(options) {
    options.inputs.require();
    if (!options.file.empty()) partner_ = io::read_profile(options.file).profile;
  }

  /// That of a profile with the partner; nothing for one of the partner's role. A note says why there is none.
  double of(const cases::ProfileFindings& findings, std::vector<std::string>& notes) const {
    const Profile& profile = findings.prepared.profile;
    if (!partner_ || partner_->role() == profile.role()) return none;
    const bool is_wheel = profile.role() == ProfileRole::wheel;
    const WheelsetSearch::Side side{is_wheel ? *partner_ : profile, is_wheel ? profile : *partner_};
    try {
      const auto result = cases::find_conicity(input_for(side.wheel), side, side, true);
      if (std::isnan(result.conicity.front()))
        notes.push_back("no periodic motion with 3 mm, so no equivalent conicity");
      return result.conicity.front();
    } catch (const Error& error) {
      notes.push_back(std::string("no equivalent conicity: ") + error.what());
      return none;
    }
  }

private:
  cases::ConicityInput input_for(const Profile& wheel) const {
    cases::ConicityInput input{.amplitudes = {amplitude}};
    input.track.gauge = options_.gauge.front();
    input.track.cant = options_.cant;
    input.wheelset.nominal_radius = options_.nominal_radius;
    input.wheelset.flange_back_distance = options_.flange_back_distance;
    constexpr double back_to_tape = 0.07;
    input.wheelset.tape_circle = default_tape_line(wheel);
    input.wheelset.flange_back_position = *input.wheelset.tape_circle - back_to_tape;
    return input;
  }

  const PartnerOptions& options_;
  std::optional<Profile> partner_;
};

ProfileFolder read(const ProfileFolderArguments& arguments) {
  const Conicities conicities(*arguments.partner);
  ProfileFolder folder;
  for (const auto& path : files_of(arguments.input)) {
    InterruptGuard::throw_if_interrupted();
    const std::string name = path.filename().string();
    try {
      auto findings = cases::find_dimensions(io::read_profile(path, arguments.options), arguments.measures);
      const double conicity = conicities.of(findings, findings.prepared.report.warnings);
      folder.profiles.push_back({name, std::move(findings), conicity});
    } catch (const Error& error) {
      folder.refused.push_back({name, error.what()});
    }
  }
  return folder;
}

// The table

std::string cell(const Column& column, const MeasuredProfile& one) {
  const double shown = std::pow(10., column.decimals),
               value = std::round(column.value(one) * column.factor * shown) / shown;
  return std::isnan(value) ? "-" : fmt::format("{:.{}f}", value + 0., column.decimals); // no -0
}

std::vector<Column> columns_of(ProfileRole role, bool with_conicity) {
  std::vector<Column> chosen;
  for (auto& column : columns())
    if ((!column.role || *column.role == role) &&
        (with_conicity || std::string_view(column.name) != "equivalent_conicity"))
      chosen.push_back(std::move(column));
  return chosen;
}

void print_table(const ProfileFolder& folder, ProfileRole role, bool with_conicity) {
  std::vector<std::vector<std::string>> lines(2, std::vector<std::string>{""});
  const auto chosen = columns_of(role, with_conicity);
  for (const auto& column : chosen) lines[0].emplace_back(column.head), lines[1].emplace_back(column.shown_unit);
  for (const auto& one : folder.profiles) {
    if (role_of(one) != role) continue;
    lines.push_back({one.file});
    for (const auto& column : chosen) lines.back().push_back(cell(column, one));
  }
  if (lines.size() == 2) return;
  lines[0][0] =
      fmt::format("{} {}", lines.size() - 2, lines.size() == 3 ? to_string(role) : std::string(to_string(role)) + "s");
  std::vector<std::size_t> widths(chosen.size() + 1, 0);
  for (const auto& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], line[k].size());
  for (const auto& line : lines) {
    std::string text = fmt::format("{:<{}}", line[0], widths[0]);
    for (std::size_t k = 1; k < line.size(); ++k) text += fmt::format("  {:>{}}", line[k], widths[k]);
    fmt::print("{}\n", text.substr(0, text.find_last_not_of(' ') + 1));
  }
  fmt::print("\n");
}

void print_text(const ProfileFolder& folder, bool with_conicity) {
  print_table(folder, ProfileRole::wheel, with_conicity);
  print_table(folder, ProfileRole::rail, with_conicity);
  if (folder.refused.empty()) return;
  fmt::print("Not read\n");
  for (const auto& one : folder.refused) fmt::print("  {}\n", one.error);
}

// The document

void print_document(const ProfileFolderArguments& arguments, const ProfileFolder& folder,
                    const std::vector<std::string>& files) {
  auto document = json_document("profiles");
  document["input"] = arguments.input.string();
  document["profiles"] = io::Json::array();
  for (const auto& one : folder.profiles) {
    auto entry = cases::profile_document(one.findings);
    entry["file"] = one.file;
    entry["equivalent_conicity"] = std::isnan(one.conicity) ? io::Json() : io::Json(one.conicity);
    document["units"] = entry["units"];
    entry.erase("units");
    document["profiles"].push_back(std::move(entry));
  }
  document["refused"] = io::Json::array();
  for (const auto& one : folder.refused) document["refused"].push_back({{"file", one.file}, {"error", one.error}});
  document["files"] = files;
  print_json(document);
}

// Files

void write_table(const ProfileFolder& folder, const fs::path& path) {
  std::string text = "file,role";
  const auto all = columns();
  for (const auto& column : all) text += fmt::format(",{} [{}]", column.name, column.unit);
  text += ",error\n";
  for (const auto& one : folder.profiles) {
    text += io::csv_field(one.file) + "," + std::string(to_string(role_of(one)));
    for (const auto& column : all) {
      const double value = column.value(one);
      text += "," + (std::isnan(value) ? "" : shortest_text(value));
    }
    text += ",\n";
  }
  for (const auto& one : folder.refused)
    text += io::csv_field(one.file) + "," + std::string(all.size(), ',') + "," + io::csv_field(one.error) + "\n";
  io::OutputFile file(path);
  file.write(text);
  file.commit();
}

/// The point at which pictures lay profiles over one another: a wheel's tape circle, of a rail the gauge point's y and
/// the top's z.
ProfilePoint common_point(const cases::ProfileFindings& findings) {
  if (findings.gauge) return {findings.gauge->point.y, findings.gauge->top.z};
  return {findings.wheel->tape_line, findings.wheel->tape_circle.value_or(0)};
}

void write_result(const ProfileFolderArguments& arguments, const ProfileFolder& folder, const fs::path& path) {
  io::ResultFile file(path, {.kind = "profiles",
                             .title = fs::weakly_canonical(arguments.input).filename().string(),
                             .command_line = command_line(),
                             .case_file = arguments.input.string()});
  for (std::size_t k = 0; k < folder.profiles.size(); ++k) {
    const auto& one = folder.profiles[k];
    const std::string group = fmt::format("profiles/{:04}/", k);
    const ProfilePoint origin = common_point(one.findings);
    std::vector<double> y, z;
    for (const auto& p : one.findings.prepared.points) y.push_back(p.y - origin.y), z.push_back(p.z - origin.z);
    file.text(group + "file", one.file, "name of the file");
    file.text(group + "role", std::string(to_string(role_of(one))), "rail or wheel");
    file.array(group + "y", y, "m",
               "y from the tape line of a wheel, from the gauge point of a rail, to the field side");
    file.array(group + "z", z, "m", "z from the tape circle of a wheel, from the top of a rail, up");
    for (const auto& column : columns())
      if (const double value = column.value(one); !std::isnan(value))
        file.scalar(group + column.name, value, column.unit, column.head);
  }
  file.commit();
}

std::vector<std::string> write_files(const ProfileFolderArguments& arguments, const ProfileFolder& folder) {
  if (arguments.folder.empty()) return {};
  io::create_folder(arguments.folder);
  const auto table = arguments.folder / "profiles.csv", result = arguments.folder / io::result_name;
  write_table(folder, table);
  write_result(arguments, folder, result);
  std::vector<std::string> files{table.string(), result.string()};
  if (arguments.no_pictures || folder.profiles.empty()) return files;
  for (const auto& picture : draw_pictures(result, arguments.folder)) files.push_back(picture);
  return files;
}

} // namespace

void add_partner_options(Command& command, PartnerOptions& options) {
  command.add_option("--partner FILE", options.file,
                     "of a folder: rail for its wheels, or wheel for its rails, for the equivalent conicity at 3 mm");
  options.inputs.add(command, "gauge", options.gauge, "GAUGE").expected(1);
  options.inputs.add(command, "cant", options.cant);
  options.inputs.add(command, "nominal_radius", options.nominal_radius);
  options.inputs.add(command, "flange_back_distance", options.flange_back_distance);
}

int show_profile_folder(const ProfileFolderArguments& arguments) {
  if (!arguments.folder.empty()) io::require_writable_file_in(arguments.folder, io::result_name);
  const ProfileFolder folder = read(arguments);
  if (!arguments.json) print_text(folder, !arguments.partner->file.empty());
  const auto files = write_files(arguments, folder);
  if (arguments.json) {
    print_document(arguments, folder, files);
  } else if (!files.empty()) {
    fmt::print("\nWritten\n");
    for (const auto& file : files) fmt::print("  {}\n", file);
  }
  for (const auto& one : folder.profiles) print_warnings(one.file, one.findings.prepared.report.warnings);
  return folder.refused.empty() ? ExitCode::done : ExitCode::not_met;
}

} // namespace microslip::app
