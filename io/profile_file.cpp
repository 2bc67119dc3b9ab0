#include "io/profile_file.hpp"

#include "io/input_file.hpp"
#include "io/nearest_word.hpp"
#include "io/profile_formats.hpp"
#include "io/text_line.hpp"
#include "io/units.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/profile/report_text.hpp"
#include "microslip/railway/profile/standard_profile.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

namespace microslip::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_file = std::size_t{16} << 20;

std::string extension(const std::string& name) {
  return lower_case(fs::path(name).extension().string());
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string_view name_of(ProfileFormat format) {
  constexpr std::array<std::string_view, 3> names = {"Simpack", "MiniProf", "columns"};
  return names[static_cast<std::size_t>(format)];
}

/// Format by the first lines, else by the name.
ProfileFormat detect_format(std::string_view text, const std::string& name) {
  constexpr int lines_to_see = 200;
  for (int k = 0; k < lines_to_see && !text.empty(); ++k) {
    const auto line = trimmed(take_line(text));
    if (is_one_of(line.substr(0, line.find_first_of(" \t!%")), {"header.begin", "spline.begin", "point.begin"}))
      return ProfileFormat::simpack;
    const auto lower = lower_case(line);
    if (k < 3 && lower.find("mini") < lower.find("prof") && lower.find("prof") != std::string::npos)
      return ProfileFormat::miniprof;
    if (line.starts_with("[FileInfo]") ||
        (!line.empty() && line.find_first_of("#!/%*;") != 0 && line.find('=') != std::string_view::npos))
      return ProfileFormat::miniprof;
  }
  const auto ending = extension(name);
  if (is_one_of(ending, {".prr", ".prw"})) return ProfileFormat::simpack;
  if (is_one_of(ending, {".ban", ".whl", ".mpt"})) return ProfileFormat::miniprof;
  return ProfileFormat::columns;
}

std::optional<ProfileRole> role_by_name(const std::string& name) {
  const auto ending = extension(name);
  if (is_one_of(ending, {".prr", ".ban"})) return ProfileRole::rail;
  if (is_one_of(ending, {".prw", ".whl"})) return ProfileRole::wheel;
  const auto stem = lower_case(fs::path(name).stem().string());
  const bool rail = stem.find("rail") != std::string::npos, wheel = stem.find("wheel") != std::string::npos;
  if (rail == wheel) return {};
  return rail ? ProfileRole::rail : ProfileRole::wheel;
}

/// Makes of a file's points what stands in a profile's axes, and notes how.
class FileInterpretation {
public:
  FileInterpretation(ProfileFile file, const std::string& name, ProfileFormat format, const ProfileFileOptions& options)
      : file_(std::move(file)), name_(name), format_(format), options_(options) {
    report_.source = name;
    report_.format = name_of(format);
    report_.comment = file_.comment;
    report_.points_read = file_.points_read;
    report_.steps = file_.steps;
    report_.assumptions = file_.assumptions;
    report_.warnings = file_.warnings;
  }

  PreparedProfile profile() {
    const auto role = find_role();
    scale_points();
    turn_axes(role);
    return prepare_profile(role, std::move(file_.points), options_.treatment, std::move(report_));
  }

private:
  [[noreturn]] void fail(const std::string& text) const { throw Error(name_ + ": " + text); }

  void assume(const std::string& text) { report_.assumptions.push_back(text); }

  ProfileRole find_role() {
    if (options_.role && file_.role && *options_.role != *file_.role)
      fail("is the profile of a " + std::string(to_string(*file_.role)) + ", not of a " +
           std::string(to_string(*options_.role)));
    if (options_.role) return *options_.role;
    if (file_.role) return *file_.role;
    const auto guess = role_by_name(name_);
    if (!guess) fail("neither the file nor its name says whether this is a rail or a wheel; give the role");
    assume("a " + std::string(to_string(*guess)) + ", by the file's name");
    return *guess;
  }

  void scale_points() {
    require_positive("scale", options_.scale, "-");
    if (options_.unit) require_positive("unit", *options_.unit, "m");
    const double unit = options_.unit ? *options_.unit : file_.unit ? *file_.unit : stated_unit();
    report_.unit = unit * options_.scale;
    for (auto& p : file_.points) p = {p.y * report_.unit, p.z * report_.unit};
    if (options_.scale != 1) report_.steps.push_back("scaled by " + digits(options_.scale));
  }

  /// A guess would hide that the file states something else.
  double stated_unit() {
    if (!file_.stated_unit) return unit_by_width();
    const auto& [word, place] = *file_.stated_unit;
    if (const auto length = length_named(word)) return *length;
    std::vector<std::string_view> names;
    for (const OfferedUnit& one : offered_units("m")) names.push_back(one.name);
    throw Error(place + ": " + printable(word) + " is no known unit of length: must be " + listed(names) +
                "; or give the unit, which goes before the file's");
  }

  double unit_by_width() {
    if (file_.points.empty()) fail("has no points within its bounds");
    const auto [left, right] = std::minmax_element(file_.points.begin(), file_.points.end(),
                                                   [](const auto& a, const auto& b) { return a.y < b.y; });
    const double width = right->y - left->y;
    if (width >= 5 && width <= 500) {
      assume("the unit of length is mm, since the profile is " + digits(width) + " wide");
      return 1e-3;
    }
    if (width >= 5e-3 && width <= 0.5) {
      assume("the unit of length is m, since the profile is " + digits(width) + " wide");
      return 1;
    }
    if (width == 0) fail("the profile has no width: " + counted(file_.points.size(), "point") + " with the same y");
    const bool may_be_inches = width >= 1 && width < 5;
    fail("the profile is " + digits(width) + " wide, neither in mm nor in m; give the unit" +
         (may_be_inches ? ", in for inches" : ""));
  }

  void turn_axes(ProfileRole role) {
    const auto z = vertical_sense(role);
    if (z == VerticalSense::down) {
      for (auto& p : file_.points) p.z = -p.z;
      report_.steps.emplace_back("sign of z changed: it is positive downwards in the file");
    }
    if (lateral_sense(role) == LateralSense::gauge) {
      for (auto& p : file_.points) p.y = -p.y;
      report_.steps.emplace_back("mirrored: the file's y runs to the gauge side");
    }
  }

  VerticalSense vertical_sense(ProfileRole role) {
    if (options_.z_axis) return *options_.z_axis;
    if (file_.z_axis) return *file_.z_axis;
    const int sense = sense_of_shape(role, file_.points).z;
    const auto found = sense < 0 ? VerticalSense::down : VerticalSense::up;
    assume(std::string("z is positive ") + (sense < 0 ? "downwards" : "upwards") +
           (sense == 0 ? ", of which the shape says nothing" : ", by the shape"));
    return found;
  }

  LateralSense lateral_sense(ProfileRole role) {
    if (options_.y_axis) return *options_.y_axis;
    if (file_.y_axis) return *file_.y_axis;
    const int sense = sense_of_shape(role, file_.points).y; // z is up by now
    if (sense != 0) {
      assume(std::string("y runs to the ") + (sense > 0 ? "field" : "gauge") + " side, by " +
             (role == ProfileRole::wheel ? "the position of the flange" : "the side that reaches further down"));
      return sense > 0 ? LateralSense::field : LateralSense::gauge;
    }
    if (options_.side) {
      const bool left = *options_.side == TrackSide::left;
      assume(std::string("y runs to the left seen along the track, to the ") +
             (left ? "field side on the left" : "gauge side on the right"));
      return left ? LateralSense::field : LateralSense::gauge;
    }
    const bool to_gauge = format_ == ProfileFormat::miniprof;
    assume(to_gauge ? "y runs to the gauge side, as is usual for MiniProf's right rails" : "y runs to the field side");
    return to_gauge ? LateralSense::gauge : LateralSense::field;
  }

  ProfileFile file_;
  const std::string& name_;
  ProfileFormat format_;
  const ProfileFileOptions& options_;
  ProfileReport report_;
};

/// Text without the mark of UTF-8. Throws Error for what is empty or no text.
std::string_view without_mark(std::string_view text, const std::string& name) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  if (trimmed(text.substr(0, 1)).empty() && text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw Error(name + ": is empty");
  if (text.find('\0') != std::string_view::npos) throw Error(name + ": is not a text file: it has NUL bytes");
  return text;
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

/// The standard's profile that a path without folder names, in letters of either case.
std::optional<StandardProfile> standard_named(const fs::path& path) {
  const auto same = [&](std::string_view name) { return lower_case(name) == lower_case(path.string()); };
  const auto found = std::find_if(standard_profile_names.begin(), standard_profile_names.end(), same);
  if (found == standard_profile_names.end()) return {};
  return static_cast<StandardProfile>(found - standard_profile_names.begin());
}

/// Error for a name that is neither that of a file nor of a standard.
void require_known_name(const fs::path& path) {
  std::error_code ignored;
  if (path.has_extension() || fs::exists(path, ignored)) return;
  throw Error(path.string() + ": there is no such file, nor a standard profile of that name, as " +
              listed(standard_profile_names, "and") + suggestion(path.filename().string(), standard_profile_names));
}

void refuse_options_of_files(const std::string& name, const ProfileFileOptions& options) {
  const ProfileFileOptions none;
  const auto refuse = [&](const char* option, bool given) {
    if (given) throw Error(name + " is the profile of a standard, not a file: " + option + " does not apply");
  };
  refuse("format", options.format != none.format);
  refuse("unit", options.unit != none.unit);
  refuse("scale", options.scale != none.scale);
  refuse("y_axis", options.y_axis != none.y_axis);
  refuse("z_axis", options.z_axis != none.z_axis);
  refuse("side", options.side != none.side);
  refuse("columns", options.columns != none.columns);
  refuse("section", options.section != none.section);
}

PreparedProfile read_standard(StandardProfile standard, const ProfileFileOptions& options) {
  const std::string name(standard_profile_names[static_cast<std::size_t>(standard)]);
  refuse_options_of_files(name, options);
  if (options.role && *options.role != role_of(standard))
    throw Error(name + ": is the profile of a " + std::string(to_string(role_of(standard))) + ", not of a " +
                std::string(to_string(*options.role)));
  return standard_profile(standard, options.flange_thickness, options.treatment);
}

} // namespace

bool ProfileLines::next() {
  if (rest_.empty()) return false;
  line_ = trimmed(take_line(rest_));
  ++number_;
  return true;
}

void ProfileLines::fail(const std::string& text) const {
  throw Error(place() + ": " + text);
}

void ProfileLines::fail_as_a_whole(const std::string& text) const {
  throw Error(name_ + ": " + text);
}

double ProfileLines::number(std::string_view field, std::string_view what) const {
  const auto value = parse_number(field);
  if (!value) fail(std::string(what) + ": " + printable(field) + " is not a finite number");
  return *value;
}

std::string_view before_comment(std::string_view line, std::string_view signs) {
  return trimmed(line.substr(0, line.find_first_of(signs)));
}

std::vector<std::string_view> split(std::string_view line, std::string_view separators) {
  std::vector<std::string_view> fields;
  line = trimmed(line);
  while (!line.empty()) {
    const auto is_end = [&](char c) { return c == ' ' || c == '\t' || separators.find(c) != std::string_view::npos; };
    const auto end = static_cast<std::size_t>(std::find_if(line.begin(), line.end(), is_end) - line.begin());
    fields.push_back(line.substr(0, end));
    line = trimmed(line.substr(end));
    if (!line.empty() && separators.find(line.front()) != std::string_view::npos) line = trimmed(line.substr(1));
  }
  return fields;
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::optional<double> length_named(std::string_view word) {
  std::string name = lower_case(word);
  if (name == "inch" || name == "inches") name = "in";
  for (const std::string_view micro : {"\u00b5", "\u03bc"})
    if (name.starts_with(micro)) name.replace(0, micro.size(), "u");
  for (const OfferedUnit& one : offered_units("m"))
    if (one.name == name) return one.to_si(1);
  return {};
}

std::string_view unquoted(std::string_view text) {
  const bool quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
  return quoted ? text.substr(1, text.size() - 2) : text;
}

ProfileFile parse_profile_file(ProfileFormat format, std::string_view text, const std::string& name, int section,
                               const std::string& columns) {
  ProfileLines lines(without_mark(text, name), name);
  switch (format) {
  case ProfileFormat::simpack:
    return parse_simpack(std::move(lines));
  case ProfileFormat::miniprof:
    return parse_miniprof(std::move(lines), section);
  case ProfileFormat::columns:
    break;
  }
  return parse_columns(std::move(lines), columns);
}

PreparedProfile parse_profile(std::string_view text, const std::string& name, const ProfileFileOptions& options) {
  text = without_mark(text, name);
  const auto format = options.format.value_or(detect_format(text, name));
  if (options.flange_thickness) throw Error(name + ": flange_thickness is for the wheel of a standard, not of a file");
  if (!options.columns.empty() && format != ProfileFormat::columns)
    throw Error(name + ": columns is for files of columns, not of " + std::string(name_of(format)));
  ProfileFile file = parse_profile_file(format, text, name, options.section, options.columns);
  FileInterpretation interpretation(std::move(file), name, format, options);
  return interpretation.profile();
}

std::string read_profile_text(const fs::path& path) {
  const auto name = path.string();
  const auto fail = [&](const std::string& what) { throw Error(name + ": " + what); };
  std::ifstream stream = open_input(path);
  std::error_code error;
  const auto time_before = fs::last_write_time(path, error);
  std::string text;
  std::array<char, 65536> chunk{};
  while (text.size() <= largest_file && stream.read(chunk.data(), chunk.size()).gcount() > 0)
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
  if (stream.bad()) fail("cannot be read");
  if (text.size() > largest_file) fail("is larger than 16 MiB: not a profile");
  const auto size = fs::file_size(path, error);
  if (!error && fs::is_regular_file(path, error) &&
      (size != text.size() || fs::last_write_time(path, error) != time_before))
    fail("changed while it was read");
  return text;
}

fs::path profile_path(const fs::path& folder, const std::string& text) {
  return standard_named(text) && !is_file(folder / text) ? fs::path(text) : folder / text;
}

bool names_standard(const fs::path& path) {
  return standard_named(path) && !is_file(path);
}

PreparedProfile read_profile(const fs::path& path, const ProfileFileOptions& options) {
  if (names_standard(path)) return read_standard(*standard_named(path), options);
  require_known_name(path);
  return parse_profile(read_profile_text(path), path.string(), options);
}

} // namespace microslip::io
