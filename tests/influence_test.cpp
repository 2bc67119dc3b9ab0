#include "microslip/elasticity/influence.hpp"

#include "point_force.hpp"
#include "tests/support/steel.hpp"

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

/// Integral over the rectangle around its edges: a kernel that is homogeneous of degree -1 is the divergence of itself
/// times (x, y), also where the point lies in the rectangle.
Kernels integral_by_edges(const CombinedMaterial& m, Real sx, Real sy, Real x, Real y) {
  const Real x1 = x - sx / 2, x2 = x + sx / 2, y1 = y - sy / 2, y2 = y + sy / 2;
  const auto along_y = [&](Real h, Real t) { return point_force(m, h, t); };
  const auto along_x = [&](Real h, Real t) { return point_force(m, t, h); };
  Kernels sum = edge_integral(along_y, x2, y1, y2);
  sum = combine(sum, -1, edge_integral(along_y, x1, y1, y2));
  sum = combine(sum, 1, edge_integral(along_x, y2, x1, x2));
  return combine(sum, -1, edge_integral(along_x, y1, x1, x2));
}

/// Integral over the rectangle by Gauss's rule in both directions, for points away from it; nothing cancels.
Kernels integral_by_points(const CombinedMaterial& m, Real sx, Real sy, Real x, Real y) {
  static const GaussRule rule = gauss_rule(16);
  Kernels sum{};
  for (std::size_t i = 0; i < rule.nodes.size(); ++i)
    for (std::size_t j = 0; j < rule.nodes.size(); ++j)
      sum = combine(sum, rule.weights[i] * rule.weights[j] * sx * sy / 4,
                    point_force(m, x + rule.nodes[i] * sx / 2, y + rule.nodes[j] * sy / 2));
  return sum;
}

/// The corners' terms are as large as r, their sum as small as sx sy/r: rounding grows with the square of the distance.
double rounding(double sx, double sy, double x, double y) {
  return 4e-15 * (10 + (x * x + y * y) / (sx * sy));
}

/// Centre, inside, edges, corners, on the lines of the edges, within a hair of them, and some elements away.
std::vector<Point> near_points() {
  return in_all_quarters({0.0, 0.2, 0.5, 0.5 + 1e-9, 0.5 - 1e-9, 0.8, 1.0, 2.5, 7.0},
                         {0.0, 0.1, 0.5, 0.5 + 1e-12, 0.9, 3.0, 5.5});
}

TEST(Influence, BothIntegrationsOfTheTestAgree) {
  for (const Point p : {Point{1.5, 0.3}, {-2, 1}, {0, 3}, {5, -5}}) {
    const Kernels one = integral_by_edges(material, dx, dy, p.x * dx, p.y * dy);
    EXPECT_LT(error(integral_by_points(material, dx, dy, p.x * dx, p.y * dy), one, scales(material, one)), 1e-13);
  }
}

TEST(Influence, IsTheIntegralOfBoussinesqAndCerruti) {
  double worst = 0;
  for (const double sx : {dx, 0.02 * dx, 40 * dx})
    for (const Point p : near_points()) {
      const double x = p.x * sx, y = p.y * dy;
      const Kernels exact = integral_by_edges(material, sx, dy, x, y);
      const double e = error(as_kernels(influence(material, sx, dy, x, y)), exact, scales(material, exact));
      EXPECT_LT(e, std::min(1e-10, rounding(sx, dy, x, y))) << text(p) << ", sides " << sx << " x " << dy;
      worst = std::max(worst, e);
    }
  RecordProperty("worst_relative_error", std::to_string(worst * 1e15) + "e-15");
}

TEST(Influence, HoldsForAllPoissonRatios) {
  for (const double nu : {0.0, 0.25, 0.5}) {
    const CombinedMaterial other{1e6, nu, 0.3};
    for (const Point p : {Point{0, 0}, {0.5, 0.5}, {0.5, 0}, {0.3, -0.1}, {2, -3}}) {
      const Kernels exact = integral_by_edges(other, dx, dy, p.x * dx, p.y * dy);
      EXPECT_LT(error(as_kernels(influence(other, dx, dy, p.x * dx, p.y * dy)), exact, scales(other, exact)), 2e-13);
    }
  }
}

TEST(Influence, HundredsOfElementsAwayTenDigitsAreLeft) {
  for (const double elements : {10.0, 30.0, 100.0, 300.0}) {
    double worst = 0;
    for (int k = 0; k < 40; ++k) {
      const double angle = 0.157 * k, x = elements * dx * std::cos(angle), y = elements * dx * std::sin(angle);
      const Kernels exact = integral_by_points(material, dx, dy, x, y);
      const double e = error(as_kernels(influence(material, dx, dy, x, y)), exact, scales(material, exact));
      EXPECT_LT(e, rounding(dx, dy, x, y)) << elements;
      worst = std::max(worst, e);
    }
    EXPECT_LT(worst, 1e-9);
    RecordProperty("error_at_" + std::to_string(static_cast<int>(elements)), std::to_string(worst * 1e15) + "e-15");
  }
}

