#include "io/nearest_word.hpp"
#include "io/profile_formats.hpp"
#include "io/text_line.hpp"
#include "microslip/railway/profile/report_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace microslip::io {
namespace {

/// A line's fields; the numbers of one with decimal commas get points.
struct Row {
  std::vector<std::string> fields;
  bool decimal_commas = false, commas_separate = false;
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
  row.commas_separate = !row.decimal_commas && line.find(',') != std::string_view::npos;
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

/// Name of a column and unit of its values, of `y [mm]`, `Height (inch)` or `z_mm`.
struct Heading {
  std::string name;
  std::optional<double> unit = {}; ///< length [m]
  std::string unknown_unit = {};   ///< what is in brackets and no unit of length
  bool is_square = false;          ///< the bracket; round ones may have any remark
};

Heading heading_of(std::string_view field) {
  Heading heading{lower_case(unquoted(trimmed(field)))};
  const std::string_view whole = heading.name;
  const auto bracket = whole.find_first_of("[("), end = whole.find_first_of("[( _");
  if (end == std::string_view::npos) return heading;
  const auto unit = whole.substr((bracket == std::string_view::npos ? end : bracket) + 1);
  const std::string word(trimmed(unit.substr(0, unit.find_first_of("])"))));
  heading.unit = length_named(word);
  if (bracket != std::string_view::npos && !heading.unit) heading.unknown_unit = word;
  heading.is_square = bracket != std::string_view::npos && whole[bracket] == '[';
  heading.name.resize(end);
  return heading;
}

/// Headings of a line, between separators or else between blanks, of which one may stand before a unit in brackets.
std::vector<Heading> headings_of(std::string_view line) {
  const bool has_separators = line.find_first_of(";|,\t") != std::string_view::npos;
  std::vector<Heading> headings;
  std::string joined;
  const auto flush = [&] {
    if (!joined.empty()) headings.push_back(heading_of(joined));
    joined.clear();
  };
  if (has_separators) {
    std::size_t first = 0;
    for (std::size_t end = 0; end != std::string_view::npos; first = end + 1) {
      end = line.find_first_of(";|,\t", first);
      headings.push_back(heading_of(line.substr(first, end - first)));
    }
    return headings;
  }
  for (const auto field : split(line, "")) {
    if (!field.starts_with('[') && !field.starts_with('(')) flush();
    joined += field;
  }
  flush();
  return headings;
}

/// Columns of a file, from 0.
struct ColumnOrder {
  std::size_t y = 0, z = 1;
  std::optional<double> unit = {}; ///< length [m]
  bool is_known = false;           ///< by headings or by an option
  std::string unknown_unit = {};   ///< what stands in the place of one

