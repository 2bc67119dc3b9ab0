#include "microslip/contact/elements.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace microslip {

Elements::Elements(const ElementGrid& regular)
    : grid(regular), x(regular.count()), y(x), width(x.size(), regular.dx), area(x.size(), regular.element_area()) {
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      x[index(i, j)] = grid.x(i);
      y[index(i, j)] = grid.y(j);
    }
}

namespace {

/// The row whose strip a point lies in; -1: none.
int row_at(const Elements& elements, double y) {
  const ElementGrid& grid = elements.grid;
  if (grid.line) return 0;
  const double row = std::round((y - grid.y0) / grid.dy);
  return row >= 0 && row < grid.my ? static_cast<int>(row) : -1;
}

/// The value of the element of row j that x lies in. Elements of a row ascend but may leave gaps and, where an edge is
/// fitted, end beside the next centre.
double value_in_row(const Elements& elements, const std::vector<double>& field, int j, double x) {
  const auto first = elements.x.begin() + static_cast<std::ptrdiff_t>(elements.index(0, j));
  const int next = static_cast<int>(std::lower_bound(first, first + elements.mx(), x) - first);
  for (const int i : {next, next - 1}) {
    if (i < 0 || i >= elements.mx()) continue;
    const std::size_t k = elements.index(i, j);
    if (std::abs(x - elements.x[k]) <= elements.width[k] / 2) return field[k];
  }
  return 0;
}

} // namespace

std::vector<double> sampled(const Elements& elements, const std::vector<double>& field, const ElementGrid& grid) {
  if (field.size() != elements.size())
    throw Error("field: must have a value for each of the " + std::to_string(elements.size()) + " elements");
  check(grid);
  std::vector<double> values(grid.count());
  for (int j = 0; j < grid.my; ++j) {
    const int row = row_at(elements, grid.y(j));
    if (row < 0) continue;
    for (int i = 0; i < grid.mx; ++i)
      values[static_cast<std::size_t>(j) * grid.mx + i] = value_in_row(elements, field, row, grid.x(i));
  }
  return values;
}

} // namespace microslip
