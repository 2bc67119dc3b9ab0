#include "microslip/contact/element_grid.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"

namespace microslip {

ElementGrid ElementGrid::across_ellipse(double a, double b, int n, int m, int margin) {
  require_positive("a", a, "m");
  require_positive("b", b, "m");
  require_count("elements across", n, 1, most_cells);
  require_count("elements across", m, 1, most_cells);
  ElementGrid grid;
  grid.mx = n + 2 * margin;
  grid.my = m + 2 * margin;
  grid.dx = 2 * a / n;
  grid.dy = 2 * b / m;
  grid.x0 = -a + grid.dx * (0.5 - margin);
  grid.y0 = -b + grid.dy * (0.5 - margin);
  return grid;
}

ElementGrid ElementGrid::across_line(double a, int n, int margin, double length) {
  require_positive("a", a, "m");
  require_count("elements across", n, 1, most_cells);
  require_positive("length", length, "m");
  ElementGrid grid;
  grid.mx = n + 2 * margin;
  grid.my = 1;
  grid.dx = 2 * a / n;
  grid.dy = length;
  grid.x0 = -a + grid.dx * (0.5 - margin);
  grid.line = true;
  return grid;
}

void check(const ElementGrid& grid) {
  require_count("grid.mx", grid.mx, 1, 100000000);
  require_count("grid.my", grid.my, 1, 100000000);
  require_positive("grid.dx", grid.dx, "m");
  require_positive("grid.dy", grid.dy, "m");
  require_finite("grid.x0", grid.x0, "m");
  require_finite("grid.y0", grid.y0, "m");
  if (grid.line) require_count("grid.my of a line contact", grid.my, 1, 1);
}

} // namespace microslip
