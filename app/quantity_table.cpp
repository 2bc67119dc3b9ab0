#include "app/quantity_table.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace microslip {
namespace {

struct PrintedUnit {
  std::string_view name;
  double factor;
};

PrintedUnit printed_unit(std::string_view unit) {
  if (unit == "m^2") return {"mm^2", 1e6};
  if (unit == "Pa") return {"MPa", 1e-6};
  return {unit, 1};
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

QuantityTable::QuantityTable(std::string title, std::vector<std::string> heads) : title_(std::move(title)) {
  if (!heads.empty()) lines_.push_back({"", std::move(heads), ""});
}

void QuantityTable::add(const std::string& name, double value, const std::string& unit, const std::string& remark) {
  lines_.push_back(
      {name, {fmt::format("{:.6g}", value)}, remark.empty() ? unit : fmt::format("{:<5} {}", unit, remark)});
}

void QuantityTable::add(const std::string& name, const std::vector<double>& values, const std::string& unit) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(fmt::format("{:.6g}", value));
  lines_.push_back({name, texts, unit});
}

void QuantityTable::add(const std::string& name, const std::vector<std::string>& values, const std::string& unit) {
  lines_.push_back({name, values, unit});
}

void QuantityTable::add_quantity(std::string_view name, const ContactSolution& solution, const std::string& remark) {
  const Quantity& q = quantity(name);
  const auto [unit, factor] = printed_unit(q.unit_of(solution));
  add(label_of(q, solution), factor * q.value(solution), std::string(unit), remark);
}

void QuantityTable::add_quantity(std::string_view name, const std::vector<const ContactSolution*>& solutions) {
  const Quantity& q = quantity(name);
  const ContactSolution& first = *solutions.front();
  const auto [unit, factor] = printed_unit(q.unit_of(first));
  std::vector<double> values;
  for (const ContactSolution* solution : solutions) values.push_back(factor * q.value(*solution));
  add(label_of(q, first), values, std::string(unit));
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
    fmt::print("{}{}\n", line.unit.empty() ? "" : " ", line.unit);
  }
}

} // namespace microslip
