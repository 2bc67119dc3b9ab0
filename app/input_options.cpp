#include "app/input_options.hpp"

#include "io/option_words.hpp"
#include "microslip/decimal.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {

using description::Input;

InputOptions::InputOptions(const description::InputTable& table, std::string_view section, std::string prefix,
                           const std::string& of)
    : table_(&table), section_(section), prefix_(std::move(prefix)), of_(of.empty() ? "" : of + ": ") {}

std::string InputOptions::name(std::string_view key) const {
  std::string words(key);
  std::replace(words.begin(), words.end(), '_', '-');
  return "--" + prefix_ + words;
}

const Input& InputOptions::input(std::string_view key) const {
  const Input* found = table_->find(section_, key);
  if (found == nullptr) throw std::logic_error(std::string(key) + ": is in no table of inputs");
  return *found;
}

template <class Value>
CommandOption InputOptions::add_option(Command& command, std::string_view key, Value& value, const std::string& type) {
  const Input& described = input(key);
  std::string what = of_ + std::string(described.text);
  if (!described.unit.empty()) what += fmt::format(" [{}]", described.unit);
  if (const std::string range = described.bounds.text(); !range.empty()) what += ", " + range;
  return command.add_option(name(key) + " " + type, value, what);
}

CommandOption InputOptions::add(Command& command, std::string_view key, double& value) {
  const Input& described = input(key);
  value = described.missing.value();
  checks_.emplace_back([&, option = name(key)] { described.bounds.require(option, value, described.unit); });
  return add_option(command, key, value, "VALUE").capture_default_str();
}

CommandOption InputOptions::add(Command& command, std::string_view key, std::optional<double>& value) {
  const Input& described = input(key);
  checks_.emplace_back([&, option = name(key)] {
    if (value) described.bounds.require(option, *value, described.unit);
  });
  CommandOption added = add_option(command, key, value, "VALUE");
  if (described.missing) added.default_str(shortest_text(*described.missing));
  return added;
}

CommandOption InputOptions::add(Command& command, std::string_view key, int& value) {
  const Input& described = input(key);
  value = static_cast<int>(described.missing.value());
  checks_.emplace_back([&, option = name(key)] { described.bounds.require(option, value, "-"); });
  return add_option(command, key, value, "COUNT").capture_default_str();
}

CommandOption InputOptions::add(Command& command, std::string_view key, std::vector<double>& values,
                                const std::string& type) {
  const Input& described = input(key);
  values.assign(described.missing_numbers.begin(), described.missing_numbers.end());
  checks_.emplace_back([&, option = name(key)] {
    for (const double value : values) described.bounds.require(option, value, described.unit);
  });
  CommandOption added = add_option(command, key, values, type);
  if (!values.empty()) added.default_str(fmt::format("{}", fmt::join(values, " ")));
  return added;
}

CommandOption InputOptions::add(Command& command, std::string_view key, std::string& word, bool has_default) {
  const Input& described = input(key);
  if (has_default) word = described.missing_word;
  checks_.emplace_back([&, option = name(key)] {
    if (!word.empty()) io::require_word(option, word, described.words);
  });
  CommandOption added = add_option(command, key, word, fmt::format("{}", fmt::join(described.words, "|")));
  if (!described.missing_word.empty()) added.default_str(std::string(described.missing_word));
  return added;
}

CommandOption InputOptions::add_text(Command& command, std::string_view key, std::string& text,
                                     const std::string& type) {
  return add_option(command, key, text, type);
}

void InputOptions::require() const {
  for (const auto& check : checks_) check();
}

} // namespace microslip::app
