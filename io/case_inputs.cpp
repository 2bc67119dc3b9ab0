#include "io/case_inputs.hpp"

#include "io/nearest_word.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/description/words.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
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

/// A path's section, "" for that of the file itself, and its key.
std::pair<std::string_view, std::string_view> parts_of(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string_view::npos) return {"", path};
  return {path.substr(0, dot), path.substr(dot + 1)};
}

/// A section by its name, "solution.slope_reduction".
TomlSection section_of(const TomlSection& root, std::string_view name) {
  if (name.empty()) return root;
  const std::size_t dot = name.find('.');
  const TomlSection first = root.optional_section(name.substr(0, dot));
  return dot == std::string_view::npos ? first : section_of(first, name.substr(dot + 1));
}

/// Table for writing, made where it is missing.
toml::table& table_of(toml::table& root, std::string_view name) {
  if (name.empty()) return root;
  const std::size_t dot = name.find('.');
  toml::table* const first = root.insert(name.substr(0, dot), toml::table()).first->second.as_table();
  if (first == nullptr) throw Error(std::string(name) + ": must be a table");
  return dot == std::string_view::npos ? *first : table_of(*first, name.substr(dot + 1));
}

/// Erases a value, and the sections that are empty then.
void erase(toml::table& table, std::string_view path) {
  const std::size_t dot = path.find('.');
  const std::string_view first = path.substr(0, dot);
  toml::table* const section = dot == std::string_view::npos ? nullptr : table.get_as<toml::table>(first);
  if (section != nullptr) erase(*section, path.substr(dot + 1));
  if (dot == std::string_view::npos || (section != nullptr && section->empty())) table.erase(first);
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

std::optional<CaseInputs::Value> read_from(const TomlSection& file, std::string_view kind, std::string_view path,
                                           const Input& input) {
  ReadInputs found;
  const TomlSection section = section_of(file.described_by(description::inputs_of(kind), &found), parts_of(path).first);
  if (!section.has(input.key) && !input.missing && input.missing_word.empty()) return {};
  read_input(section, input);
  return found.find(path)->second.value;
}

std::string_view kind_of(const TomlSection& root) {
  if (is_wheelset_case(root)) return wheelset;
  return is_wheel_rail_case(root) ? wheel : bodies;
}

} // namespace

CaseInputs::CaseInputs(std::string_view kind, std::string name) : kind_(kind), name_(std::move(name)) {
  if (kind_ == wheelset) table_of(given_, parts_of(side).first).insert(parts_of(side).second, both);
}

CaseInputs CaseInputs::read(std::string_view text, const std::string& name) {
  toml::table given = parse_toml(text, name);
  CaseInputs inputs(kind_of(TomlSection(given, name)), name);
  inputs.given_ = std::move(given);
  return inputs;
}

const Input& CaseInputs::input(std::string_view path) const {
  const auto& named = description::inputs_of(kind_).named();
  const auto found = std::find_if(named.begin(), named.end(), [&](const NamedInput& n) { return n.path == path; });
  if (found != named.end()) return *found->input;
  std::vector<std::string_view> paths;
  for (const NamedInput& one : named) paths.push_back(one.path);
  throw Error(name_ + ": " + printable(path) + " is no path of an input" + suggestion(path, paths));
}

void CaseInputs::set(std::string_view path, const Value& value) {
  const Input& given = input(path);
  const auto [section, key] = parts_of(path);
  toml::table alone;
  std::visit(Store{table_of(alone, section), key, given}, value);
  read_from(TomlSection(alone, name_), kind_, path, given);
  if (path == side && (std::get<std::string>(value) == both) != (kind_ == wheelset))
    throw Error(
        name_ + ": " + std::string(path) + ": " +
        (kind_ == wheelset ? "must be both in a problem of a wheelset" : "must be left or right, of one wheel"));
  std::visit(Store{table_of(given_, section), key, given}, value);
}

void CaseInputs::unset(std::string_view path) {
  input(path);
  if (path != side || kind_ != wheelset) erase(given_, path);
}

std::optional<CaseInputs::Value> CaseInputs::get(std::string_view path) const {
  return read_from(root(), kind_, path, input(path));
}

std::string CaseInputs::text() const {
  std::ostringstream text;
  text << given_ << '\n';
  return text.str();
}

CaseInputs CaseInputs::without_states() const {
  CaseInputs rest = *this;
  for (const NamedInput& one : description::inputs_of(kind_).named())
    if (one.input->is_state) rest.unset(one.path);
  rest.given_.erase("sweep");
  return rest;
}

} // namespace microslip::io
