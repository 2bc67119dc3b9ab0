#include "validation/hertzian_stress.hpp"

#include <cmath>

namespace microslip::validation {

Stress stress_below_sphere(double poisson_ratio, double x, double z) {
  const double nu = poisson_ratio, r2 = x * x;
  const double d = r2 + z * z - 1, root = std::hypot(d, 2 * z);
  const double u = d > 0 ? (d + root) / 2 : 2 * z * z / (root - d); // (u + 1) (u - z^2) = u r^2
  const double s = std::sqrt(u), k = z / s, k3 = k * k * k, e = u / (u * u + z * z);
  const double arc = s * std::atan(1 / s);
  // (1 - k^3)/r^2 with 1 - k^2 = r^2/(1 + u)
  const double ring = (1 - 2 * nu) / 3 * (1 + k + k * k) / ((1 + k) * (1 + u));
  Stress stress;
  stress.xx = ring + k3 * e + k * ((1 - nu) * u / (1 + u) + (1 + nu) * arc - 2);
  stress.yy = -ring - k * (2 * nu + (1 - nu) * u / (1 + u) - (1 + nu) * arc);
  stress.zz = -k3 * e;
  stress.xz = -x * z * z / (u * u + z * z) * s / (1 + u);
  return stress;
}

namespace {

/// m, n and (z^2 + n^2)/(m^2 + n^2) of (4.49); 1 - x^2 + z^2 = m^2 - n^2, x z = m n.
struct ConfocalPoint {
  double m, n, k;

  ConfocalPoint(double x, double z) {
    const double d = 1 - x * x + z * z, root = std::hypot(d, 2 * x * z);
    const double large = (root + std::abs(d)) / 2, small = root > 0 ? x * x * z * z / large : 0;
    m = std::sqrt(d > 0 ? large : small);
    n = std::copysign(std::sqrt(d > 0 ? small : large), x);
    k = (z * z + n * n) / (m * m + n * n);
  }
};

} // namespace

Stress stress_below_cylinder(double poisson_ratio, double x, double z) {
  const auto [m, n, k] = ConfocalPoint(x, z);
  Stress stress;
  stress.xx = -(m * (1 + k) - 2 * z);
  stress.zz = -m * (1 - k);
  stress.xz = -n * (m * m - z * z) / (m * m + n * n);
  stress.yy = poisson_ratio * (stress.xx + stress.zz);
  return stress;
}

Stress stress_below_pulled_cylinder(double poisson_ratio, double x, double z) {
  const auto [m, n, k] = ConfocalPoint(x, z);
  const Stress pressed = stress_below_cylinder(poisson_ratio, x, z);
  Stress stress;
  stress.xx = n * (3 - k) - 2 * x; // 2 - (z^2 - m^2)/(m^2 + n^2) = 3 - k
  stress.zz = pressed.xz;
  stress.xz = pressed.xx;
  stress.yy = poisson_ratio * (stress.xx + stress.zz);
  return stress;
}

} // namespace microslip::validation
