#include "app/profile_options.hpp"

#include "io/length_unit.hpp"
#include "io/option_words.hpp"
#include "microslip/description/input.hpp"

namespace microslip::app {

ProfileOptions::ProfileOptions(const std::string& prefix, const std::string& of)
    : inputs(description::wheel_inputs(), "profile", prefix, of) {}

void add_profile_options(Command& command, ProfileOptions& options) {
  InputOptions& inputs = options.inputs;
  inputs.add(command, "format", options.format);
  inputs.add(command, "unit", options.unit, "mm|m|in");
  inputs.add(command, "scale", options.scale);
  inputs.add(command, "y_axis", options.y_axis);
  inputs.add(command, "z_axis", options.z_axis);
  inputs.add(command, "side", options.side);
  inputs.add(command, "columns", options.columns, "z,y");
  inputs.add(command, "flange_thickness", options.flange_thickness);
  inputs.add(command, "section", options.section, "COUNT");
  inputs.add(command, "trim", options.trim, "Y1 Y2").expected(2);
  inputs.add(command, "smoothing_length", options.smoothing_length);
}

io::ProfileFileOptions file_options(const ProfileOptions& options, std::optional<ProfileRole> role) {
  options.inputs.require();
  const auto read = [&]<class Option>(const char* key, const std::string& word, std::optional<Option>& option) {
    if (!word.empty()) option = io::from_word<Option>(options.inputs.name(key), word);
  };
  io::ProfileFileOptions result;
  result.role = role;
  read("format", options.format, result.format);
  read("y_axis", options.y_axis, result.y_axis);
  read("z_axis", options.z_axis, result.z_axis);
  read("side", options.side, result.side);
  result.columns = options.columns;
  result.flange_thickness = options.flange_thickness;
  if (!options.unit.empty()) result.unit = io::length_of_unit(options.inputs.name("unit"), options.unit);
  result.scale = options.scale;
  result.section = options.section;
  if (options.trim.size() == 2) result.treatment.y_min = options.trim[0], result.treatment.y_max = options.trim[1];
  result.treatment.smoothing_length = options.smoothing_length;
  return result;
}

} // namespace microslip::app
