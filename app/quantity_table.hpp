#pragma once

#include <string>
#include <vector>

namespace microslip {

/// A table of quantities with their units for people to read: one value each, or several side by side.
class QuantityTable {
public:
  /// `heads` name the columns of values; none: a single column without a head.
  explicit QuantityTable(std::string title, std::vector<std::string> heads = {});

  /// `remark` follows the unit, e.g. the value in other terms.
  void add(const std::string& name, double value, const std::string& unit, const std::string& remark = "");
  void add(const std::string& name, const std::vector<double>& values, const std::string& unit);
  void add(const std::string& name, const std::vector<std::string>& values, const std::string& unit = "");

  /// Writes it to standard output.
  void print() const;

private:
  struct Line {
    std::string name;
    std::vector<std::string> values;
    std::string unit;
  };

  std::string title_;
  std::vector<Line> lines_;
};

} // namespace microslip
