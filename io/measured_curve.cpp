#include "io/measured_curve.hpp"

#include "io/csv_line.hpp"
#include "io/nearest_word.hpp"
#include "io/text_line.hpp"
#include "io/units.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace microslip::io {
namespace {

enum Known : std::size_t { longitudinal, lateral, coefficient, force, speed, normal_force, run, sigma, known_count };

struct Column {
  std::string_view name, unit;
};
constexpr std::array<Column, known_count> columns = {{{"creepage_longitudinal", "-"},
                                                      {"creepage_lateral", "-"},
                                                      {"adhesion_coefficient", "-"},
                                                      {"force", "N"},
                                                      {"rolling_speed", "m/s"},
                                                      {"normal_force", "N"},
                                                      {"run", ""},
                                                      {"sigma", "-"}}};
constexpr auto names = [] {
  std::array<std::string_view, known_count> all{};
  for (std::size_t k = 0; k < known_count; ++k) all[k] = columns[k].name;
  return all;
}();

std::string label_of(Known column) {
  return "column " + std::string(columns[column].name);
}

/// Where the columns are and what their numbers are in SI units.
class Header {
public:
  explicit Header(std::string_view line) : separator_(csv_separator(line)) {
    position_.fill(absent);
    CsvLine splitter(separator_);
    std::vector<std::string> strangers, units;
    for (const auto field : splitter.split(line)) {
      const auto [name, unit] = name_and_unit(field);
      const auto found = std::find(names.begin(), names.end(), name);
      if (found == names.end()) strangers.emplace_back(name);
      if (found != names.end()) take(static_cast<Known>(found - names.begin()), units.size());
      units.emplace_back(unit);
    }
    fields_ = units.size();
    require(strangers);
    for (std::size_t k = 0; k < known_count; ++k)
      if (has(static_cast<Known>(k)) && !units[position_[k]].empty() && k != run)
        scale_[k] = scale_to_unit(label_of(static_cast<Known>(k)), units[position_[k]], unit_of(static_cast<Known>(k)));
  }

  bool has(Known column) const { return position_[column] != absent; }
  char separator() const { return separator_; }
  std::size_t fields() const { return fields_; }
  std::string_view text(const std::vector<std::string_view>& fields, Known column) const {
    return fields[position_[column]];
  }
  double number(const std::vector<std::string_view>& fields, Known column) const {
    return scale_[column](csv_number(label_of(column), text(fields, column), separator_ != ','));
  }
  double positive(const std::vector<std::string_view>& fields, Known column) const {
    return require_positive(label_of(column), number(fields, column), unit_of(column));
  }
  std::string_view unit_of(Known column) const {
    return column == sigma && has(force) ? columns[force].unit : columns[column].unit;
  }

private:
  static constexpr std::size_t absent = std::numeric_limits<std::size_t>::max();

  void take(Known column, std::size_t position) {
    if (has(column)) throw Error(label_of(column) + ": is there twice");
    position_[column] = position;
  }

  void require(const std::vector<std::string>& strangers) const {
    std::vector<std::string_view> missing;
    for (std::size_t k = 0; k < known_count; ++k)
      if (!has(static_cast<Known>(k))) missing.push_back(names[k]);
    for (const std::string& name : strangers)
      if (const auto near = suggestion(name, missing); !near.empty())
        throw Error("column " + printable(name) + ": unknown" + near);
    require_one(longitudinal, lateral);
    require_one(coefficient, force);
  }

  void require_one(Known one, Known other) const {
    if (has(one) == has(other))
      throw Error("must have a column " + std::string(columns[one].name) + " or " + std::string(columns[other].name) +
                  (has(one) ? ", not both" : ""));
  }

  char separator_;
  std::size_t fields_ = 0;
  std::array<std::size_t, known_count> position_;
  std::array<UnitScale, known_count> scale_ = {};
};

std::size_t index_of(std::vector<std::string>& runs, std::string_view name) {
  const auto found = std::find(runs.begin(), runs.end(), name);
  if (found == runs.end()) runs.emplace_back(name);
  return static_cast<std::size_t>(std::find(runs.begin(), runs.end(), name) - runs.begin());
}

MeasuredPoint read_point(const std::vector<std::string_view>& fields, const Header& header,
                         const MeasuringConditions& conditions, MeasuredCurves& curves) {
  if (fields.size() != header.fields())
    throw Error(std::to_string(fields.size()) + " fields, not " + std::to_string(header.fields()) +
                (header.separator() == ',' ? "; decimal commas need semicolons between fields" : ""));
  MeasuredPoint point{.speed = conditions.speed, .normal_force = conditions.normal_force};
  const Known along = curves.is_lateral ? lateral : longitudinal, measured = header.has(force) ? force : coefficient;
  constexpr double largest = 10; // beyond it a creepage or a coefficient is taken for a mistake
  const double creepage = require_between(label_of(along), header.number(fields, along), "-", -largest, largest);
  if (creepage == 0) throw Error(label_of(along), 0, "-", "not zero, where every curve is zero");
  if (header.has(speed)) point.speed = header.positive(fields, speed);
  if (header.has(normal_force)) point.normal_force = header.positive(fields, normal_force);
  const double scale = header.has(force) ? 1 / point.normal_force : 1;
  point.coefficient = require_between(label_of(measured), header.number(fields, measured), header.unit_of(measured),
                                      -largest / scale, largest / scale) *
                      (creepage < 0 ? -scale : scale);
  point.creepage = std::abs(creepage);
  if (header.has(sigma)) point.sigma = header.positive(fields, sigma) * scale;
  point.run = index_of(curves.runs, header.has(run) ? header.text(fields, run) : "");
  return point;
}

/// Forces on body 1 are opposite to the creepage, those on body 2 are not.
void make_resisting(std::vector<MeasuredPoint>& points) {
  double sum = 0;
  for (const MeasuredPoint& point : points) sum += point.coefficient;
  if (sum < 0)
    for (MeasuredPoint& point : points) point.coefficient = -point.coefficient;
}

} // namespace

MeasuredCurves read_measured_curves(std::string_view text, const std::string& name,
                                    const MeasuringConditions& conditions) {
  MeasuredCurves curves;
  std::optional<Header> header;
  std::optional<CsvLine> splitter;
  read_csv_lines(text, name, [&](std::string_view line) {
    if (header) {
      curves.points.push_back(read_point(splitter->split(line), *header, conditions, curves));
    } else {
      header.emplace(line);
      splitter.emplace(header->separator());
      curves.is_lateral = header->has(lateral);
      curves.has_sigma = header->has(sigma);
    }
  });
  if (curves.points.empty()) throw Error(name + ": has no measured points");
  make_resisting(curves.points);
  return curves;
}

} // namespace microslip::io
