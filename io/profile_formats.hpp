#pragma once

#include "io/profile_file.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::io {

/// Unit of length that a file states by a word.
struct StatedUnit {
  std::string word, place; ///< place: file and line
};

/// Contents of a file: points in its axes and unit, after what the file itself asks for, and what it says about them.
struct ProfileFile {
  std::string comment = {};
  std::optional<ProfileRole> role = {};
  std::optional<double> unit = {};            ///< length [m] of the unit
  std::optional<StatedUnit> stated_unit = {}; ///< where `unit` does not have it
  std::optional<LateralSense> y_axis = {};
  std::optional<VerticalSense> z_axis = {};
  std::vector<ProfilePoint> points = {};
  std::size_t points_read = 0; ///< those listed
  /// Operations of a Simpack file, which have been done: point.dist.min in the file's unit, mirror.y and mirror.z.
  std::optional<double> least_distance = {};
  bool mirrored_y = false, mirrored_z = false;
  std::vector<std::string> steps = {}, assumptions = {}, warnings = {};
};

/// Lines of a file with their numbers, for messages.
class ProfileLines {
public:
  ProfileLines(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

  /// False at the end.
  bool next();
  /// The line without blanks at its ends.
  std::string_view line() const { return line_; }
  /// The name and the line's number.
  std::string place() const { return name_ + ":" + std::to_string(number_); }
  /// Throws Error that begins with the name and the line's number.
  [[noreturn]] void fail(const std::string& text) const;
  /// Throws Error that begins with the name.
  [[noreturn]] void fail_as_a_whole(const std::string& text) const;
  /// The number in a field, or Error.
  double number(std::string_view field, std::string_view what) const;

private:
  std::string_view rest_, line_;
  std::string name_;
  std::size_t number_ = 0;
};

/// The part of a line before the first of these signs.
std::string_view before_comment(std::string_view line, std::string_view signs);
/// Fields between blanks, or one of these separators with or without blanks.
std::vector<std::string_view> split(std::string_view line, std::string_view separators);
std::string lower_case(std::string_view text);
/// The length [m] of a unit that files of profiles may state: mm, cm, um, m, km, in, inch, inches or ft, in letters of
/// either case; none for another word.
std::optional<double> length_named(std::string_view word);
/// Text without a pair of quotes around it.
std::string_view unquoted(std::string_view text);

/// The text of a file of at most 16 MiB. Throws Error if it cannot be read, is no text or changes meanwhile.
std::string read_profile_text(const std::filesystem::path& path);
/// `section` and `columns` as in ProfileFileOptions.
ProfileFile parse_profile_file(ProfileFormat format, std::string_view text, const std::string& name, int section = 1,
                               const std::string& columns = {});

ProfileFile parse_simpack(ProfileLines lines);
/// `section` as in ProfileFileOptions.
ProfileFile parse_miniprof(ProfileLines lines, int section);
/// `columns` as in ProfileFileOptions.
ProfileFile parse_columns(ProfileLines lines, const std::string& columns);

} // namespace microslip::io
