#include "io/friction_table_file.hpp"

#include "io/case_file.hpp"
#include "io/csv_text.hpp"
#include "io/nearest_word.hpp"
#include "io/text_line.hpp"
#include "io/units.hpp"
#include "microslip/decimal.hpp"
#include "microslip/error.hpp"
#include "microslip/friction/friction_law.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace microslip::io {
namespace {

struct Column {
  std::string_view name, label, unit;
  double largest;
};
constexpr std::array<Column, 2> columns = {
    {{"slip_velocity", "column slip_velocity", "m/s", 1e6},
     {"coefficient", "column coefficient", "-", FrictionLaw::largest_coefficient}}};

/// Where a column is in the file.
struct Place {
  std::size_t field = 0;
  UnitScale to_si = {};
};
using Places = std::array<std::optional<Place>, columns.size()>;

/// The fields of a line, without quotes around them.
std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (bool is_last = false; !is_last;) {
    const auto end = line.find(separator);
    is_last = end == std::string_view::npos;
    std::string_view field = trimmed(line.substr(0, end));
    if (field.size() > 1 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    fields.push_back(field);
    line.remove_prefix(is_last ? line.size() : end + 1);
  }
  return fields;
}

Places places_of(const std::vector<std::string_view>& headings) {
  Places places;
  std::vector<std::string_view> strangers;
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const std::pair heading = name_and_unit(headings[i]);
    const std::string_view name = heading.first, unit = heading.second;
    const auto* found = std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
    if (found == columns.end()) {
      strangers.push_back(name);
      continue;
    }
    auto& place = places[static_cast<std::size_t>(found - columns.begin())];
    if (place) throw Error(std::string(found->label) + ": is there twice");
    place = {i, unit.empty() ? UnitScale() : scale_to_unit(found->label, unit, found->unit)};
  }
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (places[k]) continue;
    const std::vector<std::string_view> missing = {columns[k].name};
    for (const std::string_view name : strangers)
      if (const auto near = suggestion(name, missing); !near.empty())
        throw Error("column " + printable(name) + ": unknown" + near);
    throw Error(std::string(columns[k].label) + ": is missing");
  }
  return places;
}

std::array<double, columns.size()> numbers_of(const std::vector<std::string_view>& fields, const Places& places,
                                              bool decimal_comma) {
  std::array<double, columns.size()> numbers{};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto& [name, label, unit, largest] = columns[k];
    if (places[k]->field >= fields.size()) throw Error(std::string(label) + ": has no number");
    numbers[k] = places[k]->to_si(csv_number(label, fields[places[k]->field], decimal_comma));
    require_between(label, numbers[k], unit, 0, largest);
  }
  return numbers;
}

} // namespace

FrictionTable parse_friction_table(std::string_view text, const std::string& name) {
  std::optional<Places> places;
  char separator = ',';
  std::vector<double> velocities, coefficients;
  text = csv_start(text, name);
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    if (trimmed(line).empty()) continue;
    try {
      if (!places) {
        separator = csv_separator(line);
        places = places_of(split(line, separator));
        continue;
      }
      const auto [v, mu] = numbers_of(split(line, separator), *places, separator != ',');
      if (!velocities.empty() && !(v > velocities.back()))
        throw Error(columns[0].label, v, columns[0].unit, "above the one before, " + shortest_text(velocities.back()));
      velocities.push_back(v);
      coefficients.push_back(mu);
    } catch (const Error& error) {
      throw Error(name + ":" + std::to_string(number) + ": " + error.what());
    }
  }
  if (velocities.size() < 2)
    throw Error(name + ": must have a line with the columns slip_velocity and coefficient and at least 2 with numbers");
  return {std::move(velocities), std::move(coefficients)};
}

FrictionTable read_friction_table(const std::filesystem::path& path) {
  return parse_friction_table(read_case_text(path), path.filename().string());
}

} // namespace microslip::io
