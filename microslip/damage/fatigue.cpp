#include "microslip/damage/fatigue.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

/// p0/k from the largest orthogonal shear stress over p0 inside; at the surface it is mu.
double limit(double inside, double traction_coefficient) {
  return 1 / std::max(inside, traction_coefficient);
}

} // namespace

double surface_fatigue_index(double traction_coefficient, double peak_pressure, double shear_yield_strength) {
  return traction_coefficient - shear_yield_strength / peak_pressure;
}

double line_shakedown_limit(double mu) {
  constexpr double slope = 0.29903811; // 3 sqrt(3)/4 - 1: at x = sqrt(3)/2 a, z = a/2, where it is largest for mu = 0
  return limit(0.25 + mu * (slope + mu * (0.06822 - mu * 0.03563)), mu);
}

double point_shakedown_limit(double mu) {
  return limit(0.21385 + mu * (0.27848 + mu * (0.04986 - mu * 0.00879)), mu);
}

std::vector<double> shear_excess(const ContactSolution& solution, double shear_yield_strength) {
  require_positive("shear_yield_strength", shear_yield_strength, "Pa");
  const VectorField& p = solution.fields.traction;
  std::vector<double> excess(solution.elements.size());
  for (std::size_t k = 0; k < excess.size(); ++k) excess[k] = std::hypot(p.x[k], p.y[k]) - shear_yield_strength;
  return excess;
}

} // namespace microslip
