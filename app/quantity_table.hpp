#pragma once

#include "microslip/contact/quantities.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// What a printed table calls a quantity: a shift has shifts and work where rolling has creepages and power.
std::string label_of(const Quantity& quantity, const ContactSolution& solution);

/// A table of quantities with their units for people to read: one value each, or several side by side.
class QuantityTable {
public:
  /// `heads` name the columns of values; none: a single column without a head.
  explicit QuantityTable(std::string title, std::vector<std::string> heads = {});

  /// `remark` follows the unit, e.g. the value in other terms.
  void add(const std::string& name, double value, const std::string& unit, const std::string& remark = "");
  void add(const std::string& name, const std::vector<double>& values, const std::string& unit);
  void add(const std::string& name, const std::vector<std::string>& values, const std::string& unit = "");

  /// A quantity of the library's table, by its name: label and unit from there, with mm^2 and MPa for m^2 and Pa.
  void add_quantity(std::string_view name, const ContactSolution& solution, const std::string& remark = "");
  void add_quantity(std::string_view name, const std::vector<const ContactSolution*>& solutions);

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
