#include "microslip/exact/fitted/fitted_problem.hpp"

namespace microslip {

std::vector<double> area_shares(const FittedContact& contact) {
  std::vector<double> shares;
  for (const FittedElement& e : contact.elements) shares.push_back(e.width() / contact.grid.dx);
  return shares;
}

void find_rigid_slip(const FittedContact& contact, const Creepage& creepage, const RowVariation& variation,
                     std::vector<double>& cx, std::vector<double>& cy) {
  for (std::size_t k = 0; k < contact.elements.size(); ++k) {
    const FittedElement& e = contact.elements[k];
    const double x = (e.point + e.end) / 2, y = contact.grid.y(e.row);
    const Creepage more = variation.creepage_at(y);
    cx[k] = creepage.longitudinal - creepage.spin * y + more.longitudinal;
    cy[k] = creepage.lateral + more.lateral + (creepage.spin + more.spin) * x;
    if (!variation.displacement) continue;
    const Vec2 here = variation.displacement(e.point, y), there = variation.displacement(e.end, y);
    cx[k] += (here.x - there.x) / (e.end - e.point);
    cy[k] += (here.y - there.y) / (e.end - e.point);
  }
}

double work_on_rigid_slip(const FittedContact& contact, const Creepage& creepage, const RowVariation& variation,
                          std::span<const double> px, std::span<const double> py) {
  std::vector<double> cx(px.size()), cy(cx);
  find_rigid_slip(contact, creepage, variation, cx, cy);
  double work = 0;
  for (std::size_t k = 0; k < px.size(); ++k) {
    const FittedElement& e = contact.elements[k];
    const double from_middle = e.centre() - (e.point + e.end) / 2;
    cy[k] += (creepage.spin + variation.creepage_at(contact.grid.y(e.row)).spin) * from_middle;
    work -= (px[k] * cx[k] + py[k] * cy[k]) * e.width() * contact.grid.dy;
  }
  return work;
}

} // namespace microslip
