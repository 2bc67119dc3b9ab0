#include "app/commands.hpp"

#include "app/command_line.hpp"
#include "app/hertz.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/pictures.hpp"
#include "app/profile_options.hpp"
#include "app/quantity_table.hpp"
#include "cases/conicity_result.hpp"
#include "io/option_words.hpp"
#include "io/output_file.hpp"
#include "io/result_file.hpp"
#include "microslip/description/input.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/geometry/wheelset_contact_quantities.hpp"

#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

struct ConicityArguments {
  fs::path wheel, rail, right_wheel, right_rail, folder;
  ProfileOptions wheel_options{"wheel-", "WHEEL"}, rail_options{"rail-", "RAIL"};
  InputOptions inputs{description::conicity_inputs()};
  std::vector<double> gauges;
  Track track = {};
  Wheelset wheelset = {};
  std::optional<double> curve_radius;
  double contact_distance = 0;
  std::string roll;
  std::vector<double> amplitudes; ///< from, to, step
  bool no_pictures = false, json = false;
};

/// Results at each of the gauges.
struct ConicityResults {
  std::vector<double> amplitudes;
  std::vector<cases::ConicityResult> gauges;
  std::vector<std::string> warnings;
};

/// The profiles of both sides; the right side's are the left one's unless they are given.
class Profiles {
public:
  explicit Profiles(const ConicityArguments& arguments) {
    const auto read = [&](const fs::path& path, const ProfileOptions& options, ProfileRole role) {
      const PreparedProfile prepared = io::read_profile(path, file_options(options, role));
      for (const auto& warning : prepared.report.warnings) warnings_.push_back(path.string() + ": " + warning);
      return prepared.profile;
    };
    wheels_.push_back(read(arguments.wheel, arguments.wheel_options, ProfileRole::wheel));
    rails_.push_back(read(arguments.rail, arguments.rail_options, ProfileRole::rail));
    if (!arguments.right_wheel.empty())
      wheels_.push_back(read(arguments.right_wheel, arguments.wheel_options, ProfileRole::wheel));
    if (!arguments.right_rail.empty())
      rails_.push_back(read(arguments.right_rail, arguments.rail_options, ProfileRole::rail));
  }

  bool symmetric() const { return wheels_.size() == 1 && rails_.size() == 1; }
  WheelsetSearch::Side left() const { return {rails_.front(), wheels_.front()}; }
  WheelsetSearch::Side right() const { return {rails_.back(), wheels_.back()}; }

  const std::vector<std::string>& warnings() const { return warnings_; }

private:
  std::vector<Profile> wheels_, rails_;
  std::vector<std::string> warnings_;
};

cases::ConicityInput input_of(const ConicityArguments& arguments, double gauge, const std::vector<double>& amplitudes) {
  cases::ConicityInput input{.track = arguments.track,
                             .wheelset = arguments.wheelset,
                             .contact_distance = arguments.contact_distance,
                             .roll = io::from_word<RollRule>("--roll", arguments.roll),
                             .amplitudes = amplitudes,
                             .curve_radius = arguments.curve_radius};
  input.track.gauge = gauge;
  return input;
}

ConicityResults solve(const ConicityArguments& arguments, const Profiles& profiles) {
  ConicityResults result;
  const auto& range = arguments.amplitudes;
  result.amplitudes = cases::amplitude_range("--amplitudes", range[0], range[1], range[2]);
  result.warnings = profiles.warnings();
  for (const double gauge : arguments.gauges) {
    const cases::ConicityInput input = input_of(arguments, gauge, result.amplitudes);
    result.gauges.push_back(cases::find_conicity(input, profiles.left(), profiles.right(), profiles.symmetric()));
    for (std::size_t k = 0; k < result.amplitudes.size(); ++k)
      if (std::isnan(result.gauges.back().conicity[k])) {
        result.warnings.push_back(
            fmt::format("gauge {:.6g} m: no periodic motion with amplitudes from {:.4g} mm: a wheel leaves its rail or "
                        "steers outward",
                        gauge, result.amplitudes[k] * 1e3));
        break;
      }
  }
  return result;
}

void print_text(const ConicityArguments& arguments, const ConicityResults& result) {
  std::vector<std::string> heads;
  for (const auto& one : result.gauges) heads.push_back(fmt::format("gauge {:.6g} m", one.gauge));
  QuantityTable table("Equivalent conicity", heads);
  // at most some 15 lines
  const std::size_t stride = (result.amplitudes.size() + 14) / 15;
  const auto row = [&](const std::string& name, auto value, const std::string& unit) {
    std::vector<double> values;
    for (const auto& one : result.gauges) values.push_back(value(one));
    table.add(name, values, unit);
  };
  for (std::size_t k = 0; k < result.amplitudes.size(); k += stride)
    row(
        fmt::format("amplitude {:.4g} mm", result.amplitudes[k] * 1e3), [&](auto& one) { return one.conicity[k]; },
        "-");
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  row(
      "nonlinearity parameter", [&](auto& one) { return one.nonlinearity.value_or(none) * 1e-3; }, "1/mm");
  const double largest = result.amplitudes.back();
  if (arguments.curve_radius)
    row(
        fmt::format("radial steering index at {:.4g} mm", largest * 1e3),
        [&](auto& one) { return *cases::steering_index(input_of(arguments, one.gauge, result.amplitudes), one); }, "-");
  table.print();
}

