#pragma once

#include "microslip/description/input.hpp"

#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

// The lines of tables of inputs: what stands under a key of each kind, with what it is where it is left out.

namespace microslip::description {

constexpr Input number(std::string_view key, std::string_view unit, Bounds bounds, std::string_view text) {
  return {.key = key, .unit = unit, .bounds = bounds, .text = text};
}
constexpr Input number(std::string_view key, std::string_view unit, Bounds bounds, double missing,
                       std::string_view text) {
  return {.key = key, .unit = unit, .bounds = bounds, .missing = missing, .text = text};
}
constexpr Input numbers(std::string_view key, std::string_view unit, std::string_view text) {
  return {.key = key, .kind = InputKind::numbers, .unit = unit, .text = text};
}
constexpr Input numbers(std::string_view key, std::string_view unit, Bounds bounds, std::span<const double> missing,
                        std::string_view text) {
  return {
      .key = key, .kind = InputKind::numbers, .unit = unit, .bounds = bounds, .missing_numbers = missing, .text = text};
}
constexpr Input whole(std::string_view key, Bounds bounds, std::string_view text) {
  return {.key = key, .kind = InputKind::whole, .bounds = bounds, .text = text};
}
constexpr Input whole(std::string_view key, Bounds bounds, double missing, std::string_view text) {
  return {.key = key, .kind = InputKind::whole, .bounds = bounds, .missing = missing, .text = text};
}
constexpr Input wholes(std::string_view key, Bounds bounds, double missing, std::string_view text) {
  return {.key = key, .kind = InputKind::wholes, .bounds = bounds, .missing = missing, .text = text};
}
/// `missing` is empty where what is taken then is no word.
constexpr Input word(std::string_view key, std::span<const Word> words, std::string_view missing,
                     std::string_view text) {
  return {.key = key, .kind = InputKind::word, .missing_word = missing, .words = words, .text = text};
}
constexpr Input text(std::string_view key, std::string_view what) {
  return {.key = key, .kind = InputKind::text, .text = what};
}

constexpr Input texts(std::string_view key, std::string_view what) {
  return {.key = key, .kind = InputKind::texts, .text = what};
}

/// A case without it is refused.
constexpr Input needed(Input input) {
  input.is_needed = true;
  return input;
}
/// Refused without one of the words of another key.
constexpr Input only(const Condition& condition, Input input) {
  input.only = condition;
  return input;
}
/// A list of numbers may stand for it.
constexpr Input list_or(Input number) {
  number.may_be_list = true;
  return number;
}

/// A section with its inputs, whose `section` is not set yet.
struct Section {
  std::string_view name;
  std::vector<Input> inputs;
  bool is_list = false; ///< files may have many of it
};
/// The inputs of all sections.
inline std::vector<Input> lines_of(std::initializer_list<Section> sections) {
  std::vector<Input> all;
  for (const Section& section : sections)
    for (Input input : section.inputs) {
      input.section = section.name;
      input.is_in_list = section.is_list;
      all.push_back(input);
    }
  return all;
}

} // namespace microslip::description
