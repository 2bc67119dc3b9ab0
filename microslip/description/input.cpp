#include "microslip/description/input.hpp"

#include "microslip/decimal.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace microslip::description {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string range_of(const Input& input) {
  if (input.words.empty()) return input.bounds.text();
  std::string words;
  for (const std::string_view word : input.words)
    words.append(words.empty() ? "" : word == input.words.back() ? " or " : ", ").append(word);
  return words;
}

} // namespace

void Bounds::require(std::string_view field, double value, std::string_view unit) const {
  switch (kind) {
  case Kind::finite:
    require_finite(field, value, unit);
    return;
  case Kind::positive:
    require_positive(field, value, unit);
    return;
  case Kind::between:
    require_between(field, value, unit, low, high);
    return;
  case Kind::radius:
    require_radius(field, value);
    return;
  case Kind::modulus:
    if (!(value > 0)) throw Error(field, value, unit, "positive (inf for a rigid body)");
  }
}

std::string Bounds::text() const {
  switch (kind) {
  case Kind::finite:
    return "";
  case Kind::positive:
    return "positive";
  case Kind::between:
    return "in [" + shortest_text(low) + ", " + shortest_text(high) + "]";
  case Kind::radius:
    return "not 0; inf: flat, negative: concave";
  case Kind::modulus:
    return "positive; inf: rigid";
  }
  return "";
}

double Bounds::least() const {
  if (kind == Kind::between) return low;
  return kind == Kind::positive || kind == Kind::modulus ? 0 : -infinity;
}

double Bounds::largest() const {
  return kind == Kind::between ? high : infinity;
}

InputTable::InputTable(std::vector<Input> inputs, std::vector<Shared> shared)
    : inputs_(std::move(inputs)), shared_(std::move(shared)) {
  for (auto first = inputs_.begin(); first != inputs_.end();) {
    const auto end = std::find_if(first, inputs_.end(), [&](const Input& i) { return i.section != first->section; });
    for (const std::string_view name : names(first->section))
      for (auto input = first; input != end; ++input) {
        const char* between = name.empty() ? "" : input->is_in_list ? ".1." : ".";
        named_.push_back({std::string(name).append(between).append(input->key), &*input, range_of(*input)});
      }
    first = end;
  }
}

bool InputTable::has(const Input& input, std::string_view section) const {
  return input.section == section || std::any_of(shared_.begin(), shared_.end(), [&](const Shared& shared) {
           return shared.in_files == section && shared.in_table == input.section;
         });
}

std::vector<std::string_view> InputTable::keys(std::string_view section) const {
  std::vector<std::string_view> found;
  for (const Input& input : inputs_)
    if (has(input, section)) found.push_back(input.key);
  return found;
}

std::vector<std::string_view> InputTable::names(std::string_view section) const {
  std::vector<std::string_view> found;
  for (const Shared& shared : shared_)
    if (shared.in_table == section) found.push_back(shared.in_files);
  return found.empty() ? std::vector{section} : found;
}

const Input* InputTable::find(std::string_view section, std::string_view key) const {
  const std::string_view list = section.substr(0, section.find_last_not_of("0123456789"));
  const bool is_one_of_list = !list.empty() && list.size() + 1 < section.size() && section[list.size()] == '.';
  const auto found = std::find_if(inputs_.begin(), inputs_.end(), [&](const Input& input) {
    return input.key == key && has(input, input.is_in_list && is_one_of_list ? list : section);
  });
  return found == inputs_.end() ? nullptr : &*found;
}

const InputTable& inputs_of(std::string_view kind) {
  constexpr std::array<const InputTable& (*)(), input_kinds.size()> tables = {
      rolling_inputs, wheel_inputs, wheelset_inputs, sweep_inputs, conicity_inputs, creep_table_inputs};
  const auto place = std::find(input_kinds.begin(), input_kinds.end(), kind) - input_kinds.begin();
  return tables.at(static_cast<std::size_t>(place))();
}

} // namespace microslip::description
