#pragma once

#include "io/json.hpp"
#include "microslip/contact/quantities.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace microslip::app {

/// Name of a quantity in a printed table: a shift has shifts and work where rolling has creepages and power.
std::string label_of(const Quantity& quantity, const ContactSolution& solution);

/// A unit and what a number in SI units is multiplied by for it.
struct PrintedUnit {
  std::string_view name;
  double factor = 1;
};

/// The unit in which the largest of some numbers is easily read: kN for 80000 N, mm for 0.0067 m, MPa for 1.1e9 Pa.
/// Units that are not known, mm among them, stay as they are.
PrintedUnit readable_unit(std::string_view unit, const std::vector<double>& values);

/// A table of quantities with their units for people to read: one value each, or several side by side. Numbers in SI
/// units are printed in readable ones.
class QuantityTable {
public:
  /// `heads` name the columns of values; none: a single column without a head.
  explicit QuantityTable(std::string title, std::vector<std::string> heads = {});

  /// Numbers of this unit, in SI, that are smaller than the rounding errors of numbers as large as `scale` are zeros.
  void round_to_zero(std::string_view unit, double scale);

  /// `remark` follows the unit, e.g. the value in other terms.
  void add(const std::string& name, double value, const std::string& unit, const std::string& remark = "");
  void add(const std::string& name, const std::vector<double>& values, const std::string& unit);
  void add(const std::string& name, const std::vector<std::string>& values, const std::string& unit = "");

  /// A quantity of the library's table, by its name: label and unit from there.
  void add_quantity(std::string_view name, const ContactSolution& solution, const std::string& remark = "");
  void add_quantity(std::string_view name, const std::vector<const ContactSolution*>& solutions);

  /// Writes it to standard output.
  void print() const;
  /// The same texts as `title`, `heads` of the columns and `rows` with `name`, `values`, `unit` and `remark`.
  io::Json json() const;

private:
  struct Line {
    std::string name;
    std::vector<std::string> values;
    std::string unit, remark = {};
  };

  struct Noise {
    std::string_view unit;
    double largest;
  };

  std::string title_;
  std::vector<Line> lines_;
  std::vector<Noise> noise_;
};

} // namespace microslip::app
