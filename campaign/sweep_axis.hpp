#pragma once

#include "campaign/distribution.hpp"
#include "io/toml_section.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::campaign {

/// Value of a parameter in a case: a number, or what a list in the file or a column of a table has.
struct CaseValue {
  double number = 0;
  const toml::node* node = nullptr; ///< instead of the number, if there is one; of the specification

  bool operator==(const CaseValue&) const = default;
};

/// The values of a parameter: those of a list, a column of numbers, or a range or distribution.
struct SweepAxis {
  /// A parameter of the distribution as a text with a unit, until it is converted.
  struct Text {
    double Distribution::*parameter;
    std::string text;
  };

  toml::array list = {};            ///< or else
  std::vector<double> numbers = {}; ///< a column of numbers, or else
  Distribution distribution = {};
  std::vector<Text> texts = {};
  std::size_t count = 0;     ///< 0: any number of the distribution
  std::string location = {}; ///< for messages: file and line
  std::string table = {};    ///< the text of the table that the list is taken from, if it is

  CaseValue at(std::size_t i) const;
  /// Value below which a fraction `part` of them lies.
  CaseValue at_fraction(double part) const;
  /// Returns whether larger fractions have larger values, as those of lists need not.
  bool is_ascending() const { return list.empty() || !table.empty(); }
  bool has_units() const;

  /// Numbers for all texts; `number` makes one of a text and the value's index, `deviation` one of a difference.
  void convert(const std::function<double(const std::string& text, std::size_t index)>& number,
               const std::function<double(const std::string& text)>& deviation);
};

/// The option that a word names, by its place among the words.
template <class Option> Option option_of(std::span<const std::string_view> words, std::string_view word) {
  return static_cast<Option>(std::find(words.begin(), words.end(), word) - words.begin());
}

/// { from, to } of a grid, with count and scale.
SweepAxis range_of(const io::TomlSection& range);
/// What a key of a sample has: a distribution by its parameters, or by a table in the file's folder.
SweepAxis distribution_of(const io::TomlSection& section);

} // namespace microslip::campaign
