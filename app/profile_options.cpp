#include "app/profile_options.hpp"

#include "app/option_text.hpp"
#include "io/length_unit.hpp"
#include "microslip/error.hpp"

namespace microslip::app {

void add_profile_options(Command& command, ProfileOptions& options, const std::string& prefix, const std::string& of) {
  options.prefix = "--" + prefix;
  const auto add = [&](const char* name, auto& value, const std::string& what, const std::string& type) {
    return command.add_option(options.prefix + std::string(name) + " " + type, value, what);
  };
  add("format", options.format, "grammar of " + of + "; default: by its first lines and its name",
      choices<io::ProfileFormat>());
  add("unit", options.unit, "unit of length in " + of + "; default: what it says, else by its width", "mm|m|in");
  add("scale", options.scale, "factor by which the profile is enlarged", "FACTOR");
  add("y-axis", options.y_axis, "side to which y runs in " + of + "; default: by its format or the flange",
      choices<io::LateralSense>());
  add("z-axis", options.z_axis, "where z is positive in " + of + "; default: by its format or the shape",
      choices<io::VerticalSense>());
  add("section", options.section, "which profile of several in a MiniProf .mpt file, from 1", "N");
  add("trim", options.trim, "drop the ends with y outside Y1 to Y2 [m]", "Y1 Y2").expected(2);
  add("smoothing-length", options.smoothing_length, "wavelength [m] of which smoothing leaves half; 0: none", "LENGTH");
}

io::ProfileFileOptions file_options(const ProfileOptions& options, std::optional<ProfileRole> role) {
  const auto name = [&](const char* option) { return options.prefix + option; };
  io::ProfileFileOptions result;
  result.role = role;
  if (!options.format.empty()) result.format = io::from_word<io::ProfileFormat>(name("format"), options.format);
  if (!options.unit.empty()) result.unit = io::length_of_unit(name("unit"), options.unit);
  if (!options.y_axis.empty()) result.y_axis = io::from_word<io::LateralSense>(name("y-axis"), options.y_axis);
  if (!options.z_axis.empty()) result.z_axis = io::from_word<io::VerticalSense>(name("z-axis"), options.z_axis);
  result.scale = require_positive(name("scale"), options.scale, "-");
  result.section = require_count(name("section"), options.section, 1, 10000);
  if (options.trim.size() == 2) {
    result.treatment.y_min = require_finite(name("trim"), options.trim[0], "m");
    result.treatment.y_max = require_finite(name("trim"), options.trim[1], "m");
  }
  result.treatment.smoothing_length = require_between(name("smoothing-length"), options.smoothing_length, "m", 0, 1);
  return result;
}

} // namespace microslip::app
