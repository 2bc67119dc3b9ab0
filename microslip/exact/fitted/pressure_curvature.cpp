#include "microslip/exact/fitted/pressure_curvature.hpp"

#include "microslip/numerics/fade.hpp"

#include <algorithm>
#include <cstddef>

namespace microslip {
namespace {

constexpr double largest = 6;        // times the pressure, so that means stay positive where pressures are rough
constexpr double near_the_rim = 0.1; // p^2 of a neighbour, over the element's own

/// The second difference of p = sqrt(z), p'' = (z'' - z'^2/(2 z))/(2 p), faded out towards the rim.
double second_difference(double before, double p, double after) {
  const double z_before = before * before, z = p * p, z_after = after * after;
  const double share = 1 - fade(std::min(z_before, z_after), 0, near_the_rim * z);
  const double slope = (z_after - z_before) / 2;
  return share * (z_before - 2 * z + z_after - slope * slope / (2 * z)) / (2 * p);
}

} // namespace

std::vector<double> pressure_curvature(const ElementGrid& grid, std::span<const double> pressure) {
  const std::size_t mx = grid.mx;
  std::vector<double> curvature(pressure.size());
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    if (!(pressure[k] > 0)) continue;
    double c = 0;
    if (k % mx > 0 && k % mx + 1 < mx) c += second_difference(pressure[k - 1], pressure[k], pressure[k + 1]);
    if (k >= mx && k + mx < pressure.size()) c += second_difference(pressure[k - mx], pressure[k], pressure[k + mx]);
    curvature[k] = std::clamp(c, -largest * pressure[k], largest * pressure[k]);
  }
  return curvature;
}

} // namespace microslip
