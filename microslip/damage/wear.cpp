#include "microslip/damage/wear.hpp"

#include "microslip/error.hpp"

#include <cmath>

namespace microslip {

double t_gamma(double fx, double fy, const Creepage& creepage) {
  return std::abs(fx * creepage.longitudinal) + std::abs(fy * creepage.lateral);
}
double t_gamma_with_spin(double fx, double fy, double mz, const Creepage& creepage) {
  return t_gamma(fx, fy, creepage) + std::abs(mz * creepage.spin);
}
double t_gamma(const ContactSolution& solution) {
  return t_gamma(solution.totals.fx, solution.totals.fy, solution.creepage);
}
double t_gamma_with_spin(const ContactSolution& solution) {
  const Totals& t = solution.totals;
  return t_gamma_with_spin(t.fx, t.fy, t.mz, solution.creepage);
}

std::vector<double> friction_work(const ContactSolution& solution) {
  const SurfaceFields& f = solution.fields;
  std::vector<double> work(solution.elements.size());
  for (std::size_t k = 0; k < work.size(); ++k)
    if (f.state[k] != CellState::exterior) work[k] = -(f.traction.x[k] * f.slip.x[k] + f.traction.y[k] * f.slip.y[k]);
  return work;
}

double WearMap::coefficient(double sliding_speed, double pressure, double hardness) const {
  if (pressure > seizure_above * hardness) return seizure;
  if (sliding_speed < medium_from) return slow;
  return sliding_speed <= medium_to ? medium : fast;
}

std::vector<double> wear_depth(const ContactSolution& solution, const ArchardWear& wear, double rolling_speed) {
  require_positive("hardness", wear.hardness, "Pa");
  require_between("rolling_speed", rolling_speed, "m/s", 0, 1e6);
  const Elements& e = solution.elements;
  const SurfaceFields& f = solution.fields;
  if (f.pressure.size() != e.size()) throw Error("solution: has no pressures; Archard's law needs them");
  std::vector<double> depth(e.size());
  for (std::size_t k = 0; k < e.size(); ++k) {
    if (f.state[k] != CellState::slip) continue;
    const double slip = std::hypot(f.slip.x[k], f.slip.y[k]);
    const double coefficient = wear.map.coefficient(slip * rolling_speed, f.pressure[k], wear.hardness);
    depth[k] = coefficient * f.pressure[k] * slip * e.area[k] / e.grid.dy / wear.hardness;
  }
  return depth;
}

std::vector<double> row_sums(const Elements& elements, const std::vector<double>& field) {
  std::vector<double> sums(static_cast<std::size_t>(elements.my()));
  for (std::size_t k = 0; k < field.size(); ++k) sums[k / elements.mx()] += field[k];
  return sums;
}

double wear_rate_r8t(double t_gamma_per_area) {
  constexpr double newtons = 1e6, micrograms = 1e-3; // N/mm^2 in N/m^2, ug/(m mm^2) in kg/(m m^2)
  constexpr double mild = 5.3, severe = 55, catastrophic = 61.9, catastrophic_from = 77.2;
  const double x = t_gamma_per_area / newtons;
  if (x < severe / mild) return mild * x * micrograms;
  return (x < catastrophic_from ? severe : severe + catastrophic * (x - catastrophic_from)) * micrograms;
}

double worn_area_british_rail(double t_gamma, double diameter) {
  require_positive("diameter", diameter, "m");
  constexpr double millimetres = 1e3, square_millimetres_per_kilometre = 1e-9;
  const double rate = t_gamma < 100 ? 0.25 * t_gamma : t_gamma < 200 ? 25 : 1.19 * t_gamma - 154;
  return rate / (diameter * millimetres) * square_millimetres_per_kilometre;
}

} // namespace microslip