/// From far away a rectangle is a point, the error falling with the square of the distance.
TEST(Influence, FarAwayItIsThatOfAPointForce) {
  double before = 1;
  for (const double elements : {5.0, 10.0, 20.0, 40.0}) {
    const double x = 0.8 * elements * dx, y = 0.6 * elements * dx;
    Kernels point = point_force(material, x, y);
    for (Real& value : point) value *= dx * dy;
    const double e = error(as_kernels(influence(material, dx, dy, x, y)), point, scales(material, point));
    EXPECT_LT(e, 0.3 / (elements * elements));
    if (before < 1) {
      EXPECT_NEAR(before / e, 4, 0.3);
    }
    before = e;
  }
}

/// Mirrored in x: xy and xz change sign; in y: xy and yz.
TEST(Influence, EvenAndOdd) {
  for (const Point p : near_points()) {
    SCOPED_TRACE(text(p));
    const double x = p.x * dx, y = p.y * dy, tolerance = 2 * rounding(dx, dy, x, y);
    const Kernels here = as_kernels(influence(material, dx, dy, x, y)), scale = scales(material, here);
    Kernels in_x = as_kernels(influence(material, dx, dy, -x, y)),
            in_y = as_kernels(influence(material, dx, dy, x, -y));
    for (const std::size_t k : {1U, 4U}) in_x[k] = -in_x[k];
    for (const std::size_t k : {1U, 5U}) in_y[k] = -in_y[k];
    EXPECT_LT(error(in_x, here, scale), tolerance);
    EXPECT_LT(error(in_y, here, scale), tolerance);
    if (p.x == 0) {
      EXPECT_LT(std::abs(here[1]) / scale[1], tolerance);
      EXPECT_LT(std::abs(here[4]) / scale[4], tolerance);
    }
  }
}

/// x and y are exchanged.
TEST(Influence, TurnedByARightAngle) {
  for (const Point p : near_points()) {
    const double x = p.x * dx, y = p.y * dy;
    const Influence a = influence(material, dx, dy, x, y), t = influence(material, dy, dx, y, x);
    const Kernels turned = {t.yy, t.xy, t.xx, t.zz, t.yz, t.xz};
    EXPECT_LT(error(as_kernels(a), turned, scales(material, turned)), 2 * rounding(dx, dy, x, y)) << text(p);
  }
}

/// Betti: the mean displacement of rectangle 2 by a traction on rectangle 1, times the area of 2, is that of 1 by a
/// traction on 2, times the area of 1.
TEST(Influence, IsReciprocal) {
  static const GaussRule rule = gauss_rule(12);
  const double sx = 2 * dx, sy = 0.7 * dy, away_x = 2.1 * dx, away_y = 1.2 * dy;
  const auto mean_over = [](double from_x, double from_y, double to_x, double to_y, double x, double y) {
    Kernels sum{};
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
      for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
        const auto px = static_cast<double>(x + rule.nodes[i] * to_x / 2);
        const auto py = static_cast<double>(y + rule.nodes[j] * to_y / 2);
        sum = combine(sum, rule.weights[i] * rule.weights[j] / 4,
                      as_kernels(influence(material, from_x, from_y, px, py)));
      }
    return sum;
  };
  Kernels forth = mean_over(dx, dy, sx, sy, away_x, away_y), back = mean_over(sx, sy, dx, dy, -away_x, -away_y);
  for (Real& value : forth) value *= sx * sy;
  for (Real& value : back) value *= dx * dy;
  back[4] = -back[4]; // uzx = -uxz, seen from the other side
  back[5] = -back[5];
  EXPECT_LT(error(forth, back, scales(material, back)), 1e-12);
}

TEST(Influence, ARectangleIsTheSumOfItsQuarters) {
  for (const Point p : near_points()) {
    const double x = p.x * dx, y = p.y * dy;
    Kernels quarters{};
    for (const int i : {-1, 1})
      for (const int j : {-1, 1})
        quarters =
            combine(quarters, 1, as_kernels(influence(material, dx / 2, dy / 2, x + i * dx / 4, y + j * dy / 4)));
    const Kernels whole = as_kernels(influence(material, dx, dy, x, y));
    EXPECT_LT(error(whole, quarters, scales(material, whole)), 4 * rounding(dx, dy, x, y)) << text(p);
  }
}

/// Lengths k times as large give displacements k times as large, a modulus k times as large the k-th part.
TEST(Influence, ScalesWithLengthAndModulus) {
  for (const Point p : near_points())
    for (const double k : {0x1p-12, 3.7, 1e3}) {
      const double x = p.x * dx, y = p.y * dy;
      const CombinedMaterial stiff{material.shear_modulus * k, material.poisson_ratio, material.dissimilarity};
      const Kernels one = as_kernels(influence(material, dx, dy, x, y));
      const Kernels other = as_kernels(influence(stiff, k * dx, k * dy, k * x, k * y));
      EXPECT_LT(error(other, one, scales(material, one)), 2 * rounding(dx, dy, x, y)) << text(p);
    }
}

