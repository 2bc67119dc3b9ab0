#include "explorer/core/solution_fields.hpp"

#include <string>

namespace microslip::explorer {
namespace {

io::Json numbers(const std::vector<double>& values) {
  auto array = io::Json::array();
  for (const double value : values) array.push_back(io::json_number(value));
  return array;
}

} // namespace

void add_fields(const ContactSolution& solution, std::span<const std::string_view> names, io::Json& to,
                io::Json& units) {
  for (const auto name : names) {
    const FieldQuantity& field = field_quantity(name);
    to[std::string(name)] = numbers(field.values(solution));
    units[std::string(name)] = field.unit_of(solution);
  }
}

io::Json states_of(const ContactSolution& solution) {
  auto states = io::Json::array();
  for (const CellState state : solution.fields.state) states.push_back(static_cast<int>(state));
  return states;
}

} // namespace microslip::explorer
