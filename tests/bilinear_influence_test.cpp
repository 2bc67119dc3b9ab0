#include "microslip/elasticity/bilinear_influence.hpp"

#include "point_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace microslip {
namespace {

constexpr CombinedMaterial material{.shear_modulus = 82e9, .poisson_ratio = 0.28, .dissimilarity = 0.17};
constexpr double dx = 3e-4, dy = 2e-4;

/// Integral over the tent around the edges of its quarters. On each the tent is a sum of products of powers of the
/// distances to the point, and with them a kernel is homogeneous of degree -1, 0 or 1: the divergence of itself times
/// (x, y)/(1, 2 or 3), also where the point lies in the quarter.
Kernels integral_by_edges(const CombinedMaterial& m, Real sx, Real sy, Real x, Real y) {
  Kernels sum{};
  for (const int qx : {-1, 1})
    for (const int qy : {-1, 1}) {
      const Real cx = 1 - qx * x / sx, gx = qx / sx, cy = 1 - qy * y / sy, gy = qy / sy;
      const auto kernel = [&](Real px, Real py) {
        const Real factor = cx * cy + (gx * cy * px + cx * gy * py) / 2 + gx * gy * px * py / 3;
        return combine({}, factor, point_force(m, px, py));
      };
      const Real x1 = std::min(x, x - qx * sx), x2 = std::max(x, x - qx * sx);
      const Real y1 = std::min(y, y - qy * sy), y2 = std::max(y, y - qy * sy);
      const auto along_x = [&](Real h, Real t) { return kernel(t, h); };
      sum = combine(sum, 1, edge_integral(kernel, x2, y1, y2));
      sum = combine(sum, -1, edge_integral(kernel, x1, y1, y2));
      sum = combine(sum, 1, edge_integral(along_x, y2, x1, x2));
      sum = combine(sum, -1, edge_integral(along_x, y1, x1, x2));
    }
  return sum;
}

/// Of `values(s, t)` with the tent as weight, -1 <= s, t <= 1, by Gauss's rule on its quarters.
template <class Values> Kernels weighted_by_tent(const Values& values) {
  static const GaussRule rule = gauss_rule(16);
  Kernels sum{};
  for (std::size_t i = 0; i < rule.nodes.size(); ++i)
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const Real s = (1 + rule.nodes[i]) / 2, t = (1 + rule.nodes[j]) / 2;
      const Real weight = rule.weights[i] * rule.weights[j] / 4 * (1 - s) * (1 - t);
      for (const int qx : {-1, 1})
        for (const int qy : {-1, 1}) sum = combine(sum, weight, values(qx * s, qy * t));
    }
  return sum;
}

/// Integral over the tent for points away from it; nothing cancels.
Kernels integral_by_points(const CombinedMaterial& m, Real sx, Real sy, Real x, Real y) {
  const Kernels sum = weighted_by_tent([&](Real s, Real t) { return point_force(m, x - s * sx, y - t * sy); });
  return combine({}, sx * sy, sum);
}

/// Mean over a rectangle around a point, by Gauss's rule.
template <class Values> Kernels mean_over(double sx, double sy, double x, double y, const Values& values) {
  static const GaussRule rule = gauss_rule(12);
  Kernels sum{};
  for (std::size_t i = 0; i < rule.nodes.size(); ++i)
    for (std::size_t j = 0; j < rule.nodes.size(); ++j)
      sum = combine(sum, rule.weights[i] * rule.weights[j] / 4,
                    as_kernels(values(static_cast<double>(x + rule.nodes[i] * sx / 2),
                                      static_cast<double>(y + rule.nodes[j] * sy / 2))));
  return sum;
}

/// The terms of the differences are as large as r^3/(sx sy).
double rounding(double sx, double sy, double x, double y) {
  const double square = (x * x + y * y) / (sx * sy), ratio = std::max(sx / sy, sy / sx);
  return 3e-15 * (10 * ratio + std::min(square * square, 2500 * ratio * ratio));
}

