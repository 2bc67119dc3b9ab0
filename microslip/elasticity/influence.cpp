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

/// Adds the primitives at a corner, those of x/r^2 and y/r^2 only for dissimilar bodies.
void add_corner(double sign, double x, double y, bool dissimilar, KernelIntegrals& sum) {
  const double r = std::hypot(x, y);
  sum.xx += sign * y_log_sum(x, y, r);
  sum.yy += sign * y_log_sum(y, x, r);
  sum.xy -= sign * r;
  if (!dissimilar) return;
  sum.x += sign * (y_log(y, r) + x_atan(x, y));
  sum.y += sign * (y_log(x, r) + x_atan(y, x));
}

} // namespace

Influence influence_of(const CombinedMaterial& material, const KernelIntegrals& i) {
  const double nu = material.poisson_ratio, k = material.dissimilarity;
  const double f = 1 / (std::numbers::pi * material.shear_modulus);
  return {f * (i.xx + (1 - nu) * i.yy), f * nu * i.xy, f * (i.yy + (1 - nu) * i.xx),
          f * (1 - nu) * (i.xx + i.yy), -f * k * i.x,  -f * k * i.y};
}

Influence influence(const CombinedMaterial& material, double dx, double dy, double x, double y) {
  KernelIntegrals sum;
  for (const int sx : {-1, 1})
    for (const int sy : {-1, 1})
      add_corner(sx * sy, x + sx * dx / 2, y + sy * dy / 2, material.dissimilarity != 0, sum);
  return influence_of(material, sum);
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
