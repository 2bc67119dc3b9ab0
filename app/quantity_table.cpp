#include "app/quantity_table.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace microslip {

void QuantityTable::add(const std::string& name, double value, const std::string& unit, const std::string& remark) {
  lines_.push_back({name, fmt::format("{:.6g}", value), remark.empty() ? unit : fmt::format("{:<5} {}", unit, remark)});
}

void QuantityTable::add(const std::string& name, const std::string& value) {
  lines_.push_back({name, value, ""});
}

void QuantityTable::print() const {
  std::size_t names = 0, values = 0;
  for (const auto& line : lines_) {
    names = std::max(names, line.name.size());
    if (!line.unit.empty()) values = std::max(values, line.value.size());
  }
  fmt::print("{}\n", title_);
  for (const auto& line : lines_) {
    if (line.unit.empty())
      fmt::print("  {:<{}}  {}\n", line.name, names, line.value);
    else
      fmt::print("  {:<{}}  {:>{}} {}\n", line.name, names, line.value, values, line.unit);
  }
}

} // namespace microslip