/// Centre, inside, on the lines where the tent has kinks, within a hair of them, and some elements away.
std::vector<Point> near_points() {
  return in_all_quarters({0.0, 1e-9, 0.2, 0.5, 1.0, 1.0 + 1e-9, 1.0 - 1e-9, 1.6, 2.5, 4.9, 5.1, 7.0},
                         {0.0, 1e-12, 0.1, 0.5, 1.0, 1.0 + 1e-12, 3.0, 5.5});
}

TEST(BilinearInfluence, BothIntegrationsOfTheTestAgree) {
  for (const Point p : {Point{2.5, 0.3}, {-3, 1}, {0, 3}, {5, -5}}) {
    const Kernels one = integral_by_edges(material, dx, dy, p.x * dx, p.y * dy);
    EXPECT_LT(error(integral_by_points(material, dx, dy, p.x * dx, p.y * dy), one, scales(material, one)), 1e-13);
  }
}

TEST(BilinearInfluence, IsTheIntegralOfBoussinesqAndCerruti) {
  for (const double sx : {dx, 0.05 * dx, 10 * dx}) {
    double worst = 0;
    for (const Point p : near_points()) {
      const double x = p.x * sx, y = p.y * dy;
      const Kernels exact = integral_by_edges(material, sx, dy, x, y);
      const double e = error(as_kernels(bilinear_influence(material, sx, dy, x, y)), exact, scales(material, exact));
      EXPECT_LT(e, rounding(sx, dy, x, y)) << text(p) << ", sides " << sx << " x " << dy;
      worst = std::max(worst, e);
    }
    RecordProperty("worst_error_at_ratio_" + std::to_string(sx / dy), std::to_string(worst * 1e15) + "e-15");
  }
}

TEST(BilinearInfluence, HoldsForAllPoissonRatios) {
  for (const double nu : {0.0, 0.25, 0.5}) {
    const CombinedMaterial other{1e6, nu, 0.3};
    for (const Point p : {Point{0, 0}, {1, 1}, {1, 0}, {0.3, -0.1}, {2, -3}, {8, 2}}) {
      const Kernels exact = integral_by_edges(other, dx, dy, p.x * dx, p.y * dy);
      EXPECT_LT(error(as_kernels(bilinear_influence(other, dx, dy, p.x * dx, p.y * dy)), exact, scales(other, exact)),
                1e-12);
    }
  }
}

/// Differences near the element, Gauss's rule far away: both have the same error where they meet, five sides away, and
/// nothing is lost further on.
TEST(BilinearInfluence, ElevenDigitsAtAllDistances) {
  for (const double elements : {2.5, 3.5, 4.5, 4.99, 5.01, 6.0, 10.0, 100.0, 3000.0}) {
    double worst = 0;
    for (int k = 0; k < 40; ++k) {
      const double angle = 0.157 * k, x = elements * dx * std::cos(angle), y = elements * dx * std::sin(angle);
      const Kernels exact = integral_by_points(material, dx, dy, x, y);
      worst = std::max(worst,
                       error(as_kernels(bilinear_influence(material, dx, dy, x, y)), exact, scales(material, exact)));
    }
    EXPECT_LT(worst, elements > 6 ? 2e-14 : 5e-12) << elements;
    RecordProperty("error_at_" + std::to_string(elements), std::to_string(worst * 1e15) + "e-15");
  }
}

/// A tent is the mean of constant elements whose centres lie in a rectangle of the element's sides.
TEST(BilinearInfluence, IsTheMeanOfConstantElements) {
  for (const Point p : {Point{2.6, 0}, {0, 2.4}, {-3, 2}, {4, -4}, {6, 1}}) {
    const double x = p.x * dx, y = p.y * dy;
    const Kernels mean =
        mean_over(dx, dy, x, y, [](double px, double py) { return influence(material, dx, dy, px, py); });
    EXPECT_LT(error(as_kernels(bilinear_influence(material, dx, dy, x, y)), mean, scales(material, mean)), 5e-12)
        << text(p);
  }
}

