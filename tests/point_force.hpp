#pragma once

#include "microslip/elasticity/influence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numbers>
#include <string>
#include <vector>

namespace microslip {

using Real = long double;
inline constexpr Real pi = std::numbers::pi_v<Real>;

/// xx, xy, yy, zz, xz, yz, in this order.
using Kernels = std::array<Real, 6>;

inline Kernels as_kernels(const Influence& a) {
  return {a.xx, a.xy, a.yy, a.zz, a.xz, a.yz};
}

inline Kernels combine(const Kernels& a, Real factor, const Kernels& b) {
  Kernels sum;
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = a[k] + factor * b[k];
  return sum;
}

/// Boussinesq's and Cerruti's displacement difference from a unit force, at (x, y) from it (Johnson 1985, section 3.2
/// and 3.6, for both bodies).
inline Kernels point_force(const CombinedMaterial& m, Real x, Real y) {
  const Real nu = m.poisson_ratio, k = m.dissimilarity, f = 1 / (pi * m.shear_modulus);
  const Real r = std::hypot(x, y), r2 = r * r, r3 = r * r2;
  return {f * ((1 - nu) / r + nu * x * x / r3),
          f * nu * x * y / r3,
          f * ((1 - nu) / r + nu * y * y / r3),
          f * (1 - nu) / r,
          -f * k * x / r2,
          -f * k * y / r2};
}

struct GaussRule {
  std::vector<Real> nodes, weights; ///< on [-1, 1]
};
/// Roots of the Legendre polynomial by Newton's method.
inline GaussRule gauss_rule(int n) {
  GaussRule rule;
  for (int i = 0; i < n; ++i) {
    Real x = std::cos(pi * (i + 0.75L) / (n + 0.5L)), slope = 1;
    for (int step = 0; step < 20; ++step) {
      Real p = 1, before = 0;
      for (int k = 0; k < n; ++k) {
        const Real next = ((2 * k + 1) * x * p - k * before) / (k + 1);
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    rule.nodes.push_back(x);
    rule.weights.push_back(2 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

/// Integral of k(h, t) h over t from t1 to t2. With t = |h| sinh v the integrand is smooth however small h is.
template <class Kernel> Kernels edge_integral(Kernel kernel, Real h, Real t1, Real t2) {
  static const GaussRule rule = gauss_rule(20);
  Kernels sum{};
  if (h == 0) return sum;
  const Real size = std::abs(h), v1 = std::asinh(t1 / size), v2 = std::asinh(t2 / size);
  const int panels = 1 + static_cast<int>(std::abs(v2 - v1));
  const Real half = (v2 - v1) / panels / 2;
  for (int p = 0; p < panels; ++p)
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const Real v = v1 + half * (2 * p + 1 + rule.nodes[i]);
      sum = combine(sum, rule.weights[i] * half * size * std::cosh(v) * h, kernel(h, size * std::sinh(v)));
    }
  return sum;
}

/// What errors are measured by: the sizes that the kernels have without their factors of direction.
inline Kernels scales(const CombinedMaterial& m, const Kernels& exact) {
  const Real of_one = exact[3] / (1 - m.poisson_ratio); // integral of 1/(pi G r)
  const Real k = std::abs(m.dissimilarity);
  return {of_one, of_one, of_one, exact[3], k * of_one, k * of_one};
}

/// Largest error of the six.
inline double error(const Kernels& value, const Kernels& exact, const Kernels& scale) {
  Real worst = 0;
  for (std::size_t k = 0; k < value.size(); ++k) worst = std::max(worst, std::abs(value[k] - exact[k]) / scale[k]);
  return static_cast<double>(worst);
}

/// A point in units of an element's sides, from its centre.
struct Point {
  double x, y;
};

inline std::string text(const Point& p) {
  return std::to_string(p.x) + ", " + std::to_string(p.y) + " elements away";
}

/// All pairs of these, with both signs of each.
inline std::vector<Point> in_all_quarters(std::initializer_list<double> xs, std::initializer_list<double> ys) {
  std::vector<Point> points;
  for (const double x : xs)
    for (const double y : ys)
      for (const int sx : {-1, 1})
        for (const int sy : {-1, 1}) points.push_back({sx * x, sy * y});
  return points;
}

} // namespace microslip
