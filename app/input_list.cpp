#include "app/input_list.hpp"

#include "microslip/decimal.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {
namespace {

using description::Input;
using description::InputKind;

/// Range of the value of a key.
std::string range_of(const Input& input) {
  if (!input.words.empty()) return fmt::format("{}", fmt::join(input.words, "|"));
  switch (input.kind) {
  case InputKind::number:
    return input.bounds.text();
  case InputKind::numbers:
    return input.bounds.text().empty() ? "list of numbers" : "list of numbers, each " + input.bounds.text();
  case InputKind::whole:
    return "whole, " + input.bounds.text();
  case InputKind::wholes:
    return "one or two whole, " + input.bounds.text();
  case InputKind::texts:
    return "list of texts";
  case InputKind::text:
  case InputKind::word:
    return "text";
  }
  return "";
}

std::string default_of(const Input& input) {
  if (!input.missing_word.empty()) return std::string(input.missing_word);
  if (!input.missing_numbers.empty()) return fmt::format("{}", fmt::join(input.missing_numbers, ", "));
  if (input.missing) return shortest_text(*input.missing);
  return input.is_needed ? "needed" : "";
}

/// Heading of a section, as in files.
std::string heading(const description::InputTable& table, std::string_view section) {
  const std::vector<std::string_view> names = table.names(section);
  const bool is_list = std::any_of(table.inputs().begin(), table.inputs().end(),
                                   [&](const Input& input) { return input.section == section && input.is_in_list; });
  return is_list ? fmt::format("[[{}]]", fmt::join(names, "]], [[")) : fmt::format("[{}]", fmt::join(names, "], ["));
}

} // namespace

std::string input_list(const description::InputTable& table) {
  using Row = std::array<std::string, 4>;
  std::vector<std::pair<std::string_view, std::vector<std::pair<Row, std::string_view>>>> sections;
  std::array<std::size_t, 4> widths{};
  for (const Input& input : table.inputs()) {
    const auto same = std::find_if(sections.begin(), sections.end(),
                                   [&](const auto& section) { return section.first == input.section; });
    auto& section = same != sections.end()
                        ? *same
                        : sections.emplace_back(input.section, std::vector<std::pair<Row, std::string_view>>());
    const Row row = {std::string(input.key), std::string(input.unit), default_of(input), range_of(input)};
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
    section.second.emplace_back(row, input.text);
  }
  std::string text;
  for (const auto& [name, rows] : sections) {
    if (!text.empty()) text += '\n';
    if (!name.empty()) text += heading(table, name) + '\n';
    for (const auto& [row, what] : rows) {
      std::string line;
      for (std::size_t k = 0; k < row.size(); ++k) line += fmt::format("{:<{}}  ", row[k], widths[k]);
      text += line.substr(0, line.find_last_not_of(' ') + 1) + fmt::format("\n    {}\n", what);
    }
  }
  return text;
}

} // namespace microslip::app
