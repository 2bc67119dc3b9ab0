#include "app/quantity_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace microslip::app {
namespace {

/// Magnitude from which on a number is printed in a unit.
struct Step {
  double from;
  PrintedUnit unit;
};

/// Units of a quantity, the smallest first.
struct Steps {
  std::string_view unit;
  std::vector<Step> steps;
};

const std::vector<Steps>& all_steps() {
  static const std::vector<Steps> all = {
      {"N", {{0, {"mN", 1e3}}, {0.1, {"N", 1}}, {1e4, {"kN", 1e-3}}, {1e7, {"MN", 1e-6}}}},
      {"N m", {{0, {"mN m", 1e3}}, {1e-2, {"N m", 1}}, {1e4, {"kN m", 1e-3}}}},
      {"W", {{0, {"mW", 1e3}}, {1e-2, {"W", 1}}, {1e4, {"kW", 1e-3}}, {1e7, {"MW", 1e-6}}}},
      {"J", {{0, {"mJ", 1e3}}, {1e-2, {"J", 1}}, {1e4, {"kJ", 1e-3}}}},
      {"m", {{0, {"um", 1e6}}, {1e-5, {"mm", 1e3}}, {10, {"m", 1}}}},
      {"m^2", {{0, {"um^2", 1e12}}, {1e-8, {"mm^2", 1e6}}, {1, {"m^2", 1}}}},
      {"Pa", {{0, {"kPa", 1e-3}}, {1e4, {"MPa", 1e-6}}, {1e10, {"GPa", 1e-9}}}},
      {"N/m", {{0, {"N/mm", 1e-3}}, {1e5, {"kN/mm", 1e-6}}}},
  };
  return all;
}

void replace(std::string& text, std::string_view word, std::string_view other) {
  if (const auto at = text.find(word); at != std::string::npos) text.replace(at, word.size(), other);
}

} // namespace

std::string label_of(const Quantity& quantity, const ContactSolution& solution) {
  std::string label(quantity.label);
  if (solution.motion != ContactMotion::shift) return label;
  replace(label, "creepage", "shift");
  replace(label, "power", "work");
  return label;
}

PrintedUnit readable_unit(std::string_view unit, const std::vector<double>& values) {
  const auto& all = all_steps();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Steps& steps) { return steps.unit == unit; });
  if (found == all.end()) return {unit};
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  PrintedUnit best = found->steps[largest > 0 ? 0 : 1].unit;
  for (const auto& [from, candidate] : found->steps)
    if (from > 0 && largest >= from) best = candidate;
  return best;
}

QuantityTable::QuantityTable(std::string title, std::vector<std::string> heads) : title_(std::move(title)) {
  if (!heads.empty()) lines_.push_back({"", std::move(heads), ""});
}

void QuantityTable::round_to_zero(std::string_view unit, double scale) {
  constexpr double rounding = 1e-13;
  noise_.push_back({unit, rounding * std::abs(scale)});
}

void QuantityTable::add(const std::string& name, double value, const std::string& unit, const std::string& remark) {
  add(name, std::vector<double>{value}, unit);
  lines_.back().remark = remark;
}

void QuantityTable::add(const std::string& name, const std::vector<double>& values, const std::string& unit) {
  auto printed = values;
  for (const auto& [of, largest] : noise_)
    for (double& value : printed)
      if (of == unit && std::abs(value) < largest) value = 0;
  const auto [readable, factor] = readable_unit(unit, printed);
  std::vector<std::string> texts;
  for (const double value : printed) texts.push_back(fmt::format("{:.6g}", factor * value));
  lines_.push_back({name, texts, std::string(readable)});
}

void QuantityTable::add(const std::string& name, const std::vector<std::string>& values, const std::string& unit) {
  lines_.push_back({name, values, unit});
}

void QuantityTable::add_quantity(std::string_view name, const ContactSolution& solution, const std::string& remark) {
  const Quantity& q = quantity(name);
  add(label_of(q, solution), q.value(solution), std::string(q.unit_of(solution)), remark);
}

void QuantityTable::add_quantity(std::string_view name, const std::vector<const ContactSolution*>& solutions) {
  const Quantity& q = quantity(name);
  const ContactSolution& first = *solutions.front();
  std::vector<double> values;
  for (const ContactSolution* solution : solutions) values.push_back(q.value(*solution));
  add(label_of(q, first), values, std::string(q.unit_of(first)));
}

void QuantityTable::print() const {
  std::size_t names = 0, values = 0;
  for (const auto& line : lines_) {
    names = std::max(names, line.name.size());
    for (const auto& value : line.values)
      if (line.values.size() > 1 || !line.unit.empty()) values = std::max(values, value.size());
  }
  fmt::print("{}\n", title_);
  for (const auto& line : lines_) {
    fmt::print("  {:<{}}", line.name, names);
    if (line.values.size() == 1 && line.unit.empty())
      fmt::print("  {}", line.values[0]);
    else
      for (const auto& value : line.values) fmt::print("  {:>{}}", value, values);
    const auto unit = line.remark.empty() ? line.unit : fmt::format("{:<5} {}", line.unit, line.remark);
    fmt::print("{}{}\n", unit.empty() ? "" : " ", unit);
  }
}

io::Json QuantityTable::json() const {
  io::Json heads = io::Json::array(), rows = io::Json::array();
  for (const Line& line : lines_)
    if (line.name.empty())
      heads = line.values;
    else
      rows.push_back({{"name", line.name}, {"values", line.values}, {"unit", line.unit}, {"remark", line.remark}});
  return {{"title", title_}, {"heads", heads}, {"rows", rows}};
}

} // namespace microslip::app
