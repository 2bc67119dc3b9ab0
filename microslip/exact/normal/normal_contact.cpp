#include "microslip/exact/normal/normal_contact.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace microslip {
namespace {

std::vector<double> sampled(const GapFunction& gap, const ElementGrid& grid) {
  std::vector<double> h(grid.count());
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const double x = grid.x(i), y = grid.y(j), value = gap(x, y);
      if (!std::isfinite(value))
        throw Error("gap at x = " + std::to_string(x) + " m, y = " + std::to_string(y) + " m", value, "m", "finite");
      h[static_cast<std::size_t>(j) * grid.mx + i] = value;
    }
  return h;
}

/// Grid with `columns` and `rows` more elements on the sides that the contact reaches.
ElementGrid grown(const ElementGrid& grid, const BorderSides& reached, int columns, int rows) {
  ElementGrid larger = grid;
  if (reached.low_x) larger.mx += columns, larger.x0 -= columns * grid.dx;
  if (reached.high_x) larger.mx += columns;
  if (reached.low_y) larger.my += rows, larger.y0 -= rows * grid.dy;
  if (reached.high_y) larger.my += rows;
  return larger;
}

/// The next grid to try; the same one if there is no larger one.
ElementGrid next_grid(const ElementGrid& grid, const BorderSides& reached, std::size_t most_elements) {
  int columns = std::max(1, grid.mx / 4), rows = std::max(1, grid.my / 4);
  for (;;) {
    const ElementGrid larger = grown(grid, reached, columns, rows);
    if (larger.count() <= most_elements) return larger;
    if (columns == 1 && rows == 1) return grid;
    columns = (columns + 1) / 2;
    rows = (rows + 1) / 2;
  }
}

/// The sides by their coordinates, as in "x = -0.004 m, y = 0.003 m".
std::string names(const ElementGrid& grid, const BorderSides& sides) {
  std::string text;
  const auto add = [&](bool reached, const char* axis, double place) {
    if (reached) text += (text.empty() ? "" : ", ") + std::string(axis) + " = " + std::to_string(place) + " m";
  };
  add(sides.low_x, "x", grid.x(0) - grid.dx / 2);
  add(sides.high_x, "x", grid.x(grid.mx - 1) + grid.dx / 2);
  add(sides.low_y, "y", grid.y(0) - grid.dy / 2);
  add(sides.high_y, "y", grid.y(grid.my - 1) + grid.dy / 2);
  return text;
}

} // namespace

NormalContact solve_normal_contact(const CombinedMaterial& material, const GapFunction& gap, const ElementGrid& start,
                                   const NormalLoad& load, std::size_t most_elements, double tolerance) {
  check(start);
  if (start.line && most_elements > 0 && load.given == NormalLoad::Given::approach)
    throw Error("approach: a line contact whose grid may grow needs the force given");
  NormalContact contact{start, {}, {}};
  for (;;) {
    require_memory(ContactProblem::normal, contact.grid);
    contact.undeformed_gap = sampled(gap, contact.grid);
    contact.solution = NormalProblem(material, contact.grid).solve(contact.undeformed_gap, load, tolerance);
    if (!contact.solution.touches_border) return contact;
    const ElementGrid larger = next_grid(contact.grid, contact.solution.border, most_elements);
    if (larger.count() == contact.grid.count())
      throw Error("grid: the contact reaches its border at " + names(contact.grid, contact.solution.border) +
                  "; the potential contact of " + std::to_string(contact.grid.mx) + " x " +
                  std::to_string(contact.grid.my) + " elements is too small" +
                  (most_elements > 0 ? ", and it may have " + std::to_string(most_elements) + " at most" : ""));
    contact.grid = larger;
  }
}

} // namespace microslip