TEST(Influence, SimilarBodiesHaveNoCoupling) {
  const Influence a = influence(steel, dx, dy, 1.3 * dx, 0.2 * dy), l = line_influence(steel, dx, 1.3 * dx, 1);
  for (const double value : {a.xz, a.yz, l.xz, l.yz}) EXPECT_EQ(value, 0);
}

/// Between two points the constant of the endless strip drops out. With x/L for a rectangle of length L the rest is of
/// second order, except for xz, whose first-order term is -4 K/(pi G) (x - x0) dx/L.
TEST(LineInfluence, IsTheLimitOfALongRectangle) {
  const double unit = dx / material.shear_modulus, x0 = 1.5 * dx, far = 10 * dx;
  for (const double x : {0.0, 0.2 * dx, 0.5 * dx, 0.7 * dx, -dx, 3 * dx, -20 * dx})
    for (const double length : {100 * dx, 400 * dx, 1600 * dx}) {
      const Kernels strip = combine(as_kernels(line_influence(material, dx, x, far)), -1,
                                    as_kernels(line_influence(material, dx, x0, far)));
      const Kernels rectangle = combine(as_kernels(influence(material, dx, length, x, 0)), -1,
                                        as_kernels(influence(material, dx, length, x0, 0)));
      Kernels rest = combine(strip, -1, rectangle);
      rest[4] += 4 * material.dissimilarity / (pi * material.shear_modulus) * (x - x0) * dx / length;
      const double tolerance = 2 * (x0 * x0 + x * x) / (length * length) + 1e-12 * length / dx;
      for (std::size_t k = 0; k < rest.size(); ++k)
        EXPECT_LT(static_cast<double>(std::abs(rest[k])) / unit, tolerance) << k << ", x = " << x / dx << " dx";
    }
}

/// xz needs no constant: u_x by pressure is half a jump K/G times the strip's width on either side.
TEST(LineInfluence, PressureMovesTheSurfaceTowardsItself) {
  const double jump = material.dissimilarity * dx / material.shear_modulus;
  for (const double x : {0.5 * dx, dx, 30 * dx}) {
    EXPECT_NEAR(line_influence(material, dx, x, 1).xz, -jump, 1e-14 * jump);
    EXPECT_NEAR(line_influence(material, dx, -x, 1).xz, jump, 1e-14 * jump);
  }
  EXPECT_NEAR(line_influence(material, dx, 0.25 * dx, 1).xz, -jump / 2, 1e-14 * jump);
  EXPECT_EQ(line_influence(material, dx, 0, 1).xz, 0);
}

/// L = integral of ln|x/far|: differences between points in closed form, and their common factors.
TEST(LineInfluence, ClosedFormOfItsDifferences) {
  const double f = 1 / (std::numbers::pi * material.shear_modulus), nu = material.poisson_ratio;
  for (const double far : {dx, 1.0, 1e3}) {
    const Influence edge = line_influence(material, dx, dx / 2, far), middle = line_influence(material, dx, 0, far);
    // L(dx/2) - L(0) = dx ln 2
    EXPECT_NEAR(edge.yy - middle.yy, -2 * f * dx * std::numbers::ln2, 1e-14 * std::abs(middle.yy));
    for (const double x : {0.0, 0.3 * dx, dx / 2, 4 * dx, -4 * dx}) {
      const Influence a = line_influence(material, dx, x, far);
      EXPECT_DOUBLE_EQ(a.xx, a.zz);
      EXPECT_DOUBLE_EQ(a.xx, (1 - nu) * a.yy);
      EXPECT_EQ(a.xy, 0);
      EXPECT_EQ(a.yz, 0);
    }
  }
}

TEST(LineInfluence, IsZeroAtTheDistanceFar) {
  for (const double far : {10 * dx, 100 * dx, 1e4 * dx})
    for (const int side : {-1, 1}) {
      const double at_far = line_influence(material, dx, side * far, far).zz;
      EXPECT_NEAR(at_far * material.shear_modulus / dx, 0, 0.1 * (dx / far) * (dx / far) + 1e-11);
    }
}

TEST(LineInfluence, TwoHalvesMakeAStrip) {
  for (const double x : {0.0, 0.25 * dx, 0.5 * dx, 0.9 * dx, -3 * dx}) {
    const Kernels halves = combine(as_kernels(line_influence(material, dx / 2, x - dx / 4, 1)), 1,
                                   as_kernels(line_influence(material, dx / 2, x + dx / 4, 1)));
    const Kernels whole = as_kernels(line_influence(material, dx, x, 1));
    for (std::size_t k = 0; k < whole.size(); ++k)
      EXPECT_LE(std::abs(whole[k] - halves[k]), 1e-14L * std::abs(whole[k]) + 1e-30L);
  }
}

} // namespace
} // namespace microslip
