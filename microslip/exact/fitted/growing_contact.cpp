#include "microslip/exact/fitted/growing_contact.hpp"

#include <complex>
#include <cstddef>
#include <vector>

namespace microslip {
namespace {

/// Index of the element of each of the grid's cells, or -1.
std::vector<long> elements_of_cells(const FittedContact& contact) {
  std::vector<long> out(contact.grid.count(), -1);
  for (std::size_t k = 0; k < contact.elements.size(); ++k) out[contact.elements[k].cell] = static_cast<long>(k);
  return out;
}

/// u - x du/dx - y du/dy in the middle of the elements' paths, of a component u of the displacement at their points and
/// its decrease s along the paths, per length. Across the rows by differences to those that have an element of the same
/// column.
std::vector<double> stretched_displacement(const FittedContact& contact, const std::vector<double>& u,
                                           const std::vector<double>& s) {
  const std::vector<long> element_of = elements_of_cells(contact);
  const auto middle = [&](std::size_t k) { return (contact.elements[k].point + contact.elements[k].end) / 2; };
  const auto value_at = [&](std::size_t k, double x) { return u[k] - (x - contact.elements[k].point) * s[k]; };
  std::vector<double> out(u.size());
  for (std::size_t k = 0; k < u.size(); ++k) {
    const FittedElement& e = contact.elements[k];
    const double x = middle(k), own = value_at(k, x);
    double growth = 0, ways = 0; // over the rows to the neighbours that there are
    for (const int step : {-1, 1}) {
      if (e.row + step < 0 || e.row + step >= contact.grid.my) continue;
      const long other = element_of[e.cell + static_cast<std::ptrdiff_t>(step) * contact.grid.mx];
      if (other < 0) continue;
      growth += step * (value_at(other, x) - own);
      ways += contact.grid.dy;
    }
    out[k] = own + x * s[k] - (ways > 0 ? contact.grid.y(e.row) * growth / ways : 0);
  }
  return out;
}

} // namespace

void find_slip_of_growth(const FittedContact& contact, const VectorField& displacement, const VectorField& slip,
                         double spin, double wavenumber, ComplexField& cx, ComplexField& cy) {
  const std::vector<double> ux = stretched_displacement(contact, displacement.x, slip.x);
  const std::vector<double> uy = stretched_displacement(contact, displacement.y, slip.y);
  const std::complex<double> rate(0, wavenumber);
  for (std::size_t k = 0; k < ux.size(); ++k) {
    const FittedElement& e = contact.elements[k];
    const double y = contact.grid.y(e.row);
    cx[k] = mean_over_path(e, wavenumber, [&](double) { return -spin * y + rate * ux[k]; });
    cy[k] = mean_over_path(e, wavenumber, [&](double x) { return spin * x + rate * uy[k]; });
  }
}

} // namespace microslip
