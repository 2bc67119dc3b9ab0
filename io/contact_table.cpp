#include "io/contact_table.hpp"

#include "io/csv_line.hpp"
#include "io/nearest_word.hpp"
#include "io/text_line.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

constexpr std::size_t chunk_size = std::size_t{32} * 1024;

constexpr std::string_view label_start = "column ";

struct Column {
  std::string_view label; ///< "column " and its name, as messages have it
  void (*set)(EllipticContact& contact, std::string_view label, double value);

  constexpr std::string_view name() const { return label.substr(label_start.size()); }
};

/// The name of a column that was called otherwise before version 0.2.
constexpr std::string_view present_name(std::string_view name) {
  if (name == "creep_x") return "creepage_longitudinal";
  if (name == "creep_y") return "creepage_lateral";
  return name;
}

constexpr std::string_view dissimilarity_label = "column dissimilarity";

/// First those that every table has.
constexpr std::array<Column, 11> known_columns = {{
    {"column a", [](EllipticContact& c, auto label, double value) { c.a = require_positive(label, value, "m"); }},
    {"column b", [](EllipticContact& c, auto label, double value) { c.b = require_positive(label, value, "m"); }},
    {"column shear_modulus",
     [](EllipticContact& c, auto label, double value) { c.shear_modulus = require_positive(label, value, "Pa"); }},
    {"column poisson_ratio", [](EllipticContact& c, auto label,
                                double value) { c.poisson_ratio = require_between(label, value, "-", 0, 0.5); }},
    {"column friction",
     [](EllipticContact& c, auto label, double value) {
       c.friction = FrictionLaw::coulomb(require_between(label, value, "-", 0, FrictionLaw::largest_coefficient));
     }},
    {"column normal_force",
     [](EllipticContact& c, auto label, double value) { c.normal_force = require_positive(label, value, "N"); }},
    {"column creepage_longitudinal",
     [](EllipticContact& c, auto label, double value) { c.creepage.longitudinal = require_finite(label, value, "-"); }},
    {"column creepage_lateral",
     [](EllipticContact& c, auto label, double value) { c.creepage.lateral = require_finite(label, value, "-"); }},
    {"column spin",
     [](EllipticContact& c, auto label, double value) { c.creepage.spin = require_finite(label, value, "1/m"); }},
    {dissimilarity_label, [](EllipticContact& c, auto label,
                             double value) { c.dissimilarity = require_between(label, value, "-", -0.5, 0.5); }},
    {"column rolling_speed",
     [](EllipticContact& c, auto label, double value) { c.rolling_speed = require_positive(label, value, "m/s"); }},
}};
constexpr std::size_t required_columns = 9;

constexpr auto known_names = [] {
  std::array<std::string_view, known_columns.size()> names{};
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = known_columns[i].name();
  return names;
}();
constexpr auto required_names = std::span(known_names).first<required_columns>();

/// K of two bodies is largest when one is rigid: |K| <= 1/2 - nu. A little more is rounding of the table's numbers.
void require_possible(double dissimilarity, double poisson_ratio) {
  constexpr double rounding = 1e-4;
  const double largest = 0.5 - poisson_ratio;
  if (std::abs(dissimilarity) > largest + rounding)
    require_between(dissimilarity_label, dissimilarity, "-", -largest, largest);
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
  if (rest_.starts_with("\xef\xbb\xbf")) rest_.erase(0, 3);
  std::string_view text = rest_, line;
  std::size_t number = 0;
  while (!text.empty() && is_blank(line)) {
    line = take_line(text);
    ++number;
  }
  if (is_blank(line))
    throw Error(name_ + ": is empty; the first line must name the columns " + listed(required_names, "and"));
  parse_header(line, number);
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

void ContactTableReader::parse_header(std::string_view line, std::size_t number) {
  const auto fail = [&](const std::string& what) { throw Error(name_ + ":" + std::to_string(number) + ": " + what); };
  CsvLine splitter;
  try {
    splitter.split(line);
  } catch (const Error& error) {
    fail(error.what());
  }
  for (const auto field : splitter.split(line)) {
    const auto found = std::find(known_names.begin(), known_names.end(), present_name(field));
    if (found == known_names.end()) fail("column " + printable(field) + ": unknown" + suggestion(field, known_names));
    if (std::find(columns_.begin(), columns_.end(), *found) != columns_.end())
      fail("column " + std::string(field) + ": is there twice");
    columns_.push_back(*found);
    kinds_.push_back(static_cast<std::size_t>(found - known_names.begin()));
  }
  for (const auto name : required_names)
    if (std::find(columns_.begin(), columns_.end(), name) == columns_.end())
      fail("column " + std::string(name) + ": is missing");
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

ContactRows ContactTableReader::parse(const TextChunk& chunk) const {
  ContactRows rows;
  CsvLine splitter;
  std::string_view text = chunk.text;
  for (std::size_t line_number = chunk.first_line; !text.empty(); ++line_number) {
    const auto line = take_line(text);
    if (is_blank(line)) continue;
    try {
      const auto& fields = splitter.split(line);
      const bool cut_off = text.empty() && chunk.text.back() != '\n';
      if (fields.size() != columns_.size())
        throw Error(std::to_string(fields.size()) + (fields.size() == 1 ? " field, not " : " fields, not ") +
                    std::to_string(columns_.size()) + (cut_off ? "; the file ends in the middle of a line" : ""));
      auto& contact = rows.contacts.emplace_back();
      for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto& column = known_columns[kinds_[i]];
        column.set(contact, column.label, csv_number(column.label, fields[i]));
        if (i > 0) rows.text += ',';
        rows.text += fields[i];
      }
      require_possible(contact.dissimilarity, contact.poisson_ratio);
      if (contact.dissimilarity != 0 && !similar_only_.empty())
        throw Error(dissimilarity_label, contact.dissimilarity, "-", "0 " + similar_only_);
      rows.ends.push_back(rows.text.size());
    } catch (const Error& error) {
      throw Error(name_ + ":" + std::to_string(line_number) + ": " + error.what());
    }
  }
  return rows;
}

std::string result_header(const std::vector<std::string_view>& columns, bool exact) {
  std::string line;
  for (const auto column : columns) line.append(column).append(",");
  return line + "fx,fy,mz,adhesion_area,slip_area,status" + (exact ? ",residual,iterations\n" : "\n");
}

std::string result_rows(const ContactRows& rows, std::span<const ContactForces> forces,
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

} // namespace microslip