void print_document(const ConicityArguments& arguments, const Profiles& profiles, const ConicityResults& result,
                    const std::vector<std::string>& files) {
  auto document = json_document("conicity");
  document["wheel"] = arguments.wheel.string();
  document["rail"] = arguments.rail.string();
  if (!arguments.right_wheel.empty()) document["right_wheel"] = arguments.right_wheel.string();
  if (!arguments.right_rail.empty()) document["right_rail"] = arguments.right_rail.string();
  document["nominal_radius"] = io::json_number(arguments.wheelset.nominal_radius);
  document["contact_distance"] = io::json_number(arguments.contact_distance);
  document["roll_rule"] = arguments.roll;
  const auto document_of = [&](const cases::ConicityResult& one) {
    return cases::conicity_document(input_of(arguments, one.gauge, result.amplitudes), one, profiles.left(),
                                    profiles.right());
  };
  document.update(document_of(result.gauges.front()));
  if (result.gauges.size() > 1) {
    document["gauges"] = io::Json::array();
    for (const auto& one : result.gauges) document["gauges"].push_back(document_of(one));
  }
  document["units"] = cases::conicity_units();
  document["warnings"] = result.warnings;
  document["files"] = files;
  print_json(document);
}

void write_curve(io::ResultFile& file, const std::string& group, const WheelsetCurve& curve, const Profiles& profiles) {
  const auto write = [&](const std::string& name, const auto& value, const std::string& unit, const std::string& what) {
    std::vector<double> values;
    for (const WheelsetContact& contact : curve) values.push_back(value(contact));
    file.array(group + "/" + name, values, unit, what);
  };
  const WheelsetSearch::Side left = profiles.left(), right = profiles.right();
  for (const WheelsetContactQuantity& q : wheelset_contact_quantities())
    write(
        q.name, [&](const WheelsetContact& contact) { return q.value(contact, left, right); }, q.unit, q.description);
  const auto write_height = [&](const std::string& name, const Profile& profile, const auto& s_of) {
    write(
        name + "_z", [&](const WheelsetContact& contact) { return profile.at(s_of(contact)).value.z; }, "m",
        "point of contact on the profile, up");
  };
  using Contact = const WheelsetContact&;
  write_height("left_rail", left.rail, [](Contact c) { return c.left.s_rail; });
  write_height("left_wheel", left.wheel, [](Contact c) { return c.left.s_wheel; });
  write_height("right_rail", right.rail, [](Contact c) { return c.right.s_rail; });
  write_height("right_wheel", right.wheel, [](Contact c) { return c.right.s_wheel; });
}

/// The curve of a profile in its axes, by points a quarter of a millimetre apart.
void write_profile(io::ResultFile& file, const std::string& group, const Profile& profile) {
  std::vector<double> y, z;
  const int count = static_cast<int>(profile.length() / 0.25e-3) + 1;
  for (int k = 0; k <= count; ++k) {
    const ProfilePoint point = profile.at(profile.length() * k / count).value;
    y.push_back(point.y), z.push_back(point.z);
  }
  file.array(group + "/y", y, "m", "to the field side");
  file.array(group + "/z", z, "m", "up");
}

std::string title_of(const ConicityArguments& arguments) {
  std::string title = arguments.wheel.filename().string() + " on " + arguments.rail.filename().string();
  if (arguments.right_wheel.empty() && arguments.right_rail.empty()) return title;
  const auto right = [](const fs::path& other, const fs::path& left) {
    return (other.empty() ? left : other).filename().string();
  };
  return title + ", right " + right(arguments.right_wheel, arguments.wheel) + " on " +
         right(arguments.right_rail, arguments.rail);
}

