#include "microslip/elasticity/influence.hpp"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace microslip {
namespace {

/// ln(x + r) where r^2 = x^2 + y^2, without cancellation for x < 0; times y, which makes it 0 at y = 0.
double y_log_sum(double x, double y, double r) {
  if (y == 0) return 0;
  return y * (x >= 0 ? std::log(x + r) : 2 * std::log(std::abs(y)) - std::log(r - x));
}
double x_atan(double x, double y) {
  return x == 0 ? 0 : x * std::atan(y / x);
}
double y_log(double y, double r) {
  return y == 0 ? 0 : y * std::log(r);
}

/// The primitives at a corner.
struct Corner {
  double j1, j2, r, k1, k2;

  Corner(double x, double y) : r(std::hypot(x, y)) {
    j1 = y_log_sum(x, y, r);
    j2 = y_log_sum(y, x, r);
    k1 = y_log(y, r) + x_atan(x, y);
    k2 = y_log(x, r) + x_atan(y, x);
  }
};

} // namespace

Influence influence(const CombinedMaterial& material, double dx, double dy, double x, double y) {
  double j1 = 0, j2 = 0, r = 0, k1 = 0, k2 = 0;
  for (const int sx : {-1, 1})
    for (const int sy : {-1, 1}) {
      const Corner c(x + sx * dx / 2, y + sy * dy / 2);
      const double sign = sx * sy;
      j1 += sign * c.j1;
      j2 += sign * c.j2;
      r += sign * c.r;
      k1 += sign * c.k1;
      k2 += sign * c.k2;
    }
  const double nu = material.poisson_ratio, k = material.dissimilarity;
  const double f = 1 / (std::numbers::pi * material.shear_modulus);
  return {f * (j1 + (1 - nu) * j2), -f * nu * r, f * (j2 + (1 - nu) * j1),
          f * (1 - nu) * (j1 + j2), -f * k * k1, -f * k * k2};
}

Influence line_influence(const CombinedMaterial& material, double dx, double x, double far) {
  // Integral of ln|t/far| over the strip, without the constant that cancels between its ends.
  const auto primitive = [far](double t) { return t == 0 ? 0 : t * (std::log(std::abs(t) / far) - 1); };
  const double log = primitive(x + dx / 2) - primitive(x - dx / 2);
  const double side = std::abs(x + dx / 2) - std::abs(x - dx / 2); // of x/r^2 over the strip, over pi
  const double nu = material.poisson_ratio, k = material.dissimilarity;
  const double f = 1 / (std::numbers::pi * material.shear_modulus);
  return {-2 * f * (1 - nu) * log, 0, -2 * f * log, -2 * f * (1 - nu) * log, -k * side / material.shear_modulus, 0};
}

} // namespace microslip
