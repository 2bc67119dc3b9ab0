#pragma once

#include "app/quantity_table.hpp"
#include "cases/rolling_contact_result.hpp"
#include "cases/wheel_rail_result.hpp"

#include <string>
#include <variant>
#include <vector>

namespace microslip::app {

/// A table of a sweep for people to read: a column for each quantity, a row for each state.
class StateTable {
public:
  struct Column {
    std::string head, unit;
    std::vector<std::string> cells;
  };

  StateTable(std::string title, std::vector<Column> columns) : title_(std::move(title)), columns_(std::move(columns)) {}

  /// Writes it to standard output.
  void print() const;
  /// The same texts as `title` and `columns` with `head`, `unit` and `cells`.
  io::Json json() const;

private:
  std::string title_;
  std::vector<Column> columns_;
};

using ResultTable = std::variant<QuantityTable, StateTable>;

/// Results of two bodies in contact: Hertz's ellipse, forces by each theory, a nip, stresses inside.
std::vector<ResultTable> result_tables(const io::RollingCase& input, const cases::RollingContactResult& result);
/// The wheel's forces and a column for each patch or, of a sweep, a row for each state.
std::vector<ResultTable> result_tables(const io::WheelRailCase& input, const cases::WheelRailResult& result);
/// Results of a wheelset: its totals, a column for each wheel and each patch.
std::vector<ResultTable> result_tables(const io::WheelsetCase& input, const cases::WheelsetResult& result);

/// Prints a case's title, if it has one, and its tables, with empty lines between them and at the end.
void print_tables(const std::string& title, const std::vector<ResultTable>& tables);

} // namespace microslip::app
