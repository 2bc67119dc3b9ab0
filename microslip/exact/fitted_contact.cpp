#include "microslip/exact/fitted_contact.hpp"

#include "microslip/exact/edge_element.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace microslip {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int margin = 3; // interpolation and moments of the fitted elements reach that far ahead

/// The distance from the leading element's rear side to the edge is between this and 1 more [elements]: widths of .6 to
/// 1.57.
constexpr double nearest_edge = 0.92;

/// Appends the elements of a row in contact from `trailing` to `leading`.
void fit_row(const ElementGrid& grid, int row, double trailing, double leading, std::vector<FittedElement>& elements) {
  const double h = grid.dx, origin = grid.x0 - h / 2;
  const auto cell = [&](int column) {
    return static_cast<std::size_t>(row) * grid.mx + std::clamp(column, 0, grid.mx - 1);
  };
  const int last = static_cast<int>(std::floor((leading - origin) / h - nearest_edge));
  const double left = origin + last * h, width = h * leading_element_width((leading - left) / h);
  if (left + width / 2 <= trailing) { // shorter than an element
    const int column = static_cast<int>(std::floor(((leading + trailing) / 2 - origin) / h));
    elements.push_back({row, cell(column), trailing, leading, leading + h / 2, true, true, true});
    return;
  }
  int first = last;
  while (origin + first * h > trailing + 1e-12 * h) --first;
  for (int column = first; column <= last; ++column) {
    const double from = origin + column * h;
    const bool leads = column == last, next_leads = column + 1 == last;
    const double to = from + (leads ? width : h);
    const double end = leads ? to + h / 2 : next_leads ? to + width / 2 : to + h / 2;
    elements.push_back({row, cell(column), from, to, end, leads, leads, column == first});
  }
}

/// The integral of sqrt(1 - t^2) from -1 to t.
double half_disk(double t) {
  const double clamped = std::clamp(t, -1.0, 1.0);
  return (clamped * std::sqrt(1 - clamped * clamped) + std::asin(clamped)) / 2 + M_PI / 4;
}

/// Gauss and Legendre's rule of eight points on (-1, 1): nodes and weights of the positive half.
constexpr std::array<std::array<double, 2>, 4> gauss = {{{0.1834346424956498, 0.3626837833783620},
                                                         {0.5255324099163290, 0.3137066458778873},
                                                         {0.7966664774136267, 0.2223810344533745},
                                                         {0.9602898564975363, 0.1012285362903763}}};

/// Integrates f(y/b) over a row of the ellipse from y0 b to y1 b; in the angle, as f has square roots at y = +-b.
template <class Function> double integrate_row(double y0, double y1, const Function& f) {
  const double low = std::asin(std::clamp(y0, -1.0, 1.0)), high = std::asin(std::clamp(y1, -1.0, 1.0));
  const double middle = (low + high) / 2, half = (high - low) / 2;
  double sum = 0;
  for (const auto& [node, weight] : gauss)
    for (const double side : {-node, node}) {
      const double angle = middle + side * half;
      sum += weight * std::cos(angle) * f(std::sin(angle));
    }
  return sum * half;
}

} // namespace

FittedContact fit_ellipse(double a, double b, int n, int m) {
  FittedContact contact;
  ElementGrid& grid = contact.grid = ElementGrid::across_ellipse(a, b, n, m, 0);
  grid.mx += 2 * margin;
  grid.x0 -= margin * grid.dx;
  for (int row = 0; row < m; ++row) {
    const double y = (2 * row + 1.0) / m - 1, edge = a * std::sqrt((1 - y) * (1 + y));
    const std::size_t first = contact.elements.size();
    fit_row(grid, row, -edge, edge, contact.elements);

    const double y0 = 2.0 * row / m - 1, y1 = 2.0 * (row + 1) / m - 1;
    double row_sum = 0;
    for (std::size_t k = first; k < contact.elements.size(); ++k) {
      const FittedElement& e = contact.elements[k];
      const double from = e.trails ? -infinity : e.left / a, to = e.leads ? infinity : e.right / a;
      const double share = integrate_row(y0, y1, [&](double t) {
        const double half = std::sqrt((1 - t) * (1 + t)); // of the row's length over a
        return half * half * (half_disk(to / half) - half_disk(from / half));
      });
      contact.load_share.push_back(share);
      row_sum += share;
    }
    // The row's share in closed form: the integral of (3/4) (1 - y^2).
    const double exact = 0.75 * (y1 - y0 - (y1 * y1 * y1 - y0 * y0 * y0) / 3);
    for (std::size_t k = first; k < contact.elements.size(); ++k)
      contact.load_share[k] *= exact / (row_sum * contact.elements[k].width() * grid.dy);
  }
  return contact;
}

} // namespace microslip