/// Tents of 1 on n x m elements are constant tractions that fall to 0 on their rim: the mean of constant rectangles of
/// n dx x m dy.
TEST(BilinearInfluence, TheSumOfTentsIsConstant) {
  constexpr int n = 12, m = 10; // rows and columns are centred at half an element from 0
  for (const Point p : {Point{0, 0}, {0.5, 0.5}, {1.5, -2.2}, {-3.1, 0.7}, {9, 8}}) {
    const double x = p.x * dx, y = p.y * dy;
    Kernels sum{};
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i)
        sum = combine(sum, 1,
                      as_kernels(bilinear_influence(material, dx, dy, x - (i - (n - 1) / 2.0) * dx,
                                                    y - (j - (m - 1) / 2.0) * dy)));
    const Kernels mean =
        mean_over(dx, dy, x, y, [](double px, double py) { return influence(material, n * dx, m * dy, px, py); });
    EXPECT_LT(error(sum, mean, scales(material, mean)), 2e-12) << text(p);
  }
}

/// From far away an element is its force; a tent has twice the second moments of a constant one.
TEST(BilinearInfluence, FarAwayItIsAConstantElementOfTheSameForce) {
  double before = 1;
  for (const double elements : {10.0, 20.0, 40.0, 80.0}) {
    const double x = 0.8 * elements * dx, y = 0.6 * elements * dx;
    const Kernels constant = as_kernels(influence(material, dx, dy, x, y));
    Kernels point = point_force(material, x, y);
    for (Real& value : point) value *= dx * dy;
    const Kernels tent = as_kernels(bilinear_influence(material, dx, dy, x, y)), scale = scales(material, constant);
    const double e = error(tent, constant, scale);
    EXPECT_LT(e, 0.3 / (elements * elements));
    EXPECT_NEAR(error(tent, point, scale) / error(constant, point, scale), 2, 0.05);
    if (before < 1) {
      EXPECT_NEAR(before / e, 4, 0.2);
    }
    before = e;
  }
}

/// Mirrored in x: xy and xz change sign; in y: xy and yz. Turned by a right angle: x and y are exchanged.
TEST(BilinearInfluence, Symmetries) {
  for (const Point p : near_points()) {
    SCOPED_TRACE(text(p));
    const double x = p.x * dx, y = p.y * dy, tolerance = 2 * rounding(dx, dy, x, y);
    const auto at = [&](double px, double py) { return as_kernels(bilinear_influence(material, dx, dy, px, py)); };
    const Kernels here = at(x, y), scale = scales(material, here);
    Kernels in_x = at(-x, y), in_y = at(x, -y);
    for (const std::size_t k : {1U, 4U}) in_x[k] = -in_x[k];
    for (const std::size_t k : {1U, 5U}) in_y[k] = -in_y[k];
    const Influence t = bilinear_influence(material, dy, dx, y, x);
    EXPECT_LT(error(in_x, here, scale), tolerance);
    EXPECT_LT(error(in_y, here, scale), tolerance);
    EXPECT_LT(error({t.yy, t.xy, t.xx, t.zz, t.yz, t.xz}, here, scale), tolerance);
  }
}

TEST(BilinearInfluence, ScalesWithLengthAndModulus) {
  for (const Point p : near_points())
    for (const double k : {0x1p-12, 3.7, 1e3}) {
      const double x = p.x * dx, y = p.y * dy;
      const CombinedMaterial stiff{material.shear_modulus * k, material.poisson_ratio, material.dissimilarity};
      const Kernels one = as_kernels(bilinear_influence(material, dx, dy, x, y));
      const Kernels other = as_kernels(bilinear_influence(stiff, k * dx, k * dy, k * x, k * y));
      EXPECT_LT(error(other, one, scales(material, one)), 2 * rounding(dx, dy, x, y)) << text(p);
    }
}

