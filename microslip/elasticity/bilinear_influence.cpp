#include "microslip/elasticity/bilinear_influence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

constexpr double far_away = 5; // in units of the longer side

/// factor ln(x + r), where r^2 = x^2 + y^2, without cancellation for x < 0. Factors of 0 make it 0.
double times_log_sum(double factor, double x, double y, double r) {
  if (factor == 0) return 0;
  return factor * (x >= 0 ? std::log(x + r) : 2 * std::log(std::abs(y)) - std::log(r - x));
}

void add(KernelIntegrals& sum, double factor, const KernelIntegrals& a) {
  sum.xx += factor * a.xx;
  sum.xy += factor * a.xy;
  sum.yy += factor * a.yy;
  sum.x += factor * a.x;
  sum.y += factor * a.y;
}

/// The functions Q whose second derivatives along x and y are the kernels.
KernelIntegrals primitives(double x, double y) {
  const double xx = x * x, yy = y * y, r = std::hypot(x, y), cube = r * r * r / 6;
  const double log_x = times_log_sum(y, x, y, r), log_y = times_log_sum(x, y, x, r); // y ln(x + r), x ln(y + r)
  const double log_r = r == 0 ? 0 : std::log(r);
  const double t = x == 0 ? 0 : std::atan(y / x), s = y == 0 ? 0 : std::atan(x / y);
  return {.xx = (x * y * log_x - yy * r) / 2 + cube,
          .xy = -(2 * x * y * r + xx * log_y + yy * log_x) / 6,
          .yy = (x * y * log_y - xx * r) / 2 + cube,
          .x = (x * (3 * yy - xx) * log_r + 3 * xx * y * t + y * yy * s) / 6,
          .y = (y * (3 * xx - yy) * log_r + 3 * x * yy * s + x * xx * t) / 6};
}

KernelIntegrals by_differences(double dx, double dy, double x, double y) {
  constexpr double weights[] = {1, -2, 1};
  KernelIntegrals sum;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      add(sum, weights[i] * weights[j] / (dx * dy), primitives(x + (i - 1) * dx, y + (j - 1) * dy));
  return sum;
}

/// Gauss's rule of six points for the weight 1 - |t| on [-1, 1]: exact for polynomials of degree 11.
constexpr int rule_size = 6;
constexpr double nodes[rule_size] = {-0.8657382949788190962, -0.5766148082484873353, -0.1942636767750388916,
                                     0.1942636767750388916,  0.5766148082484873353,  0.8657382949788190962};
constexpr double weights[rule_size] = {0.0294965616553093465, 0.1474812337052728483, 0.3230222046394178052,
                                       0.3230222046394178052, 0.1474812337052728483, 0.0294965616553093465};

KernelIntegrals by_points(double dx, double dy, double x, double y) {
  KernelIntegrals sum;
  for (int i = 0; i < rule_size; ++i)
    for (int j = 0; j < rule_size; ++j) {
      const double px = x - nodes[i] * dx, py = y - nodes[j] * dy, square = px * px + py * py;
      const double in_plane = 1 / square, cube = in_plane / std::sqrt(square);
      add(sum, weights[i] * weights[j] * dx * dy,
          {px * px * cube, px * py * cube, py * py * cube, px * in_plane, py * in_plane});
    }
  return sum;
}

/// Integral of ln|x/far| with the hat as weight.
double hat_log(double dx, double x, double far) {
  double sum = 0;
  if (std::abs(x) < far_away * dx) { // second differences of x^2 (ln|x/far| - 3/2)/2
    const auto primitive = [far](double t) { return t == 0 ? 0 : t * t * (std::log(std::abs(t) / far) - 1.5) / 2; };
    return (primitive(x - dx) - 2 * primitive(x) + primitive(x + dx)) / dx;
  }
  for (int i = 0; i < rule_size; ++i) sum += weights[i] * dx * std::log(std::abs(x - nodes[i] * dx) / far);
  return sum;
}

/// Integral of the sign with the hat as weight.
double hat_sign(double dx, double x) {
  const double t = std::min(std::abs(x) / dx, 1.0);
  return std::copysign(dx * t * (2 - t), x);
}

} // namespace

Influence bilinear_influence(const CombinedMaterial& material, double dx, double dy, double x, double y) {
  const double unit = std::sqrt(dx) * std::sqrt(dy); // so that logarithms are small
  const double sx = dx / unit, sy = dy / unit, px = x / unit, py = y / unit;
  KernelIntegrals integrals;
  add(integrals, unit,
      std::hypot(px, py) < far_away * std::max(sx, sy) ? by_differences(sx, sy, px, py) : by_points(sx, sy, px, py));
  return influence_of(material, integrals);
}

Influence bilinear_line_influence(const CombinedMaterial& material, double dx, double x, double far) {
  const double nu = material.poisson_ratio, k = material.dissimilarity;
  const double log = hat_log(dx, x, far), f = -2 * log / (std::numbers::pi * material.shear_modulus);
  return {(1 - nu) * f, 0, f, (1 - nu) * f, -k * hat_sign(dx, x) / material.shear_modulus, 0};
}

} // namespace microslip
