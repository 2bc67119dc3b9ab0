#pragma once

#include "app/input_options.hpp"
#include "io/profile_file.hpp"

#include <optional>
#include <string>
#include <vector>

namespace microslip::app {

/// The options that say of a profile's file what it does not say itself, as they are given.
struct ProfileOptions {
  /// `prefix` makes --wheel-unit of --unit, `of` says in texts which file it is.
  explicit ProfileOptions(const std::string& prefix = "", const std::string& of = "");
  ProfileOptions(const ProfileOptions&) = delete;
  ProfileOptions& operator=(const ProfileOptions&) = delete;

  InputOptions inputs;
  std::string format = {}, unit = {}, y_axis = {}, z_axis = {}, side = {}, columns = {}; ///< empty: not given
  double scale = 1;
  std::optional<double> smoothing_length = {}, flange_thickness = {};
  int section = 1;
  std::vector<double> trim = {}; ///< none or two values
};

/// Adds --format, --unit, --y-axis and so on; `options` must outlive the command.
void add_profile_options(Command& command, ProfileOptions& options);

/// Throws Error that names the option.
io::ProfileFileOptions file_options(const ProfileOptions& options, std::optional<ProfileRole> role);

} // namespace microslip::app
