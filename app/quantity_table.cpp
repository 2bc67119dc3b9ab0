#include "app/quantity_table.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace microslip {

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
