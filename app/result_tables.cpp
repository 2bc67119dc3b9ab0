#include "app/result_tables.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace microslip::app {
namespace {

std::size_t width(const StateTable::Column& column) {
  std::size_t most = std::max(column.head.size(), column.unit.size());
  for (const std::string& cell : column.cells) most = std::max(most, cell.size());
  return most;
}

} // namespace

void StateTable::print() const {
  fmt::print("{}\n", title_);
  const auto print_line = [&](const auto& text_of) {
    std::string line;
    for (const Column& column : columns_) line += fmt::format("  {:>{}}", text_of(column), width(column));
    fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  };
  print_line([](const Column& column) { return column.head; });
  print_line([](const Column& column) { return column.unit; });
  for (std::size_t k = 0; k < columns_.front().cells.size(); ++k)
    print_line([k](const Column& column) { return column.cells[k]; });
}

io::Json StateTable::json() const {
  io::Json columns = io::Json::array();
  for (const auto& [head, unit, cells] : columns_)
    columns.push_back({{"head", head}, {"unit", unit}, {"cells", cells}});
  return {{"title", title_}, {"columns", columns}};
}

void print_tables(const std::string& title, const std::vector<ResultTable>& tables) {
  if (!title.empty()) fmt::print("{}\n\n", title);
  for (const ResultTable& table : tables) {
    std::visit([](const auto& one) { one.print(); }, table);
    fmt::print("\n");
  }
}

} // namespace microslip::app
