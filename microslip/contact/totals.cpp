#include "microslip/contact/totals.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace microslip {
namespace {

Vec2 at(const VectorField& field, std::size_t k) {
  return field.x.empty() ? Vec2{} : Vec2{field.x[k], field.y[k]};
}

} // namespace

bool is_finite(const Totals& t) {
  const double all[] = {t.fx,
                        t.fy,
                        t.mz,
                        t.my,
                        t.adhesion_area,
                        t.slip_area,
                        t.frictional_power,
                        t.power_by_creepage,
                        t.elastic_energy,
                        t.peak_pressure,
                        t.peak_traction};
  return std::all_of(std::begin(all), std::end(all), [](double value) { return std::isfinite(value); });
}

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

void add(Totals& t, const Elements& elements, const std::vector<double>& pressure) {
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    t.my -= elements.x[k] * pressure[k] * elements.area[k];
    t.peak_pressure = std::max(t.peak_pressure, pressure[k]);
  }
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
  add(t, elements, fields.pressure);
  t.frictional_power *= speed;
  t.power_by_creepage = power_by_creepage(t, creepage, speed);
  return t;
}

} // namespace microslip
