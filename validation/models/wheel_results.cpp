#include "validation/models/wheel_results.hpp"

#include "validation/models/exactly_rolled.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

namespace microslip::validation {
namespace {

using std::numbers::pi;

/// Length and width of a patch.
struct Extent {
  double length = 0, width = 0; ///< [m]
};

/// Half the lengths of a patch's rows, 0 where they bear no loads [m].
std::vector<double> half_lengths(const ContactSolution& solution) {
  const Elements& e = solution.elements;
  std::vector<double> out(std::size_t(e.my()), 0.0);
  for (int j = 0; j < e.my(); ++j)
    for (int i = 0; i < e.mx(); ++i)
      if (solution.fields.pressure[e.index(i, j)] > 0) out[std::size_t(j)] += e.width[e.index(i, j)] / 2;
  return out;
}

Extent extent_of(const ContactSolution& solution) {
  const std::vector<double> rows = half_lengths(solution);
  std::vector<double> joined;
  Extent out;
  for (std::size_t k = 0; k <= rows.size(); ++k) {
    if (k < rows.size() && rows[k] > 0) {
      joined.push_back(rows[k]), out.length = std::max(out.length, 2 * rows[k]);
      continue;
    }
    out.width += width_of_rows(joined, solution.elements.grid.dy);
    joined.clear();
  }
  return out;
}

} // namespace

PressedNumbers pressed_numbers(const WheelRailSolution& solution, double touching) {
  if (solution.status != Status::ok) return {};
  PressedNumbers out{.area = 0, .peak = 0, .lowering = touching - solution.vertical};
  for (const WheelRailPatch& p : solution.patches)
    out.area += p.contact_area, out.peak = std::max(out.peak, p.peak_pressure);
  if (!solution.fields.empty()) out.width = out.length = 0;
  for (const ContactSolution& patch : solution.fields) {
    const Extent extent = extent_of(patch);
    out.width += extent.width, out.length = std::max(out.length, extent.length);
  }
  return out;
}

PressedNumbers pressed_numbers(const PressedWheel& wheel) {
  if (!wheel.bears_load) return {};
  PressedNumbers out{0, 0, 0, 0, wheel.lowering};
  for (const PressedPatch& p : wheel.patches) {
    out.area += p.normal.area(), out.peak = std::max(out.peak, p.normal.peak());
    out.width += p.normal.width(), out.length = std::max(out.length, p.normal.length());
  }
  return out;
}

RollingNumbers rolling_numbers(const WheelRailSolution& solution) {
  if (solution.status != Status::ok) return {};
  RollingNumbers out{solution.force.x, solution.force.y, 0};
  for (const WheelRailPatch& p : solution.patches) out.power += p.frictional_power / p.rolling_speed;
  return out;
}

RollingNumbers rolling_numbers(const PressedWheel& wheel) {
  if (!wheel.bears_load) return {};
  RollingNumbers out{wheel.force().x, wheel.force().y, 0};
  for (const PressedPatch& p : wheel.patches) out.power += p.power;
  return out;
}

RollingNumbers rolling_exactly(PressedWheel wheel, const CombinedMaterial& material, double friction) {
  constexpr int elements = 24;
  if (!wheel.bears_load) return {};
  for (PressedPatch& p : wheel.patches) {
    const auto force = exactly_rolled(p.normal, material, p.creepage, friction, elements);
    if (!force) return {};
    p.fx = force->x, p.fs = force->y;
  }
  return {wheel.force().x, wheel.force().y};
}

RollingNumbers rolling_by_law(const WheelRailSolution& solution, const CombinedMaterial& material,
                              const TangentialModel& law) {
  if (solution.status != Status::ok) return {};
  RollingNumbers out{solution.force.x, solution.force.y, 0};
  for (std::size_t k = 0; k < solution.patches.size(); ++k) {
    const WheelRailPatch& p = solution.patches[k];
    const Extent extent = extent_of(solution.fields[k]);
    const double ratio = extent.length / extent.width;
    const ContactForces f = law.forces({.a = std::sqrt(p.contact_area * ratio / pi),
                                        .b = std::sqrt(p.contact_area / ratio / pi),
                                        .shear_modulus = material.shear_modulus,
                                        .poisson_ratio = material.poisson_ratio,
                                        .normal_force = p.normal_force,
                                        .friction = FrictionLaw::coulomb(p.friction),
                                        .creepage = p.creepage});
    out.fx += f.fx - p.fx, out.fy += std::cos(p.angle) * (f.fy - p.fs);
    const auto [xi, eta, phi] = p.creepage;
    out.power -= xi * f.fx + eta * f.fy + phi * f.mz;
  }
  return out;
}

double creepage_power(const WheelRailSolution& solution) {
  double sum = 0;
  for (const WheelRailPatch& p : solution.patches) {
    const auto [xi, eta, phi] = p.creepage;
    const double c = std::sqrt(p.contact_area / pi);
    sum += p.friction * p.normal_force * (std::abs(xi) + std::abs(eta) + c * std::abs(phi));
  }
  return sum;
}

} // namespace microslip::validation
