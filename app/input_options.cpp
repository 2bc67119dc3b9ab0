#include "app/input_options.hpp"

#include "io/option_words.hpp"
#include "microslip/decimal.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {
namespace {

using description::Input;

template <class Number> void set_default(const Input& input, Number& value) {
  if (input.missing) value = static_cast<Number>(*input.missing);
}
void set_default(const Input&, std::optional<double>&) {}
void set_default(const Input& input, std::string& word) {
  word = input.missing_word;
}
void set_default(const Input& input, std::vector<double>& values) {
  values.assign(input.missing_numbers.begin(), input.missing_numbers.end());
}

std::string default_text(const Input& input) {
  if (!input.missing_numbers.empty()) return fmt::format("{}", fmt::join(input.missing_numbers, " "));
  return input.missing ? shortest_text(*input.missing) : std::string(input.missing_word);
}

void require(const Input& input, const std::string& option, double value) {
  input.bounds.require(option, value, input.unit.empty() ? "-" : input.unit);
}
void require(const Input& input, const std::string& option, const std::optional<double>& value) {
  if (value) require(input, option, *value);
}
void require(const Input& input, const std::string& option, const std::vector<double>& values) {
  for (const double value : values) require(input, option, value);
}
void require(const Input& input, const std::string& option, const std::string& word) {
  if (!word.empty() && !input.words.empty()) io::require_word(option, word, input.words);
}

} // namespace

std::string InputOptions::name(std::string_view key) const {
  std::string words(key);
  std::replace(words.begin(), words.end(), '_', '-');
  return "--" + prefix_ + words;
}

template <class Value>
CommandOption InputOptions::add(Command& command, std::string_view key, Value& value, std::string type,
                                bool is_given_only) {
  const Input& input = *table_->find(section_, key);
  if (!is_given_only) set_default(input, value);
  checks_.emplace_back([&input, &value, option = name(key)] { app::require(input, option, value); });
  std::string what = text(key);
  if (!input.unit.empty()) what += fmt::format(" [{}]", input.unit);
  if (const std::string range = input.bounds.text(); !range.empty()) what += ", " + range;
  if (!input.words.empty()) type = fmt::format("{}", fmt::join(input.words, "|"));
  return command.add_option(name(key) + " " + type, value, what).default_str(default_text(input));
}

template CommandOption InputOptions::add(Command&, std::string_view, double&, std::string, bool);
template CommandOption InputOptions::add(Command&, std::string_view, int&, std::string, bool);
template CommandOption InputOptions::add(Command&, std::string_view, std::optional<double>&, std::string, bool);
template CommandOption InputOptions::add(Command&, std::string_view, std::vector<double>&, std::string, bool);
template CommandOption InputOptions::add(Command&, std::string_view, std::string&, std::string, bool);

void InputOptions::require() const {
  for (const auto& check : checks_) check();
}

} // namespace microslip::app
