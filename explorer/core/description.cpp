#include "explorer/core/description.hpp"

#include "io/units.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/description/input.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

#include <cmath>
#include <string>

namespace microslip::explorer {
namespace {

using description::Input;

io::Json default_of(const Input& input) {
  if (!input.missing_word.empty()) return input.missing_word;
  if (!input.missing_numbers.empty()) return input.missing_numbers;
  return input.missing ? io::json_number(*input.missing) : io::Json();
}

/// What is not there, as a word's bounds, is left out.
io::Json input_json(const Input& input) {
  io::Json all = {{"section", input.section}};
  if (!input.unit.empty()) all["unit"] = input.unit;
  if (const std::string range = input.bounds.text(); !range.empty()) all["range"] = range;
  if (const double least = input.bounds.least(); std::isfinite(least)) all["least"] = least;
  if (const double largest = input.bounds.largest(); std::isfinite(largest)) all["largest"] = largest;
  if (io::Json missing = default_of(input); !missing.is_null()) all["default"] = std::move(missing);
  if (!input.words.empty()) all["words"] = input.words;
  if (!input.only.key.empty()) all["only"] = {{"key", input.only.key}, {"words", input.only.words}};
  all["needed"] = input.is_needed;
  all["state"] = input.is_state;
  all["text"] = input.text;
  return all;
}

template <class Output> io::Json output_json(const Output& output) {
  io::Json all = {{"unit", output.unit}, {"text", output.description}};
  if constexpr (requires { output.label; }) all["label"] = output.label;
  if constexpr (requires { output.symbol; }) all["symbol"] = output.symbol;
  return all;
}

template <class Table> io::Json outputs_json(const Table& table) {
  io::Json all = io::Json::object();
  for (const auto& output : table) all[std::string(output.name)] = output_json(output);
  return all;
}

io::Json units_json(std::string_view unit) {
  io::Json all = io::Json::object();
  for (const io::OfferedUnit& offered : io::offered_units(unit))
    all[std::string(offered.name)] = {offered.to_si.times, offered.to_si.over};
  return all;
}

} // namespace

io::Json description() {
  io::Json inputs = io::Json::object(), units = io::Json::object();
  for (const std::string_view kind : description::case_kinds)
    for (const description::NamedInput& named : description::inputs_of(kind).named()) {
      const Input& input = *named.input;
      inputs[std::string(kind)][named.path] = input_json(input);
      if (!input.unit.empty() && !units.contains(input.unit)) units[std::string(input.unit)] = units_json(input.unit);
    }
  return {{"inputs", std::move(inputs)},
          {"outputs",
           {{"bodies", outputs_json(quantities())},
            {"fields", outputs_json(field_quantities())},
            {"wheel", outputs_json(wheel_quantities())},
            {"patch", outputs_json(patch_quantities())}}},
          {"units", std::move(units)}};
}

} // namespace microslip::explorer
