#include "io/nearest_word.hpp"
#include "io/profile_formats.hpp"
#include "io/text_line.hpp"
#include "microslip/railway/profile/report_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace microslip::io {
namespace {

/// A line's fields; the numbers of one with decimal commas get points.
struct Row {
  std::vector<std::string> fields;
  bool decimal_commas = false;
};

bool is_decimal_comma(std::string_view field) {
  const auto comma = field.find(',');
  return comma != std::string_view::npos && comma + 1 < field.size() && field.find(',', comma + 1) == field.npos &&
         field.find('.') == field.npos;
}

Row split_row(std::string_view line) {
  Row row;
  const auto wide = split(line, ";|");
  // Blanks or semicolons between numbers with commas in them: `1,5 2,5`.
  row.decimal_commas =
      wide.size() > 1 && std::any_of(wide.begin(), wide.end(), is_decimal_comma) &&
      std::all_of(wide.begin(), wide.end(), [](auto f) { return !f.ends_with(',') && !f.starts_with(','); });
  for (const auto field : row.decimal_commas ? wide : split(line, ";|,")) {
    row.fields.emplace_back(unquoted(field));
    if (row.decimal_commas) std::replace(row.fields.back().begin(), row.fields.back().end(), ',', '.');
  }
  return row;
}

std::string_view without_comment(std::string_view line) {
  const auto slashes = line.find("//");
  return before_comment(line.substr(0, slashes), "#%!");
}

/// A line with nothing but a number of points.
bool is_count(const Row& row) {
  if (row.fields.size() != 1) return false;
  const auto value = parse_number(row.fields[0]);
  return value && *value > 0 && *value == std::floor(*value);
}

/// A word, but not one that stands for a number that there is not.
bool is_heading(std::string_view field) {
  constexpr auto no_numbers = std::to_array<std::string_view>({"nan", "inf", "infinity"});
  const auto word = lower_case(field.starts_with('-') || field.starts_with('+') ? field.substr(1) : field);
  return !parse_number(field) && std::find(no_numbers.begin(), no_numbers.end(), word) == no_numbers.end();
}

} // namespace

ProfileFile parse_columns(ProfileLines lines) {
  ProfileFile file;
  std::size_t headings = 0, columns = 2;
  double announced = 0;
  bool decimal_commas = false;
  while (lines.next()) {
    auto line = lines.line();
    if (line.starts_with('*') || line.starts_with(';')) continue;
    line = without_comment(line);
    if (line.empty()) continue;
    const auto row = split_row(line);
    if (row.fields.empty()) continue;
    if (file.points.empty() && announced == 0 && is_count(row)) {
      announced = *parse_number(row.fields[0]);
      continue;
    }
    if (file.points.empty() && is_heading(row.fields[0])) {
      ++headings;
      continue;
    }
    if (row.fields.size() < 2) lines.fail("one number, " + printable(row.fields[0]) + ", not y and z");
    file.points.push_back({lines.number(row.fields[0], "y"), lines.number(row.fields[1], "z")});
    columns = std::max(columns, row.fields.size());
    decimal_commas |= row.decimal_commas;
  }
  if (file.points.empty()) lines.fail_as_a_whole("there are no lines with two numbers, y and z");
  file.points_read = file.points.size();
  if (announced > 0 && announced != static_cast<double>(file.points.size()))
    lines.fail_as_a_whole("the first line announces " + digits(announced) + " points, but there are " +
                          std::to_string(file.points.size()) + "; is it truncated?");
  if (headings > 0)
    file.assumptions.push_back(counted(headings, "line") + " before the first number taken as headings");
  if (columns > 2) file.assumptions.emplace_back("y and z are the first two columns; the others are not used");
  if (decimal_commas) file.assumptions.emplace_back("commas are decimal points");
  return file;
}

} // namespace microslip::io
