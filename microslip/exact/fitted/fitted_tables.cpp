#include "microslip/exact/fitted/fitted_tables.hpp"

#include "microslip/exact/fitted/fitted_corrections.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace microslip {
namespace {

using Product = FittedProduct<double>;

/// Lagrange's weights at t for the nodes 0, 1, ..., count - 1.
template <class Weights> void interpolate(double t, int count, Weights& weights) {
  for (int m = 0; m < count; ++m) {
    weights[m] = 1;
    for (int other = 0; other < count; ++other)
      if (other != m) weights[m] *= (t - other) / (m - other);
  }
}

/// The column in the middle of those by which a leading element is represented.
int moments_column(int mx, double centre) {
  return std::clamp(static_cast<int>(std::lround(centre)), 1, mx - 2);
}

/// The three neighbours of the grid that have the force, its moment and its second moment along x.
void find_moments(int mx, LeadingElement& e) {
  const int column = moments_column(mx, (e.left + e.right) / 2);
  const double from = e.left - column, to = e.right - column;
  const double force = to - from, first = (to * to - from * from) / 2;
  const double outer = (to * to * to - from * from * from) / 3 - force / 12;
  e.first_moment = column - 1;
  e.moments = {(outer - first) / 2, force - outer, (outer + first) / 2};
}

int first_node(int mx, int nodes, double x) {
  return std::clamp(static_cast<int>(std::floor(x)) - nodes / 2 + 1, 0, mx - nodes);
}

LeadingElement::Point place_point(int mx, int nodes, std::size_t point, double x) {
  LeadingElement::Point out{point, x, first_node(mx, nodes, x), {}};
  interpolate(x - out.first_node, nodes, out.nodes);
  return out;
}

/// Points are numbered as Tables has them.
std::vector<LeadingElement> find_leading(const FittedContact& contact, int nodes) {
  const ElementGrid& grid = contact.grid;
  const auto column_of = [&](double x) { return (x - grid.x0) / grid.dx; };
  std::vector<LeadingElement> leading;
  std::size_t point = 0;
  for (std::size_t k = 0; k < contact.elements.size(); ++k, ++point) {
    const FittedElement& e = contact.elements[k];
    if (!e.fitted) continue;
    LeadingElement out{k, e.row, column_of(e.left), column_of(e.right), 0, {}, {}};
    find_moments(grid.mx, out);
    out.points = {place_point(grid.mx, nodes, k, column_of(e.point)),
                  place_point(grid.mx, nodes, contact.elements.size() + leading.size(), column_of(e.end))};
    leading.push_back(out);
  }
  return leading;
}

} // namespace

FittedContact without_spare_elements(const FittedContact& contact) {
  const ElementGrid& grid = contact.grid;
  if (grid.line || contact.elements.empty()) return contact;
  const int nodes = std::min(Product::most_nodes, grid.mx), first_row = contact.elements.front().row;
  int first = grid.mx, last = 0;
  const auto use = [&](int from, int to) { first = std::min(first, from), last = std::max(last, to); };
  for (const FittedElement& e : contact.elements) {
    const int column = static_cast<int>(e.cell % grid.mx);
    use(column, column);
    if (!e.fitted) continue;
    use(moments_column(grid.mx, (e.centre() - grid.x0) / grid.dx) - 1,
        moments_column(grid.mx, (e.centre() - grid.x0) / grid.dx) + 1);
    for (const double x : {e.point, e.end}) {
      const int node = first_node(grid.mx, nodes, (x - grid.x0) / grid.dx);
      use(node, node + nodes - 1);
    }
  }
  FittedContact out = contact;
  out.grid.mx = last - first + 1;
  out.grid.my = contact.elements.back().row - first_row + 1;
  out.grid.x0 = grid.x(first);
  out.grid.y0 = grid.y(first_row);
  for (FittedElement& e : out.elements) {
    e.row -= first_row;
    e.cell = static_cast<std::uint32_t>(e.row * out.grid.mx + static_cast<int>(e.cell % grid.mx) - first);
  }
  return out;
}

FittedProduct<double>::Tables fitted_tables(double poisson_ratio, const FittedContact& contact,
                                            const GridKernel& kernel, const Progress& progress,
                                            FittedProduct<double>::Tables memory) {
  const auto& [grid, elements, load_share] = contact;
  const int mx = grid.mx;
  const auto cell = [mx](int row, int column) { return static_cast<std::size_t>(row) * mx + column; };
  Product::Tables tables = std::move(memory);
  tables.clear();
  tables.nodes = std::min(Product::most_nodes, grid.mx);
  std::vector<LeadingElement> leading = find_leading(contact, tables.nodes);
  tables.points = elements.size() + leading.size();
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const FittedElement& e = elements[k];
    tables.end_point.push_back(k + 1); // the next centre; else below
    tables.slip_distance.push_back((e.end - e.point) / grid.dx);
    if (!e.fitted)
      tables.grid_elements.push_back(
          {static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(cell(e.row, static_cast<int>(e.cell % grid.mx)))});
  }
  for (const LeadingElement& e : leading) {
    tables.end_point[e.element] = e.points[1].point;
    tables.moments.push_back({e.element, cell(e.row, e.first_moment), e.moments});
    for (const LeadingElement::Point& p : e.points)
      tables.stencils.push_back({p.point, cell(e.row, p.first_node), p.nodes});
  }
  find_corrections(poisson_ratio, contact, kernel, std::move(leading), tables, progress);
  return tables;
}

} // namespace microslip
