#include "io/case_inputs.hpp"

#include "io/nearest_word.hpp"
#include "io/toml_path.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/decimal.hpp"
#include "microslip/description/words.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

namespace microslip::io {
namespace {

using description::Input;
using description::InputKind;
using description::NamedInput;

constexpr std::string_view bodies = description::case_kinds[0], wheel = description::case_kinds[1],
                           wheelset = description::case_kinds[2];
/// Tells one wheel from a wheelset, which a problem is from the beginning.
constexpr std::string_view side = "wheel.side", both = "both";

/// TOML in which numbers have seventeen digits, with as few as read back as the same. What is in quotes stays.
std::string with_shortest_numbers(std::string_view text) {
  constexpr std::size_t longest = 17; // of a number that nothing can be gained from
  std::string result;
  char quote = 0; // that is open
  for (std::size_t k = 0; k < text.size();) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789.+-e", k), text.size());
    const bool begins = k > 0 && (text[k - 1] == ' ' || text[k - 1] == '[');
    double value = 0;
    if (quote == 0 && begins && end - k > longest &&
        read_number(text.data() + k, text.data() + end, value).ptr == text.data() + end) {
      result += shortest_text(value);
      k = end;
      continue;
    }
    const char c = text[k++];
    result += c;
    if (c == '\\' && quote == '"' && k < text.size())
      result += text[k++];
    else if (c == quote)
      quote = 0;
    else if (quote == 0 && (c == '"' || c == '\''))
      quote = c;
  }
  return result;
}

bool is_whole(const Input& input) {
  return input.kind == InputKind::whole || input.kind == InputKind::wholes;
}

/// A whole number if the input is one.
void add(toml::array& list, double value, const Input& input) {
  constexpr double largest = 1e15; // far beyond all bounds
  if (is_whole(input) && value == std::floor(value) && std::abs(value) < largest)
    list.push_back(static_cast<std::int64_t>(value));
  else
    list.push_back(value);
}

struct Store {
  toml::table& table;
  std::string_view key;
  const Input& input;

  void operator()(double value) const {
    toml::array one;
    add(one, value, input);
    table.insert_or_assign(key, std::move(*one.get(0)));
  }
  void operator()(const std::string& value) const { table.insert_or_assign(key, value); }
  void operator()(const std::vector<double>& values) const {
    toml::array list;
    for (const double value : values) add(list, value, input);
    table.insert_or_assign(key, std::move(list));
  }
  void operator()(const std::vector<std::string>&) const { throw Error(std::string(key) + ": is no list of texts"); }
};

/// Reads one input, which stands with what was read of the section then.
void read_input(const TomlSection& section, const Input& input) {
  const std::string_view key = input.key;
  switch (input.kind) {
  case InputKind::number:
    input.may_be_list&& section.is_list(key) ? void(section.numbers(key)) : void(section.number(key));
    return;
  case InputKind::numbers:
    section.numbers(key);
    return;
  case InputKind::whole:
    section.whole(key);
    return;
  case InputKind::wholes:
    section.wholes(key);
    return;
  case InputKind::text:
    section.text(key, "");
    return;
  case InputKind::texts:
    section.texts(key);
    return;
  case InputKind::word:
    section.word(key);
  }
}

/// The value under a path, from the section that it names; `read` is what that has read.
std::optional<CaseInputs::Value> read_from(const TomlSection& section, const ReadInputs& read, std::string_view path,
                                           const Input& input) {
  if (!section.has(input.key) && !input.missing && input.missing_word.empty()) return {};
  read_input(section, input);
  return read.find(path)->second.value;
}

/// The path of the first in its list, for one of a list.
std::string path_of_first(std::string_view path, const Input* input) {
  if (input == nullptr || !input->is_in_list) return std::string(path);
  const auto [section, key] = section_and_key(path);
  return std::string(section_and_key(section).first).append(".1.").append(key);
}

std::string_view kind_of(const TomlSection& root) {
  if (is_wheelset_case(root)) return wheelset;
  return is_wheel_rail_case(root) ? wheel : bodies;
}

} // namespace

CaseInputs::CaseInputs(std::string_view kind, std::string name) : kind_(kind), name_(std::move(name)) {
  if (kind_ == wheelset) {
    const auto [section, key] = section_and_key(side);
    table_at(given_, section).insert(key, both);
  }
}

CaseInputs CaseInputs::read(std::string_view text, const std::string& name) {
  toml::table given = parse_toml(text, name);
  CaseInputs inputs(kind_of(TomlSection(given, name)), name);
  inputs.given_ = std::move(given);
  return inputs;
}

const Input& CaseInputs::input(std::string_view path) const {
  const description::InputTable& table = description::inputs_of(kind_);
  const auto [section, key] = section_and_key(path);
  const std::string of_table = path_of_first(path, table.find(section, key));
  std::vector<std::string_view> paths;
  for (const NamedInput& one : table.named()) {
    if (one.path == of_table) return *one.input;
    paths.push_back(one.path);
  }
  throw Error(name_ + ": " + printable(path) + " is no path of an input" + suggestion(path, paths));
}

toml::table& CaseInputs::table_of(std::string_view path) {
  try {
    return table_at(given_, section_and_key(path).first);
  } catch (const Error& error) {
    erase_at(given_, path);
    throw Error(name_ + ": " + error.what());
  }
}

void CaseInputs::set(std::string_view path, const Value& value) {
  const Input& given = input(path);
  const auto [section, key] = section_and_key(path);
  toml::table alone;
  std::visit(Store{alone, key, given}, value);
  read_input(TomlSection(alone, name_)
                 .described_by(description::inputs_of(kind_))
                 .inside(alone, std::string(section), given.section),
             given);
  if (path == side && (std::get<std::string>(value) == both) != (kind_ == wheelset))
    throw Error(
        name_ + ": " + std::string(path) + ": " +
        (kind_ == wheelset ? "must be both in a problem of a wheelset" : "must be left or right, of one wheel"));
  std::visit(Store{table_of(path), key, given}, value);
}

void CaseInputs::unset(std::string_view path) {
  input(path);
  if (path != side || kind_ != wheelset) erase_at(given_, path);
}

std::optional<CaseInputs::Value> CaseInputs::get(std::string_view path) const {
  const Input& wanted = input(path);
  ReadInputs read;
  const TomlSection file = root().described_by(description::inputs_of(kind_), &read);
  return read_from(file.at_path(section_and_key(path).first), read, path, wanted);
}

std::string CaseInputs::text() const {
  std::ostringstream text;
  text << given_ << '\n';
  return with_shortest_numbers(text.str());
}

CaseInputs CaseInputs::without_states() const {
  CaseInputs rest = *this;
  for (const NamedInput& one : description::inputs_of(kind_).named())
    if (one.input->is_state) rest.unset(one.path);
  rest.given_.erase("sweep");
  return rest;
}

} // namespace microslip::io
