#include "microslip/exact/fitted/pressure_curvature.hpp"

#include <algorithm>

namespace microslip {
namespace {

constexpr double largest = 6; // times the pressure, so that means stay positive where pressures are rough

/// An element's neighbours along an axis.
struct Neighbours {
  std::size_t before, after;
  bool in_contact;
};

Neighbours along_x(const ElementGrid& grid, std::span<const double> pressure, std::size_t k) {
  const std::size_t i = k % grid.mx;
  const bool inside = i > 0 && i + 1 < static_cast<std::size_t>(grid.mx);
  return {k - 1, k + 1, inside && pressure[k - 1] > 0 && pressure[k + 1] > 0};
}

Neighbours along_y(const ElementGrid& grid, std::span<const double> pressure, std::size_t k) {
  const std::size_t mx = grid.mx;
  const bool inside = k >= mx && k + mx < pressure.size();
  return {k - mx, k + mx, inside && pressure[k - mx] > 0 && pressure[k + mx] > 0};
}

/// The second difference of p = sqrt(z): p'' = (z'' - z'^2/(2 z))/(2 p).
double second_difference(double before, double p, double after) {
  const double z_before = before * before, z = p * p, z_after = after * after;
  const double slope = (z_after - z_before) / 2;
  return (z_before - 2 * z + z_after - slope * slope / (2 * z)) / (2 * p);
}

} // namespace

std::vector<double> pressure_curvature(const ElementGrid& grid, std::span<const double> pressure) {
  std::vector<double> curvature(pressure.size());
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    if (!(pressure[k] > 0)) continue;
    double c = 0;
    for (const Neighbours& n : {along_x(grid, pressure, k), along_y(grid, pressure, k)})
      if (n.in_contact) c += second_difference(pressure[n.before], pressure[k], pressure[n.after]);
    curvature[k] = std::clamp(c, -largest * pressure[k], largest * pressure[k]);
  }
  return curvature;
}

bool on_rim(const ElementGrid& grid, std::span<const double> pressure, std::size_t element) {
  return !along_x(grid, pressure, element).in_contact || (grid.my > 1 && !along_y(grid, pressure, element).in_contact);
}

} // namespace microslip
