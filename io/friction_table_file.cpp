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
#include <tuple>
#include <utility>
#include <vector>

namespace microslip::io {
namespace {

struct Column {
  std::string_view name, label, unit;
  double least, largest;
};
constexpr std::array<Column, 4> columns = {
    {{"slip_velocity", "column slip_velocity", "m/s", 0, FrictionTable::largest_velocity},
     {"pressure", "column pressure", "Pa", 0, FrictionTable::largest_pressure},
     {"temperature", "column temperature", "deg C", FrictionTable::lowest_temperature,
      FrictionTable::highest_temperature},
     {"coefficient", "column coefficient", "-", 0, FrictionLaw::largest_coefficient}}};
enum { of_velocity, of_pressure, of_temperature, of_coefficient };

/// Where a column is in the file, and its unit.
struct Place {
  std::size_t field = 0;
  std::string unit = {};
};
using Places = std::array<std::optional<Place>, columns.size()>;
/// Slip velocity, pressure, temperature and coefficient; 0 for a column that there is not.
using Row = std::array<double, columns.size()>;

/// Where fields end in a line: at separators outside quotes and at its end. Throws Error for a quote left open.
std::vector<std::size_t> field_ends(std::string_view line, char separator) {
  std::vector<std::size_t> ends;
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') is_quoted = !is_quoted;
    if (line[i] == separator && !is_quoted) ends.push_back(i);
  }
  if (is_quoted) throw Error("a quote is not closed");
  ends.push_back(line.size());
  return ends;
}

/// The fields of a line, without quotes around them.
std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  std::size_t begin = 0;
  for (const std::size_t end : field_ends(line, separator)) {
    std::string_view field = trimmed(line.substr(begin, end - begin));
    if (field.size() > 1 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    fields.push_back(field);
    begin = end + 1;
  }
  return fields;
}

Places places_of(const std::vector<std::string_view>& headings) {
  Places places;
  std::vector<std::string_view> strangers, missing;
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
    if (!unit.empty()) number_in_unit(found->label, "1 " + std::string(unit), found->unit);
    place = {i, std::string(unit)};
  }
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (!places[k]) missing.push_back(columns[k].name);
  for (const std::string_view name : strangers)
    if (const auto near = suggestion(name, missing); !near.empty())
      throw Error("column " + printable(name) + ": unknown" + near);
  for (const auto k : {of_velocity, of_coefficient})
    if (!places[k]) throw Error(std::string(columns[k].label) + ": is missing");
  return places;
}

Row row_of(const std::vector<std::string_view>& fields, const Places& places, bool decimal_comma) {
  Row row{};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (!places[k]) continue;
    const auto& [name, label, unit, least, largest] = columns[k];
    row[k] = csv_number(label, fields[places[k]->field], decimal_comma);
    if (!places[k]->unit.empty()) row[k] = number_in_unit(label, shortest_text(row[k]) + " " + places[k]->unit, unit);
    require_between(label, row[k], unit, least, largest);
  }
  return row;
}

/// The different numbers of a column, ascending.
std::vector<double> axis_of(const std::vector<Row>& rows, std::size_t column) {
  std::vector<double> axis;
  axis.reserve(rows.size());
  for (const Row& row : rows) axis.push_back(row[column]);
  std::sort(axis.begin(), axis.end());
  axis.erase(std::unique(axis.begin(), axis.end()), axis.end());
  return axis;
}

/// Lines of a grid in any order, each node once.
FrictionGrid grid_of(std::vector<Row> rows, const Places& places) {
  std::sort(rows.begin(), rows.end(), [](const Row& one, const Row& other) {
    return std::tie(one[of_temperature], one[of_pressure], one[of_velocity]) <
           std::tie(other[of_temperature], other[of_pressure], other[of_velocity]);
  });
  FrictionGrid grid{.slip_velocities = axis_of(rows, of_velocity)};
  const auto pressures = axis_of(rows, of_pressure), temperatures = axis_of(rows, of_temperature);
  if (places[of_pressure]) grid.pressures = pressures;
  if (places[of_temperature]) grid.temperatures = temperatures;
  auto row = rows.begin();
  for (const double t : temperatures)
    for (const double p : pressures)
      for (const double v : grid.slip_velocities) {
        if (row == rows.end() ||
            std::tie((*row)[of_temperature], (*row)[of_pressure], (*row)[of_velocity]) != std::tie(t, p, v))
          throw Error("must have one line for each combination of its slip velocities, pressures and temperatures; the "
                      "one of slip_velocity = " +
                      shortest_text(v) + " m/s, pressure = " + shortest_text(p) +
                      " Pa, temperature = " + shortest_text(t) + " deg C is missing or another is there twice");
        grid.coefficients.push_back((*row++)[of_coefficient]);
      }
  if (row != rows.end()) throw Error("has a line twice");
  return grid;
}

} // namespace

FrictionTable parse_friction_table(std::string_view text, const std::string& name) {
  std::optional<Places> places;
  char separator = ',';
  std::size_t width = 0;
  std::vector<Row> rows;
  text = csv_start(text, name);
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    if (trimmed(line).empty()) continue;
    try {
      if (!places) {
        separator = csv_separator(line);
        const auto headings = fields_of(line, separator);
        places = places_of(headings);
        width = headings.size();
        continue;
      }
      const auto fields = fields_of(line, separator);
      require_fields(fields.size(), width, separator);
      const Row row = row_of(fields, *places, separator != ',');
      const bool is_grid = (*places)[of_pressure] || (*places)[of_temperature];
      if (!is_grid && !rows.empty() && !(row[of_velocity] > rows.back()[of_velocity]))
        throw Error(columns[of_velocity].label, row[of_velocity], columns[of_velocity].unit,
                    "above the one before, " + shortest_text(rows.back()[of_velocity]));
      rows.push_back(row);
    } catch (const Error& error) {
      throw Error(name + ":" + std::to_string(number) + ": " + error.what());
    }
  }
  if (rows.size() < 2)
    throw Error(name + ": must have a line with the columns slip_velocity and coefficient and at least 2 with numbers");
  try {
    return FrictionTable(grid_of(std::move(rows), *places));
  } catch (const Error& error) {
    throw Error(name + ": " + error.what());
  }
}

FrictionTable read_friction_table(const std::filesystem::path& path) {
  return parse_friction_table(read_case_text(path), path.filename().string());
}

} // namespace microslip::io
