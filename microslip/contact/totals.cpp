#include "microslip/contact/totals.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

Vec2 at(const VectorField& field, std::size_t k) {
  return field.x.empty() ? Vec2{} : Vec2{field.x[k], field.y[k]};
}

} // namespace

void add(Totals& t, const LoadedElement& e) {
  const auto [px, py] = e.traction;
  t.fx += px * e.area;
  t.fy += py * e.area;
  t.mz += (e.x * py - e.y * px) * e.area;
  (e.slides ? t.slip_area : t.adhesion_area) += e.area;
  t.frictional_power -= (px * e.slip.x + py * e.slip.y) * e.area;
  t.elastic_energy += 0.5 * (px * e.displacement.x + py * e.displacement.y) * e.area;
  t.peak_traction = std::max(t.peak_traction, std::hypot(px, py));
}

double power_by_creepage(const Totals& t, const Creepage& creepage, double speed) {
  return -speed * (creepage.longitudinal * t.fx + creepage.lateral * t.fy + creepage.spin * t.mz);
}

Totals find_totals(const Elements& elements, const SurfaceFields& fields, const Creepage& creepage, double speed) {
  Totals t;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    if (fields.state[k] == CellState::exterior) continue;
    add(t, {.x = elements.x[k],
            .y = elements.y[k],
            .area = elements.area[k],
            .slides = fields.state[k] == CellState::slip,
            .traction = at(fields.traction, k),
            .slip = at(fields.slip, k),
            .displacement = at(fields.displacement, k)});
  }
  for (std::size_t k = 0; k < fields.pressure.size(); ++k) {
    t.my -= elements.x[k] * fields.pressure[k] * elements.area[k];
    t.peak_pressure = std::max(t.peak_pressure, fields.pressure[k]);
  }
  t.frictional_power *= speed;
  t.power_by_creepage = power_by_creepage(t, creepage, speed);
  return t;
}

} // namespace microslip
