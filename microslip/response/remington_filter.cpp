#include "microslip/response/remington_filter.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/bessel.hpp"
#include "microslip/numerics/gauss_legendre.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

/// 2 J_1(q)/q squared.
double disk_mean_squared(double q) {
  const double mean = q < 1e-4 ? 1 - q * q / 8 : 2 * bessel_functions(q).j1 / q;
  return mean * mean;
}

} // namespace

double remington_filter(double radius, double alpha, double wavenumber) {
  require_positive("radius", radius, "m");
  require_between("alpha", alpha, "-", 0, 1e3);
  require_between("wavenumber", wavenumber, "1/m", 0, 1e9);
  const double q = wavenumber * radius;
  if (alpha == 0) return std::sqrt(disk_mean_squared(q));
  // With tan x = t: the mean over t, the wavenumber across the track over k, of the mean square over a disk.
  static const GaussLegendre rule(16);
  const int panels = 1 + static_cast<int>(std::min(q * alpha / 4, 1e4));
  double sum = 0;
  for (int panel = 0; panel < panels; ++panel) {
    const double from = alpha * panel / panels, to = alpha * (panel + 1) / panels;
    for (std::size_t k = 0; k < rule.count(); ++k)
      sum += rule.weight(k, from, to) * disk_mean_squared(q * std::hypot(1, rule.node(k, from, to)));
  }
  return std::sqrt(sum / alpha);
}

} // namespace microslip
