#pragma once

#include <string>
#include <vector>

namespace microslip {

/// A table of quantities with their units for people to read.
class QuantityTable {
public:
  explicit QuantityTable(std::string title) : title_(std::move(title)) {}

  /// `remark` follows the unit, e.g. the value in other terms.
  void add(const std::string& name, double value, const std::string& unit, const std::string& remark = "");
  void add(const std::string& name, const std::string& value);

  /// Writes it to standard output.
  void print() const;

private:
  struct Line {
    std::string name, value, unit;
  };

  std::string title_;
  std::vector<Line> lines_;
};

} // namespace microslip