void write_result(const ConicityArguments& arguments, const Profiles& profiles, const ConicityResults& result,
                  const fs::path& path) {
  io::create_folder(arguments.folder);
  io::ResultFile file(
      path, {.kind = "conicity", .title = title_of(arguments), .command_line = command_line(), .case_file = ""});
  file.array("amplitude", result.amplitudes, "m", "amplitudes of the lateral displacement");
  std::vector<double> gauges;
  for (std::size_t k = 0; k < result.gauges.size(); ++k) {
    const cases::ConicityResult& one = result.gauges[k];
    const std::string group = "gauge_" + std::to_string(k);
    gauges.push_back(one.gauge);
    file.array(group + "/conicity", one.conicity, "-", "equivalent conicity over the amplitudes");
    file.array(group + "/wavelength", one.wavelength, "m", "kinematic wavelength over the amplitudes");
    write_curve(file, group + "/curve", one.curve, profiles);
  }
  file.array("gauges", gauges, "m", "gauges, in the order of the groups gauge_0, gauge_1 and so on");
  const auto write_side = [&](const std::string& side, const WheelsetSearch::Side& pair) {
    write_profile(file, "profiles/" + side + "_rail", pair.rail);
    write_profile(file, "profiles/" + side + "_wheel", pair.wheel);
  };
  write_side("left", profiles.left());
  if (!profiles.symmetric()) write_side("right", profiles.right());
  file.commit();
  InterruptGuard::throw_if_interrupted();
}

std::vector<std::string> write_files(const ConicityArguments& arguments, const Profiles& profiles,
                                     const ConicityResults& result) {
  if (arguments.folder.empty()) return {};
  const auto path = arguments.folder / io::result_name;
  write_result(arguments, profiles, result, path);
  std::vector<std::string> files{path.string()};
  if (arguments.no_pictures) return files;
  for (const auto& picture : draw_pictures(path, arguments.folder)) files.push_back(picture);
  return files;
}

void run(const ConicityArguments& arguments) {
  arguments.inputs.require();
  if (!arguments.folder.empty()) io::require_writable_file_in(arguments.folder, io::result_name);
  const Profiles profiles(arguments);
  const auto result = solve(arguments, profiles);
  if (!arguments.json) print_text(arguments, result);
  const auto files = write_files(arguments, profiles, result);
  if (arguments.json) {
    print_document(arguments, profiles, result, files);
  } else if (!files.empty()) {
    fmt::print("\nWritten\n");
    for (const auto& file : files) fmt::print("  {}\n", file);
  }
  print_warnings("conicity", result.warnings);
}

void add_options(Command& command, ConicityArguments& arguments) {
  const auto path = [&](const char* name, fs::path& value, const char* what) {
    return command.add_option(name, value, what);
  };
  path("WHEEL", arguments.wheel,
       "profile of both wheels, or of the left one: .prw, .whl, columns of y and z, or a standard's name, as S1002")
      .required();
  path("RAIL", arguments.rail,
       "profile of both rails, or of the left one: .prr, .ban, columns of y and z, or a standard's name, as 60E1")
      .required();
  path("--right-wheel FILE", arguments.right_wheel,
       "profile of the right wheel, if it is another one; read as WHEEL is");
  path("--right-rail FILE", arguments.right_rail, "profile of the right rail, if it is another one; read as RAIL is");
  InputOptions& inputs = arguments.inputs;
  inputs.add(command, "gauge", arguments.gauges, "GAUGE...").expected(1, 100);
  inputs.add(command, "gauge_height", arguments.track.gauge_height);
  inputs.add(command, "cant", arguments.track.cant);
  inputs.add(command, "nominal_radius", arguments.wheelset.nominal_radius);
  inputs.add(command, "tape_circle", arguments.wheelset.tape_circle);
  inputs.add(command, "flange_back_distance", arguments.wheelset.flange_back_distance);
  inputs.add(command, "flange_back_position", arguments.wheelset.flange_back_position);
  inputs.add(command, "contact_distance", arguments.contact_distance);
  inputs.add(command, "roll", arguments.roll);
  inputs.add(command, "amplitudes", arguments.amplitudes, "FROM TO STEP").expected(3);
  inputs.add(command, "curve_radius", arguments.curve_radius);
  add_profile_options(command, arguments.wheel_options);
  add_profile_options(command, arguments.rail_options);
  command.add_option("-o,--output FOLDER", arguments.folder,
                     "folder for result.h5 and pictures; default: none is written");
  command.add_flag("--no-pictures", arguments.no_pictures, "write result.h5 only");
  add_json_flag(command, arguments.json);
}

constexpr const char* footer =
    R"(Prints the equivalent conicity (EN 15302) [-] over the amplitude [mm] and the nonlinearity parameter [1/mm]. With
--json the same in SI units, equivalent_conicity as pairs of amplitude [m] and conicity, and the rolling radius
difference [m], the contact angle difference [rad], roll [rad] and height [m] over the lateral displacement.

Example:
  microslip conicity examples/profiles/s1002.prw examples/profiles/60e1.prr --cant 0.025)";

} // namespace

void add_conicity_command(Command& program) {
  Command command =
      program.add_subcommand("conicity", "Rolling radius difference and equivalent conicity of a wheelset", footer);
  ConicityArguments& arguments = command.arguments(run);
  add_options(command, arguments);
}

} // namespace microslip::app
