#include "io/toml_section.hpp"

#include "io/nearest_word.hpp"
#include "io/text_line.hpp"
#include "io/toml_path.hpp"
#include "io/units.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace microslip::io {
namespace {

std::string type_name(const toml::node& node) {
  switch (node.type()) {
  case toml::node_type::table:
    return "a table";
  case toml::node_type::array:
    return "a list";
  case toml::node_type::string:
    return "text";
  case toml::node_type::integer:
  case toml::node_type::floating_point:
    return "a number";
  case toml::node_type::boolean:
    return "true or false";
  default:
    return "a date or time";
  }
}

/// Location in a file; an entry that a program has put into a table has no line.
std::string location(const std::string& file, std::size_t line) {
  return line == 0 ? file + ": " : file + ":" + std::to_string(line) + ": ";
}

std::string location(const std::string& file, const toml::source_region& source) {
  return location(file, source.begin.line);
}

/// toml++ limits the nesting of values, but recurses without limit into tables of a key such as a.a.a.a.
void refuse_deep_keys(std::string_view text, const std::string& file) {
  constexpr int most = 500;
  std::size_t line = 1;
  int dots = 0;
  for (const char letter : text) {
    if (letter == '\n') {
      ++line;
      dots = 0;
    } else if (letter == '.' && ++dots > most) {
      throw Error(location(file, line) + "more than 500 dots in one line: nested too deeply");
    }
  }
}

bool meets_assertion(std::string_view text) {
  try {
    static_cast<void>(toml::parse(text));
  } catch (const toml::parse_error&) {
    return false;
  } catch (const detail::TomlAssertion&) {
    return true;
  }
  return false;
}

/// The line at which toml++ meets an assertion: the first lines up to it do, fewer do not.
std::size_t line_of_assertion(std::string_view text) {
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') ends.push_back(i);
  const auto end = std::partition_point(ends.begin(), ends.end(),
                                        [&](std::size_t n) { return !meets_assertion(text.substr(0, n)); });
  return static_cast<std::size_t>(end - ends.begin()) + 1;
}

} // namespace

toml::table parse_toml(std::string_view text, const std::string& file) {
  if (is_no_utf8(text)) throw Error(file + ": is UTF-16 or no text; it must be UTF-8 or ASCII");
  refuse_deep_keys(text, file);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw Error(location(file, error.source()) + std::string(error.description()));
  } catch (const detail::TomlAssertion&) {
    throw Error(location(file, line_of_assertion(text)) + "cannot be understood as TOML");
  }
}

TomlSection::KeyUnits TomlSection::units_of(const ReadKeys& keys) {
  KeyUnits units;
  for (const auto& [key, read] : keys)
    if (read.is_given && !read.unit.empty()) units.emplace(key, read.unit);
  return units;
}

TomlSection TomlSection::required_section(std::string_view name) const {
  if (!has(name)) throw Error(file_ + ": [" + full(name) + "] is missing");
  return optional_section(name);
}

TomlSection TomlSection::optional_section(std::string_view name) const {
  const auto* node = find(name);
  if (node != nullptr && !node->is_table()) wrong_type(name, *node, "a table");
  TomlSection found(node == nullptr ? nullptr : node->as_table(), full(name), *this);
  found.section_ = section_.empty() ? std::string(name) : section_ + "." + std::string(name);
  return found;
}

std::vector<TomlSection> TomlSection::sections(std::string_view name) const {
  std::vector<TomlSection> found;
  const auto* node = find(name);
  if (node == nullptr) return found;
  const auto* list = node->as_array();
  if (list == nullptr) wrong_type(name, *node, "a list of tables, [[" + full(name) + "]]");
  const std::string section = section_.empty() ? std::string(name) : section_ + "." + std::string(name);
  for (const auto& element : *list) {
    if (!element.is_table()) wrong_type(name, element, "a list of tables, [[" + full(name) + "]]");
    const std::string one = full(name) + "." + std::to_string(found.size() + 1);
    found.push_back(inside(*element.as_table(), one, section));
  }
  return found;
}

TomlSection TomlSection::at_path(std::string_view path) const {
  if (path.empty()) return *this;
  const auto [name, rest, place] = first_step(path);
  if (!place) return optional_section(name).at_path(rest);
  const std::vector<TomlSection> list = sections(name);
  if (*place - 1 < list.size()) return list[*place - 1].at_path(rest);
  return TomlSection(nullptr, full(name) + "." + std::to_string(*place), *this);
}

