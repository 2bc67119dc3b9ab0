#include "microslip/elasticity/bilinear_interior_influence.hpp"

#include "microslip/elasticity/bilinear_influence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace microslip {
namespace {

constexpr Material material = {2.0, 0.28};
constexpr double dx = 1.0, dy = 0.7;

InteriorInfluence at(double x, double y, double depth, Body body = Body::first) {
  return bilinear_interior_influence(material, body, dx, dy, x, y, depth);
}

std::array<double, 9> nine(const InteriorState& s) {
  return {s.ux, s.uy, s.uz, s.stress.xx, s.stress.yy, s.stress.zz, s.stress.xy, s.stress.xz, s.stress.yz};
}
std::vector<double> all(const InteriorInfluence& a) {
  std::vector<double> values;
  for (const InteriorState* s : {&a.px, &a.py, &a.pn})
    for (const double v : nine(*s)) values.push_back(v);
  return values;
}

double largest_difference(const InteriorInfluence& a, const InteriorInfluence& b) {
  const std::vector<double> va = all(a), vb = all(b);
  double worst = 0;
  for (std::size_t k = 0; k < va.size(); ++k) worst = std::max(worst, std::abs(va[k] - vb[k]));
  return worst;
}

/// Sum of both bodies' displacements at the surface: that of bilinear_influence.
TEST(BilinearInteriorInfluence, AtTheSurfaceItIsBilinearInfluence) {
  const Material other = {5.0, 0.4};
  const CombinedMaterial pair = combine(material, other);
  for (const double x : {0.0, 0.3, 1.0, -1.2, 2.0})
    for (const double y : {0.0, -0.35, 0.7, 1.4}) {
      const Influence a = bilinear_influence(pair, dx, dy, x, y);
      const InteriorInfluence one = at(x, y, 0);
      const InteriorInfluence two = bilinear_interior_influence(other, Body::second, dx, dy, x, y, 0);
      const double tolerance = 2e-9;
      EXPECT_NEAR(one.px.ux - two.px.ux, a.xx, tolerance);
      EXPECT_NEAR(one.px.uy - two.px.uy, a.xy, tolerance);
      EXPECT_NEAR(one.py.uy - two.py.uy, a.yy, tolerance);
      EXPECT_NEAR(one.pn.uz - two.pn.uz, a.zz, tolerance);
      EXPECT_NEAR(one.pn.ux - two.pn.ux, a.xz, tolerance);
      EXPECT_NEAR(one.pn.uy - two.pn.uy, a.yz, tolerance);
      EXPECT_NEAR(one.px.uz - two.px.uz, -a.xz, tolerance);
    }
}

/// sigma_xz = -px, sigma_yz = -py, sigma_zz = -pn, for each load alone.
TEST(BilinearInteriorInfluence, AtTheSurfaceStressesAreTheTractions) {
  for (const double x : {0.0, 0.3, 0.5, 1.0, -1.2})
    for (const double y : {0.0, -0.35, 0.1, 0.7}) {
      const double tent = std::max(0.0, 1 - std::abs(x) / dx) * std::max(0.0, 1 - std::abs(y) / dy);
      for (const Body body : {Body::first, Body::second}) {
        const InteriorInfluence a = at(x, y, 0, body);
        EXPECT_NEAR(a.px.stress.xz, -tent, 1e-9);
        EXPECT_NEAR(a.py.stress.yz, -tent, 1e-9);
        EXPECT_NEAR(a.pn.stress.zz, -tent, 1e-9);
        for (const double none : {a.px.stress.zz, a.px.stress.yz, a.py.stress.xz, a.py.stress.zz, a.pn.stress.xz})
          EXPECT_NEAR(none, 0, 1e-9);
      }
    }
}

/// Against many small constant elements, whose error is of second order in their size: extrapolated.
TEST(BilinearInteriorInfluence, IsTheLimitOfSmallConstantElements) {
  const auto sum_of = [](int n, double x, double y, double depth) {
    std::vector<double> sum(27);
    for (int j = -n; j < n; ++j)
      for (int i = -n; i < n; ++i) {
        const double s = (i + 0.5) / n, t = (j + 0.5) / n, height = (1 - std::abs(s)) * (1 - std::abs(t));
        const std::vector<double> part =
            all(interior_influence(material, Body::first, dx / n, dy / n, x - s * dx, y - t * dy, depth));
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += height * part[k];
      }
    return sum;
  };
  for (const double depth : {0.3, 0.6, 2.5})
    for (const double x : {0.0, 0.8, -3.0}) {
      const std::vector<double> coarse = sum_of(12, x, 0.4, depth), fine = sum_of(24, x, 0.4, depth);
      const std::vector<double> tent = all(at(x, 0.4, depth));
      for (std::size_t k = 0; k < tent.size(); ++k) EXPECT_NEAR(tent[k], (4 * fine[k] - coarse[k]) / 3, 3e-6) << k;
    }
}

/// The same mean by far finer quadrature: panels that shrink towards the edges of the constant element.
TEST(BilinearInteriorInfluence, ErrorsByDepth) {
  const auto fine_rule = [](double x, double side) {
    constexpr double nodes[] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831, 0.9061798459386640};
    constexpr double weights[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665,
                                  0.2369268850561891};
    std::vector<double> breaks = {x - side / 2, x + side / 2};
    for (const double edge : {-side / 2, side / 2})
      for (double size = side; size > 1e-9 * side; size /= 2)
        for (const double at : {edge - size, edge, edge + size})
          if (at > x - side / 2 && at < x + side / 2) breaks.push_back(at);
    std::sort(breaks.begin(), breaks.end());
    std::vector<std::pair<double, double>> rule;
    for (std::size_t b = 1; b < breaks.size(); ++b)
      for (int k = 0; k < 5; ++k) {
        const double half = (breaks[b] - breaks[b - 1]) / 2;
        if (half > 0) rule.emplace_back(breaks[b - 1] + half * (1 + nodes[k]), weights[k] * half / side);
      }
    return rule;
  };
  for (const auto& [depth, bound] : {std::pair{0.0, 2e-8},
                                     {1e-6, 3e-7},
                                     {1e-3, 1e-5},
                                     {0.03, 1e-5},
                                     {0.1, 3e-7},
                                     {0.34, 1e-8},
                                     {0.51, 1e-9},
                                     {2.1, 1e-9}}) {
    double worst = 0;
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.7}, {0.4, 0.2}, {1.3, 0.1}}) {
      InteriorInfluence fine;
      for (const auto& [v, wv] : fine_rule(y, dy))
        for (const auto& [u, wu] : fine_rule(x, dx)) {
          const InteriorInfluence a = interior_influence(material, Body::first, dx, dy, u, v, depth);
          const double w = wu * wv;
          const auto add = [&](InteriorState& to, const InteriorState& s) {
            to.ux += w * s.ux, to.uy += w * s.uy, to.uz += w * s.uz;
            to.stress.xx += w * s.stress.xx, to.stress.yy += w * s.stress.yy, to.stress.zz += w * s.stress.zz;
            to.stress.xy += w * s.stress.xy, to.stress.xz += w * s.stress.xz, to.stress.yz += w * s.stress.yz;
          };
          add(fine.px, a.px), add(fine.py, a.py), add(fine.pn, a.pn);
        }
      const double e = largest_difference(at(x, y, depth), fine);
      EXPECT_LT(e, bound) << x << ", " << y << ", depth " << depth;
      worst = std::max(worst, e);
    }
    RecordProperty("worst_error_at_depth_" + std::to_string(depth), std::to_string(worst * 1e12) + "e-12");
  }
}