  std::size_t needed() const { return std::max(y, z) + 1; }
};

/// The order that `columns` states.
ColumnOrder stated_order(const ProfileLines& lines, const std::string& columns) {
  const auto names = headings_of(columns);
  const auto is = [](const char* name) { return [=](const Heading& heading) { return heading.name == name; }; };
  const auto place = [&](const char* name) {
    if (std::count_if(names.begin(), names.end(), is(name)) != 1)
      lines.fail_as_a_whole("columns = " + printable(columns) +
                            ": must name y and z once each, with - for a column that is not used, as \"-,y,z\"");
    return static_cast<std::size_t>(std::find_if(names.begin(), names.end(), is(name)) - names.begin());
  };
  return {.y = place("y"), .z = place("z"), .is_known = true};
}

/// The order by headings, if they name two directions: y or lateral, z or vertical; x and z or x and y where the third
/// one is missing.
ColumnOrder order_of_headings(const ProfileLines& lines, std::string_view line) {
  const auto headings = headings_of(line);
  const auto place = [&](std::initializer_list<std::string_view> names) {
    std::optional<std::size_t> found;
    for (std::size_t k = 0; k < headings.size(); ++k) {
      if (std::find(names.begin(), names.end(), headings[k].name) == names.end()) continue;
      if (found) lines.fail("two columns are headed " + printable(headings[k].name));
      found = k;
    }
    return found;
  };
  const auto x = place({"x"}), y = place({"y", "lateral"}), z = place({"z", "vertical", "height"});
  const auto lateral = y && (z || !x) ? y : x, vertical = z ? z : y && x ? y : std::nullopt;
  if (!lateral || !vertical) return {};
  const auto unit = headings[*lateral].unit;
  if (unit != headings[*vertical].unit) lines.fail("the headings give y and z different units");
  const std::string& of_y = headings[*lateral].unknown_unit;
  return {.y = *lateral,
          .z = *vertical,
          .unit = unit,
          .is_known = true,
          .unknown_unit = of_y.empty() ? headings[*vertical].unknown_unit : of_y};
}

/// The unit of headings whose order is known already, or of a line of units below them.
std::optional<double> unit_of_line(std::string_view line, const ColumnOrder& order) {
  const auto units = headings_of(line);
  if (!order.is_known || units.size() < order.needed()) return {};
  const auto unit = [&](std::size_t column) {
    return units[column].unit ? units[column].unit : length_named(units[column].name);
  };
  return unit(order.y) == unit(order.z) ? unit(order.y) : std::nullopt;
}

/// What such a line has in square brackets for y or z, if that is no unit of length.
std::string unknown_unit_of_line(std::string_view line, const ColumnOrder& order) {
  const auto units = headings_of(line);
  if (!order.is_known || units.size() < order.needed()) return {};
  for (const std::size_t column : {order.y, order.z})
    if (units[column].is_square && !units[column].unknown_unit.empty()) return units[column].unknown_unit;
  return {};
}

/// Whether the points lie on their side: the ends of wheels and rails are further apart in y than in z.
bool is_on_its_side(const std::vector<ProfilePoint>& points) {
  const auto extent = [&](double ProfilePoint::*coordinate) {
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(), [&](const auto& a, const auto& b) { return a.*coordinate < b.*coordinate; });
    return (*high).*coordinate - (*low).*coordinate;
  };
  const auto apart = [&](double ProfilePoint::*coordinate) {
    return std::abs(points.back().*coordinate - points.front().*coordinate);
  };
  constexpr double clearly = 1.5;
  return apart(&ProfilePoint::z) > clearly * apart(&ProfilePoint::y) &&
         extent(&ProfilePoint::z) > clearly * extent(&ProfilePoint::y);
}

/// Digits only: of a number that a decimal comma has cut in two.
bool is_whole(std::string_view field) {
  return !field.empty() && std::all_of(field.begin(), field.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Reads a file of columns line by line.
class ColumnReader {
public:
  ColumnReader(ProfileLines lines, const std::string& columns) : lines_(std::move(lines)) {
    if (!columns.empty()) order_ = stated_order(lines_, columns);
    is_stated_ = order_.is_known;
  }

  ProfileFile read() {
    while (lines_.next()) {
      const auto line = lines_.line();
      if (!line.starts_with('*') && !line.starts_with(';')) read_line(without_comment(line));
    }
    if (file_.points.empty()) lines_.fail_as_a_whole("there are no lines with two numbers, y and z");
    if (cut_numbers_ == file_.points.size())
      lines_.fail_as_a_whole("commas are both decimal points and separators; separate the columns by semicolons");
    file_.points_read = file_.points.size();
    if (announced_ > 0 && announced_ != static_cast<double>(file_.points.size()))
      lines_.fail_as_a_whole("the first line announces " + digits(announced_) + " points, but there are " +
                             std::to_string(file_.points.size()) + "; is it truncated?");
    file_.unit = order_.unit;
    note();
    return std::move(file_);
  }

private:
  void read_line(std::string_view line) {
    if (line.empty()) return;
    const auto row = split_row(line);
    if (row.fields.empty()) return;
    if (file_.points.empty() && announced_ == 0 && is_count(row)) {
      announced_ = *parse_number(row.fields[0]);
      return;
    }
    if (file_.points.empty() && is_heading(row.fields[0])) return read_headings(line);
    add_point(row);
  }

  void read_headings(std::string_view line) {
    ++headings_;
    if (const auto unit = unit_of_line(line, order_)) {
      order_.unit = unit;
      return;
    }
    if (const auto unknown = unknown_unit_of_line(line, order_); !unknown.empty())
      file_.stated_unit = {unknown, lines_.place()};
    if (is_stated_) return;
    const auto order = order_of_headings(lines_, line);
    if (order.is_known) order_ = order;
    if (!order.unknown_unit.empty()) file_.stated_unit = {order.unknown_unit, lines_.place()};
  }

  void add_point(const Row& row) {
    const auto& fields = row.fields;
    if (fields.size() < 2) lines_.fail("one number, " + printable(fields[0]) + ", not y and z");
    if (fields.size() < order_.needed())
      lines_.fail(std::to_string(fields.size()) + " numbers, but y or z is in column " +
                  std::to_string(order_.needed()));
    file_.points.push_back({lines_.number(fields[order_.y], "y"), lines_.number(fields[order_.z], "z")});
    columns_ = std::max(columns_, fields.size());
    decimal_commas_ |= row.decimal_commas;
    const bool cut = fields.size() == 4 && is_whole(fields[1]) && is_whole(fields[3]) && row.commas_separate &&
                     is_whole(unsigned_part(fields[0])) && is_whole(unsigned_part(fields[2]));
    if (cut) ++cut_numbers_;
  }

  static std::string_view unsigned_part(std::string_view field) {
    return field.substr(field.starts_with('-') || field.starts_with('+') ? 1 : 0);
  }

  /// What was decided, for the report.
  void note() {
    const auto column = [](std::size_t k) { return "column " + std::to_string(k + 1); };
    const std::string order = "y is " + column(order_.y) + " and z " + column(order_.z);
    auto& assumptions = file_.assumptions;
    if (headings_ > 0)
      assumptions.push_back(counted(headings_, "line") + " before the first number taken as headings" +
                            (order_.is_known && !is_stated_ ? ": " + order : ""));
    if (!order_.is_known && is_on_its_side(file_.points)) {
      for (auto& p : file_.points) std::swap(p.y, p.z);
      assumptions.emplace_back("y is the second column and z the first, by the shape");
    } else if (!order_.is_known && columns_ > 2) {
      assumptions.emplace_back("y and z are the first two columns; the others are not used");
    }
    if (decimal_commas_) assumptions.emplace_back("commas are decimal points");
  }

  ProfileLines lines_;
  ProfileFile file_;
  ColumnOrder order_;
  bool is_stated_ = false, decimal_commas_ = false;
  std::size_t headings_ = 0, columns_ = 2, cut_numbers_ = 0;
  double announced_ = 0;
};

} // namespace

ProfileFile parse_columns(ProfileLines lines, const std::string& columns) {
  return ColumnReader(std::move(lines), columns).read();
}

} // namespace microslip::io
