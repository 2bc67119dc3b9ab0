#include "microslip/contact/totals.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

double at(const std::vector<double>& field, std::size_t k) {
  return field.empty() ? 0 : field[k];
}

} // namespace

Totals find_totals(const Elements& elements, const SurfaceFields& fields, const Creepage& creepage, double speed) {
  Totals t;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    if (fields.state[k] == CellState::exterior) continue;
    const double px = fields.traction.x[k], py = fields.traction.y[k], area = elements.area[k];
    t.fx += px * area;
    t.fy += py * area;
    t.mz += (elements.x[k] * py - elements.y[k] * px) * area;
    (fields.state[k] == CellState::slip ? t.slip_area : t.adhesion_area) += area;
    t.frictional_power -= (px * at(fields.slip.x, k) + py * at(fields.slip.y, k)) * area;
    t.elastic_energy += 0.5 * (px * at(fields.displacement.x, k) + py * at(fields.displacement.y, k)) * area;
    t.peak_traction = std::max(t.peak_traction, std::hypot(px, py));
  }
  for (std::size_t k = 0; k < fields.pressure.size(); ++k) {
    t.my -= elements.x[k] * fields.pressure[k] * elements.area[k];
    t.peak_pressure = std::max(t.peak_pressure, fields.pressure[k]);
  }
  t.frictional_power *= speed;
  t.power_by_creepage = -speed * (creepage.longitudinal * t.fx + creepage.lateral * t.fy + creepage.spin * t.mz);
  return t;
}

} // namespace microslip
