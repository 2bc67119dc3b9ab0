#include "io/contact_table.hpp"

#include "io/csv_line.hpp"
#include "io/nearest_word.hpp"
#include "io/text_line.hpp"
#include "microslip/description/input.hpp"
#include "microslip/error.hpp"
#include "microslip/rolling/contact_warnings.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace microslip::io {
namespace {

using description::Input;

constexpr std::size_t chunk_size = std::size_t{32} * 1024;

constexpr std::string_view label_start = "column ";

struct Column {
  std::string_view label;        ///< "column " and its name, as messages have it
  std::string_view section, key; ///< of the input of case files that has its unit and bounds
  void (*set)(EllipticContact& contact, double value);

  constexpr std::string_view name() const { return label.substr(label_start.size()); }
};

/// The name of a column that was called otherwise before version 0.2.
constexpr std::string_view present_name(std::string_view name) {
  if (name == "creep_x") return "creepage_longitudinal";
  if (name == "creep_y") return "creepage_lateral";
  return name;
}

constexpr std::string_view modulus_label = "column shear_modulus", dissimilarity_label = "column dissimilarity";

/// Inputs that case files do not have: a modulus that is not infinite, and K.
constexpr Input finite_modulus = {.unit = "Pa", .bounds = description::positive};
constexpr Input dissimilarity = {.unit = "-", .bounds = description::between(-0.5, 0.5)};

/// First those that every table has.
constexpr std::array<Column, 11> known_columns = {{
    {"column a", "ellipse", "a", [](EllipticContact& c, double value) { c.a = value; }},
    {"column b", "ellipse", "b", [](EllipticContact& c, double value) { c.b = value; }},
    {modulus_label, "", "", [](EllipticContact& c, double value) { c.shear_modulus = value; }},
    {"column poisson_ratio", "body1", "poisson_ratio",
     [](EllipticContact& c, double value) { c.poisson_ratio = value; }},
    {"column friction", "friction", "coefficient",
     [](EllipticContact& c, double value) { c.friction = FrictionLaw::coulomb(value); }},
    {"column normal_force", "load", "normal_force", [](EllipticContact& c, double value) { c.normal_force = value; }},
    {"column creepage_longitudinal", "motion", "creepage_longitudinal",
     [](EllipticContact& c, double value) { c.creepage.longitudinal = value; }},
    {"column creepage_lateral", "motion", "creepage_lateral",
     [](EllipticContact& c, double value) { c.creepage.lateral = value; }},
    {"column spin", "motion", "spin", [](EllipticContact& c, double value) { c.creepage.spin = value; }},
    {dissimilarity_label, "", "", [](EllipticContact& c, double value) { c.dissimilarity = value; }},
    {"column rolling_speed", "motion", "rolling_speed",
     [](EllipticContact& c, double value) { c.rolling_speed = value; }},
}};
constexpr std::size_t required_columns = 9;

constexpr auto known_names = [] {
  std::array<std::string_view, known_columns.size()> names{};
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = known_columns[i].name();
  return names;
}();
constexpr auto required_names = std::span(known_names).first<required_columns>();
constexpr std::array<std::string_view, 8> result_names = {"fx",        "fy",     "mz",       "adhesion_area",
                                                          "slip_area", "status", "residual", "iterations"};

const Input& input_of(const Column& column) {
  if (column.label == modulus_label) return finite_modulus;
  if (column.label == dissimilarity_label) return dissimilarity;
  return *description::rolling_inputs().find(column.section, column.key);
}

/// Inputs of all columns.
const std::array<const Input*, known_columns.size()>& column_inputs() {
  static const auto all = [] {
    std::array<const Input*, known_columns.size()> inputs{};
    for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = &input_of(known_columns[i]);
    return inputs;
  }();
  return all;
}

/// K of two bodies is largest when one is rigid: |K| <= 1/2 - nu. A little more is rounding of the table's numbers.
void require_possible(double combined, double poisson_ratio) {
  constexpr double rounding = 1e-4;
  const double largest = 0.5 - poisson_ratio;
  if (std::abs(combined) > largest + rounding)
    require_between(dissimilarity_label, combined, dissimilarity.unit, -largest, largest);
}

bool is_blank(std::string_view line) {
  return trimmed(line).empty();
}

void append(std::string& text, double value) {
  std::array<char, 32> digits{};
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

} // namespace

ContactTableReader::ContactTableReader(std::istream& stream, std::string name)
    : stream_(stream), name_(std::move(name)) {
  fill(rest_);
  std::string_view text = csv_start(rest_, name_), line;
  std::size_t number = 0;
  while (!text.empty() && is_blank(line)) {
    line = take_line(text);
    ++number;
  }
  if (is_blank(line))
    throw Error(name_ + ": is empty; the first line must name the columns " + listed(required_names, "and"));
  try {
    parse_header(line);
  } catch (const Error& error) {
    throw Error(name_ + ":" + std::to_string(number) + ": " + error.what());
  }
  rest_.erase(0, rest_.size() - text.size());
  next_line_ = number + 1;
}

/// Reads until `text` has the size of a chunk or the file ends.
void ContactTableReader::fill(std::string& text) {
  const auto size = text.size();
  text.resize(chunk_size);
  stream_.read(text.data() + size, static_cast<std::streamsize>(chunk_size - size));
  if (stream_.bad()) throw Error(name_ + ": cannot be read");
  const auto count = static_cast<std::size_t>(stream_.gcount());
  text.resize(size + count);
  bytes_read_ += count;
}

void ContactTableReader::parse_header(std::string_view line) {
  separator_ = csv_separator(line);
  CsvLine splitter(separator_);
  std::vector<std::string_view> strangers;
  for (const auto field : splitter.split(line)) {
    uses_.push_back(use_of(field, strangers));
    const Use& use = uses_.back();
    const bool is_known = use.known < known_columns.size();
    if (use.is_kept) columns_.push_back(csv_field(is_known ? present_name(field) : field));
  }
  if (uses_.size() == 1) throw Error("is one column: commas, semicolons or tabs must separate several");
  require_columns(strangers);
}

/// `strangers` grows by the names that are not known.
ContactTableReader::Use ContactTableReader::use_of(std::string_view field,
                                                   std::vector<std::string_view>& strangers) const {
  const auto [name, unit] = name_and_unit(field);
  const auto found = std::find(known_names.begin(), known_names.end(), present_name(name));
  const auto known = static_cast<std::size_t>(found - known_names.begin());
  if (found == known_names.end()) {
    strangers.push_back(name);
    return {known, std::find(result_names.begin(), result_names.end(), name) == result_names.end()};
  }
  const Column& column = known_columns[known];
  if (std::any_of(uses_.begin(), uses_.end(), [&](const Use& use) { return use.known == known; }))
    throw Error(std::string(column.label) + ": is there twice");
  return {known, true, unit.empty() ? UnitScale() : scale_to_unit(column.label, unit, column_inputs()[known]->unit)};
}

/// A column that resembles one that is not there is that one, misspelt.
void ContactTableReader::require_columns(std::span<const std::string_view> strangers) const {
  std::vector<std::string_view> missing;
  for (std::size_t known = 0; known < known_columns.size(); ++known)
    if (std::none_of(uses_.begin(), uses_.end(), [&](const Use& use) { return use.known == known; }))
      missing.push_back(known_names[known]);
  for (const auto name : strangers)
    if (const auto near = suggestion(name, missing); !near.empty())
      throw Error("column " + printable(name) + ": unknown" + near);
  for (const auto name : required_names)
    if (std::find(missing.begin(), missing.end(), name) != missing.end())
      throw Error("column " + std::string(name) + ": is missing");
}

bool ContactTableReader::read(TextChunk& chunk) {
  chunk.text = std::exchange(rest_, {});
  fill(chunk.text);
  chunk.first_line = next_line_;
  if (chunk.text.size() == chunk_size) {
    const auto end = chunk.text.rfind('\n');
    if (end == std::string::npos)
      throw Error(name_ + ":" + std::to_string(next_line_) + ": a line of more than 32 KiB");
    rest_ = chunk.text.substr(end + 1);
    chunk.text.resize(end + 1);
  }
  next_line_ += static_cast<std::size_t>(std::count(chunk.text.begin(), chunk.text.end(), '\n'));
  return !chunk.text.empty();
}

TableRows ContactTableReader::parse(const TextChunk& chunk) const {
  TableRows rows;
  CsvLine splitter(separator_);
  std::string_view text = chunk.text;
  for (std::size_t line_number = chunk.first_line; !text.empty(); ++line_number) {
    const auto line = take_line(text);
    if (is_blank(line)) continue;
    const std::size_t begin = rows.text.size(), count = rows.contacts.size();
    try {
      const auto& fields = splitter.split(line);
      const bool is_cut_off = text.empty() && chunk.text.back() != '\n';
      if (fields.size() != uses_.size())
        throw Error(std::to_string(fields.size()) + (fields.size() == 1 ? " field, not " : " fields, not ") +
                    std::to_string(uses_.size()) +
                    (is_cut_off ? "; the file ends in the middle of a line"
                     : fields.size() > uses_.size() && separator_ == ','
                         ? "; decimal commas need semicolons between fields"
                         : ""));
      parse_row(fields, rows);
      const ContactWarnings found = contact_warnings(rows.contacts.back());
      for (std::size_t k = 0; k < found.kinds.size(); ++k) {
        ImplausibleRows& others = rows.implausible[found.kinds[k]];
        if (others.count++ == 0) others.first = {line_number, found.texts[k]};
      }
    } catch (const Error& error) {
      rows.bad.push_back({line_number, error.what()});
      rows.text.resize(begin);
      rows.contacts.resize(count);
    }
  }
  return rows;
}

/// Adds a row, or part of it with an Error.
void ContactTableReader::parse_row(const std::vector<std::string_view>& fields, TableRows& rows) const {
  auto& contact = rows.contacts.emplace_back();
  const auto& inputs = column_inputs();
  bool is_first = true;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const Use& use = uses_[i];
    if (!use.is_kept) continue;
    if (!std::exchange(is_first, false)) rows.text += ',';
    if (use.known == known_columns.size()) {
      rows.text += csv_field(fields[i]);
      continue;
    }
    const Column& column = known_columns[use.known];
    const double value = use.to_si(csv_number(column.label, fields[i], separator_ != ','));
    inputs[use.known]->bounds.require(column.label, value, inputs[use.known]->unit);
    column.set(contact, value);
    const auto begin = rows.text.size();
    rows.text += fields[i];
    std::replace(rows.text.begin() + static_cast<std::ptrdiff_t>(begin), rows.text.end(), ',', '.');
  }
  require_possible(contact.dissimilarity, contact.poisson_ratio);
  if (contact.dissimilarity != 0 && !similar_only_.empty())
    throw Error(dissimilarity_label, contact.dissimilarity, dissimilarity.unit, "0 " + similar_only_);
  rows.ends.push_back(rows.text.size());
}

std::string result_header(const std::vector<std::string>& columns, bool exact) {
  std::string line;
  for (const auto& column : columns) line.append(column).append(",");
  return line + "fx,fy,mz,adhesion_area,slip_area,status" + (exact ? ",residual,iterations\n" : "\n");
}

std::string result_rows(const TableRows& rows, std::span<const ContactForces> forces,
                        std::span<const Iteration> iterations) {
  std::string csv;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < rows.ends.size(); ++i) {
    csv.append(rows.text, begin, rows.ends[i] - begin);
    begin = rows.ends[i];
    for (const auto value : {forces[i].fx, forces[i].fy, forces[i].mz, forces[i].adhesion_area, forces[i].slip_area}) {
      csv += ',';
      append(csv, value);
    }
    csv.append(",").append(to_string(forces[i].status));
    if (!iterations.empty()) {
      csv += ',';
      append(csv, iterations[i].residual);
      csv.append(",").append(std::to_string(iterations[i].steps));
    }
    csv += '\n';
  }
  return csv;
}

} // namespace microslip::io
