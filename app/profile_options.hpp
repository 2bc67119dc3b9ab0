#pragma once

#include "app/command.hpp"
#include "io/profile_file.hpp"

#include <optional>
#include <string>
#include <vector>

namespace microslip::app {

/// The options that say of a profile's file what it does not say itself, as they are given.
struct ProfileOptions {
  std::string format = {}, unit = {}, y_axis = {}, z_axis = {};
  double scale = 1, smoothing_length = 0;
  int section = 1;
  std::vector<double> trim = {}; ///< none or two values
  std::string prefix = {};       ///< of the options' names, for messages
};

/// Adds --format, --unit, --y-axis and so on; `prefix` makes --wheel-unit of them, `of` says what they concern.
/// `options` must outlive the command.
void add_profile_options(Command& command, ProfileOptions& options, const std::string& prefix = "",
                         const std::string& of = "the file");

/// Throws Error that names the option.
io::ProfileFileOptions file_options(const ProfileOptions& options, std::optional<ProfileRole> role);

} // namespace microslip::app
