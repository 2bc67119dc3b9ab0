#pragma once

#include "microslip/railway/profile/profile_preparation.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::io {

/// The grammars of profile files; docs/profiles.md has them.
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
  int section = 1; ///< which of several profiles of a MiniProf .mpt file, from 1
  ProfileTreatment treatment = {};

  friend bool operator==(const ProfileFileOptions&, const ProfileFileOptions&) = default;
};

/// The profile in the text of a file. `name` is the file's, for the format, the role and messages. Throws Error that
/// begins with the name and, if there is one, the line.
PreparedProfile parse_profile(std::string_view text, const std::string& name, const ProfileFileOptions& options = {});

/// Reads a file of at most 16 MiB. Throws Error as well if it cannot be read or changes meanwhile.
PreparedProfile read_profile(const std::filesystem::path& path, const ProfileFileOptions& options = {});

} // namespace microslip::io