void TomlSection::allow(const Words& keys) const {
  if (table_ == nullptr) return;
  const toml::key* unknown = nullptr;
  for (const auto& [key, value] : *table_) {
    if (std::find(keys.begin(), keys.end(), std::string_view(key.str())) != keys.end()) continue;
    if (unknown == nullptr || key.source().begin < unknown->source().begin) unknown = &key;
  }
  if (unknown == nullptr) return;
  const auto near = suggestion(unknown->str(), keys);
  throw Error(location(file_, unknown->source()) + full(unknown->str()) + ": unknown key" +
              (near.empty() ? "; must be " + listed(keys) : near));
}

TomlSection TomlSection::described_by(const description::InputTable& inputs, ReadInputs* read) const {
  TomlSection described(table_, name_, *this);
  described.inputs_ = &inputs;
  if (read != nullptr) described.read_ = read;
  return described;
}

TomlSection TomlSection::inside(const toml::table& table, std::string name, std::string_view section) const {
  TomlSection found(&table, std::move(name), *this);
  found.section_ = section;
  return found;
}

void TomlSection::allow_described(const Words& more) const {
  Words keys = inputs_->keys(section_);
  keys.insert(keys.end(), more.begin(), more.end());
  allow(keys);
  for (const auto key : keys)
    if (has(key) && is_described(key)) require_condition(input(key));
}

void TomlSection::require_condition(const description::Input& input) const {
  const description::Condition& only = input.only;
  if (only.key.empty()) return;
  if (std::find(only.words.begin(), only.words.end(), word(only.key)) != only.words.end()) return;
  at(input.key, [&] { throw Error(full(input.key) + ": needs " + full(only.key) + " = " + listed(only.words, "or")); });
}

const description::Input& TomlSection::input(std::string_view key) const {
  const description::Input* found = inputs_->find(section_, key);
  if (found == nullptr) throw std::logic_error(full(key) + ": is in no table of inputs");
  return *found;
}

double TomlSection::number(std::string_view key) const {
  const description::Input& described = input(key);
  return number(key, described.unit, described.missing, [&](auto field, double value) {
    described.bounds.require(field, value, described.unit);
    return value;
  });
}

std::optional<double> TomlSection::optional_number(std::string_view key) const {
  return has(key) ? std::optional(number(key)) : std::nullopt;
}

int TomlSection::whole(std::string_view key) const {
  const description::Input& described = input(key);
  if (described.is_needed && !has(key)) refuse_missing(key);
  int value = static_cast<int>(described.missing.value_or(0));
  count(key, static_cast<int>(described.bounds.low), static_cast<int>(described.bounds.high), value);
  return value;
}

std::pair<int, int> TomlSection::wholes(std::string_view key) const {
  const description::Input& described = input(key);
  const int missing = static_cast<int>(described.missing.value_or(0));
  std::pair values{missing, missing};
  counts(key, static_cast<int>(described.bounds.low), static_cast<int>(described.bounds.high), values.first,
         values.second);
  return values;
}

std::vector<double> TomlSection::numbers(std::string_view key) const {
  return numbers(key, input(key).unit);
}

std::string TomlSection::word(std::string_view key) const {
  const description::Input& described = input(key);
  return word(key, described.missing_word, described.words);
}

std::string_view TomlSection::one_of(std::initializer_list<std::string_view> keys) const {
  Words there;
  for (const std::string_view key : keys)
    if (has(key)) there.push_back(key);
  if (there.size() == 1) return there.front();
  const std::string_view last = there.empty() ? *(keys.end() - 1) : there.back();
  throw Error(line_of(last) + in_section(" ") + "needs " + (keys.size() == 2 ? "either " : "one of ") +
              listed(Words(keys), "or"));
}

double TomlSection::finite(std::string_view key, std::string_view unit, std::optional<double> missing) const {
  return number(key, unit, missing, [&](auto field, double value) { return require_finite(field, value, unit); });
}

double TomlSection::between(std::string_view key, std::string_view unit, double low, double high,
                            std::optional<double> missing) const {
  return number(key, unit, missing,
                [&](auto field, double value) { return require_between(field, value, unit, low, high); });
}

std::vector<double> TomlSection::numbers(std::string_view key, std::string_view unit) const {
  const auto* node = find(key);
  if (node == nullptr) refuse_missing(key);
  const auto* list = node->as_array();
  if (list == nullptr) wrong_type(key, *node, "a list of numbers");
  if (list->empty()) throw Error(location(file_, node->source()) + full(key) + ": must have at least one number");
  std::vector<double> values;
  for (const auto& element : *list) {
    values.push_back(value_of(key, element, unit, "a list of numbers"));
    at(key, [&] { require_finite(full(key), values.back(), unit); });
  }
  record(key, values, unit);
  return values;
}

std::string TomlSection::text(std::string_view key, std::string_view missing) const {
  const auto* node = find(key);
  if (node != nullptr && !node->is_string()) wrong_type(key, *node, "text");
  std::string value(node == nullptr ? missing : std::string_view(node->as_string()->get()));
  record(key, value, "");
  return value;
}