/// A hat is the mean of constant strips whose middles lie within dx/2. Panels that shrink towards the strips' edges,
/// where their influence has kinks.
TEST(BilinearLineInfluence, IsTheMeanOfConstantStrips) {
  static const GaussRule rule = gauss_rule(20);
  for (const double far : {10 * dx, 1.0})
    for (const double x : {0.0, 0.2 * dx, -0.5 * dx, dx, -1.7 * dx, 4.9 * dx, 5.1 * dx, -300 * dx}) {
      std::vector<Real> breaks = {x - dx / 2, x + dx / 2};
      for (const double edge : {-dx / 2, dx / 2})
        for (Real size = dx; size > 1e-12 * dx; size /= 2)
          for (const Real at : {edge - size, Real(edge), edge + size})
            if (at > x - dx / 2 && at < x + dx / 2) breaks.push_back(at);
      std::sort(breaks.begin(), breaks.end());
      Kernels mean{};
      for (std::size_t b = 1; b < breaks.size(); ++b)
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
          const Real half = (breaks[b] - breaks[b - 1]) / 2;
          const Real at = breaks[b - 1] + half * (1 + rule.nodes[i]);
          mean = combine(mean, rule.weights[i] * half / dx,
                         as_kernels(line_influence(material, dx, static_cast<double>(at), far)));
        }
      const Kernels hat = as_kernels(bilinear_line_influence(material, dx, x, far));
      for (std::size_t k = 0; k < hat.size(); ++k)
        EXPECT_LE(std::abs(hat[k] - mean[k]), 2e-12L * std::max(std::abs(mean[k]), Real(dx / material.shear_modulus)))
            << k << ", " << x / dx << " dx, far " << far;
    }
}

/// Between two points an endless strip is a row of many tents; what the row's ends leave is of second order, and of
/// first for xz: see LineInfluence.IsTheLimitOfALongRectangle.
TEST(BilinearLineInfluence, IsTheLimitOfARowOfTents) {
  const double unit = dx / material.shear_modulus, x0 = 1.5 * dx;
  for (const double x : {0.0, 0.5 * dx, dx, -3 * dx})
    for (const int count : {101, 401}) {
      Kernels row{};
      const int half = count / 2;
      for (int j = 0; j < count; ++j) {
        const double y = (j - half) * dx;
        row = combine(row, 1, as_kernels(bilinear_influence(material, dx, dx, x, y)));
        row = combine(row, -1, as_kernels(bilinear_influence(material, dx, dx, x0, y)));
      }
      Kernels rest = combine(combine(as_kernels(bilinear_line_influence(material, dx, x, 1)), -1,
                                     as_kernels(bilinear_line_influence(material, dx, x0, 1))),
                             -1, row);
      rest[4] += 4 * material.dissimilarity / (pi * material.shear_modulus) * (x - x0) / count;
      const double tolerance = 2.5 * (x0 * x0 + x * x + dx * dx) / (dx * dx * count * count) + 1e-10;
      for (std::size_t k = 0; k < rest.size(); ++k)
        EXPECT_LT(static_cast<double>(std::abs(rest[k])) / unit, tolerance) << k << ", x = " << x / dx << " dx";
    }
}

TEST(BilinearLineInfluence, BothItsFormsAgreeWhereTheyMeet) {
  for (const double far : {dx, 10 * dx, 1.0}) {
    const double below = bilinear_line_influence(material, dx, 5 * dx * (1 - 1e-14), far).yy;
    EXPECT_NEAR(bilinear_line_influence(material, dx, 5 * dx, far).yy, below,
                1e-12 * dx / material.shear_modulus * (1 + std::abs(std::log(far / dx))));
  }
}

} // namespace
} // namespace microslip