/// The rules change from one to the other without a jump.
TEST(BilinearInteriorInfluence, RulesAgreeWhereTheyMeet) {
  for (const double side : {dx, dy})
    for (const double depth : {side / 2, 2 * side, 8 * side})
      for (const double x : {0.0, 0.6})
        EXPECT_LT(largest_difference(at(x, 0.2, depth * (1 - 1e-12)), at(x, 0.2, depth)), 1e-9) << depth;
}

/// A row of tents along y, endless, is a strip's hat: stresses, whose ends fall with the row's length, extrapolated.
TEST(BilinearInteriorInfluence, ARowOfTentsIsAHat) {
  const double x = 0.4, depth = 0.6;
  const auto row = [&](int count) {
    std::vector<double> sum(27);
    const int half = count / 2;
    for (int j = 0; j < count; ++j) {
      const std::vector<double> part = all(at(x, (j - half) * dy, depth));
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += part[k];
    }
    return sum;
  };
  const std::vector<double> half = row(201), whole = row(401);
  const std::vector<double> hat = all(bilinear_line_interior_influence(material, Body::first, dx, x, depth, 1));
  for (std::size_t load = 0; load < 3; ++load)
    for (std::size_t k = 9 * load + 3; k < 9 * load + 9; ++k)
      EXPECT_NEAR((401 * whole[k] - 201 * half[k]) / 200, hat[k], 6e-5) << k;
}

} // namespace
} // namespace microslip