std::vector<std::string> TomlSection::texts(std::string_view key) const {
  const auto* node = find(key);
  if (node == nullptr) return {};
  const auto* list = node->as_array();
  if (list == nullptr) wrong_type(key, *node, "a list of texts");
  std::vector<std::string> values;
  for (const auto& element : *list) {
    if (!element.is_string()) wrong_type(key, element, "a list of texts");
    values.push_back(element.as_string()->get());
  }
  record(key, values, "");
  return values;
}

std::string TomlSection::required_text(std::string_view key) const {
  if (!has(key)) refuse_missing(key);
  auto value = text(key, "");
  at(key, [&] {
    if (value.empty()) throw Error(full(key) + ": must not be empty");
  });
  return value;
}

bool TomlSection::is_list(std::string_view key) const {
  return has(key) && find(key)->is_array();
}

bool TomlSection::is_text(std::string_view key) const {
  return has(key) && find(key)->is_string();
}

std::string TomlSection::word(std::string_view key, std::string_view missing,
                              std::span<const std::string_view> words) const {
  auto value = text(key, missing);
  at(key, [&] { require_word(full(key), value, words); });
  return value;
}

int TomlSection::whole(std::string_view key, const toml::node& node, int low, int high) const {
  const auto value = node.as_integer()->get();
  at(key, [&] { require_between(full(key), static_cast<double>(value), "-", low, high); });
  return static_cast<int>(value);
}

void TomlSection::count(std::string_view key, int low, int high, int& value) const {
  const auto* node = find(key);
  if (node != nullptr) {
    if (!node->is_integer()) wrong_type(key, *node, "a whole number");
    value = whole(key, *node, low, high);
  }
  record(key, static_cast<double>(value), "");
}

void TomlSection::counts(std::string_view key, int low, int high, int& first, int& second) const {
  const auto* node = find(key);
  if (node != nullptr && node->is_integer()) {
    first = second = whole(key, *node, low, high);
  } else if (node != nullptr) {
    const auto* list = node->as_array();
    if (list == nullptr || list->size() != 2 || !list->get(0)->is_integer() || !list->get(1)->is_integer())
      throw Error(location(file_, node->source()) + full(key) + ": must be a whole number or a list of two");
    first = whole(key, *list->get(0), low, high);
    second = whole(key, *list->get(1), low, high);
  }
  record(key, std::vector<double>{static_cast<double>(first), static_cast<double>(second)}, "");
}

void TomlSection::at(std::string_view key, const std::function<void()>& check) const {
  try {
    check();
  } catch (const Error& error) {
    throw Error(line_of(key) + error.what());
  }
}

std::string TomlSection::full(std::string_view key) const {
  return name_.empty() ? std::string(key) : name_ + "." + std::string(key);
}

std::string TomlSection::line_of(std::string_view key) const {
  const auto* node = find(key);
  if (node != nullptr) return location(file_, node->source());
  return table_ != nullptr ? location(file_, table_->source()) : file_ + ": ";
}

std::string TomlSection::in_section(const char* after) const {
  return name_.empty() ? "" : "[" + name_ + "]" + after;
}

void TomlSection::refuse_missing(std::string_view key) const {
  throw Error(line_of(key) + in_section(": ") + std::string(key) + " is missing");
}

void TomlSection::wrong_type(std::string_view key, const toml::node& node, const std::string& wanted) const {
  throw Error(location(file_, node.source()) + full(key) + ": must be " + wanted + ", not " + type_name(node));
}

void TomlSection::record(std::string_view key, ReadInput::Value value, std::string_view unit) const {
  const ReadInput read{std::move(value), std::string(unit), has(key)};
  for (ReadInputs* inputs : {keys_, read_})
    if (inputs != nullptr) inputs->insert_or_assign(full(key), read);
}

double TomlSection::value_of(std::string_view key, const toml::node& node, std::string_view unit,
                             const std::string& wanted) const {
  record(key, std::numeric_limits<double>::quiet_NaN(), unit);
  if (node.is_integer()) return static_cast<double>(node.as_integer()->get());
  if (node.is_floating_point()) return node.as_floating_point()->get();
  if (!node.is_string()) wrong_type(key, node, wanted);
  double value = 0;
  at(key, [&] { value = number_in_unit(full(key), node.as_string()->get(), unit); });
  return value;
}

double TomlSection::number(std::string_view key, std::string_view unit, std::optional<double> missing,
                           const Check& check) const {
  const auto* node = find(key);
  if (node == nullptr && missing) {
    record(key, *missing, unit);
    return *missing;
  }
  if (node == nullptr) refuse_missing(key);
  const double value = value_of(key, *node, unit, "a number");
  at(key, [&] { check(full(key), value); });
  record(key, value, unit);
  return value;
}

} // namespace microslip::io
