#pragma once

#include "microslip/railway/problem/wheel_rail_types.hpp"
#include "microslip/railway/profile/profile_preparation.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::io {

/// The grammars of profile files; docs/profile-formats.md has them.
enum class ProfileFormat { simpack, miniprof, columns };
/// Direction of a file's y axis.
enum class LateralSense { field, gauge };
/// Direction of a file's z axis.
enum class VerticalSense { up, down };

/// Data that a profile's file may leave open. What is not given here is taken from the file, else from the format's
/// convention, else from the name or the shape; the report says which.
struct ProfileFileOptions {
  std::optional<ProfileFormat> format = {};
  std::optional<ProfileRole> role = {};
  std::optional<double> unit = {}; ///< length [m] of the file's unit, e.g. 1e-3
  double scale = 1;                ///< factor [-] by which the profile is made larger, > 0
  std::optional<LateralSense> y_axis = {};
  std::optional<VerticalSense> z_axis = {};
  /// Side of the track on which it lies, of a file whose y runs to the left: the direction of y where neither `y_axis`,
  /// the file nor the shape says it.
  std::optional<TrackSide> side = {};
  /// Names of the columns of a file of columns, as "z,y" or "-,y,z"; empty: by headings, else by the shape.
  std::string columns = {};
  std::optional<double> flange_thickness = {}; ///< of a standard's wheel [m], `standard_points`
  int section = 1;                             ///< which of several profiles of a MiniProf .mpt file, from 1
  ProfileTreatment treatment = {};

  friend bool operator==(const ProfileFileOptions&, const ProfileFileOptions&) = default;
};

/// The profile in the text of a file. `name` is the file's, for the format, the role and messages. Throws Error that
/// begins with the name and, if there is one, the line.
PreparedProfile parse_profile(std::string_view text, const std::string& name, const ProfileFileOptions& options = {});

/// The path of a profile that a text names, from `folder` on. The name of a standard's profile
/// (`standard_profile_names`) stays as it is, unless the folder has a file of that name.
std::filesystem::path profile_path(const std::filesystem::path& folder, const std::string& text);

/// Whether a path is the name of a standard's profile and not of a file.
bool names_standard(const std::filesystem::path& path);

/// Reads a file of at most 16 MiB, or makes the profile of a standard whose name the path is, if there is no such file.
/// Throws Error as well if it cannot be read or changes meanwhile, and for options that a standard leaves no room for.
PreparedProfile read_profile(const std::filesystem::path& path, const ProfileFileOptions& options = {});

} // namespace microslip::io
