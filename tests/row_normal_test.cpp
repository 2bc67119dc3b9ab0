#include "microslip/railway/rows/row_normal.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/normal/normal_problem.hpp"
#include "microslip/railway/rows/kernel/row_pair.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace microslip {
namespace {

using Pair = detail::RowPair<double>;
/// From the loaded row's middle to a distance.
Pair to(double distance, double a, double b) {
  return Pair::between(0, distance, a, b);
}

/// E[asinh(D/|a S - b T|)]: with S = cos(theta) the densities' roots vanish; nodes of S and T differ, and Z = 0, where
/// it is singular, is not among them.
double mean_by_sums(double distance, double a, double b) {
  const int n = 3000, m = 1009;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double first = std::numbers::pi * (i + 0.5) / n, second = std::numbers::pi * (j + 0.41) / m;
      const double z = std::abs(a * std::cos(first) - b * std::cos(second));
      sum += std::pow(std::sin(first) * std::sin(second), 2) * std::asinh(distance / std::max(z, 1e-9));
    }
  return 4 * sum / n / m;
}

TEST(RowPair, IsTheMeanOverBothRows) {
  for (const double distance : {0.02, 0.3, 2.0, 150.0})
    for (const double b : {0.7, 0.4, 0.1}) { // of both rows' order and of equal rows
      const double sum = mean_by_sums(distance, 1, b);
      EXPECT_NEAR(to(distance, 1, b).p, sum, 4e-3 * sum) << distance << ' ' << b;
      EXPECT_NEAR(to(distance, b, 1).p, sum, 4e-3 * sum) << distance << ' ' << b;
    }
  const double root3 = std::sqrt(3.0), equal = mean_by_sums(0.5, root3, 1), point = mean_by_sums(0.5, 1, 1e-9);
  EXPECT_NEAR(to(0.5, root3, 1).p, equal, 1e-3 * equal); // rho^2 = 1/4
  EXPECT_NEAR(to(0.5, 1, 1e-9).p, point, 5e-4 * point);
}

TEST(RowPair, HasDerivativesByBothLengths) {
  for (double distance = 1e-3; distance < 500; distance *= 1.3)
    for (const double b : {1.0, 0.9, 0.3, 2.0}) {
      const double h = 1e-4;
      const auto here = to(distance, 1, b), back = to(-distance, 1, b);
      const auto low = to(distance, std::exp(-h), b), high = to(distance, std::exp(h), b);
      const auto less = to(distance, 1, b * std::exp(-h)), more = to(distance, 1, b * std::exp(h));
      EXPECT_NEAR(here.by_a, (high.p - low.p) / (2 * h), 1e-5 * here.p);
      EXPECT_NEAR(here.by_b, (more.p - less.p) / (2 * h), 1e-5 * here.p);
      EXPECT_NEAR(here.by_aa, (high.by_a - low.by_a) / (2 * h), 3e-3 * here.p);
      EXPECT_NEAR(here.by_ab, (more.by_a - less.by_a) / (2 * h), 3e-3 * here.p);
      EXPECT_EQ(back.p, -here.p);
      EXPECT_EQ(back.by_ab, -here.by_ab);
    }
}

/// A paraboloid above a plane, A x^2 + B (y - y0)^2, in rows over 1.35 times the ellipse of Hertz.
std::vector<NormalRow> rows_over(double a_curvature, double b_curvature, double half_width, double overlap, int n,
                                 double shift = 0, double y0 = 0) {
  std::vector<NormalRow> rows;
  const double width = 2.7 * half_width / n;
  for (int k = 0; k < n; ++k) {
    const double y = -1.35 * half_width + (k + 0.5 + shift) * width;
    rows.push_back({{0, y0 + y, 0}, y0 + y, 0, width, b_curvature * y * y - overlap, a_curvature, 0});
  }
  return rows;
}

double total(const RowNormal& normal, const std::vector<NormalRow>& rows, std::size_t first, std::size_t count) {
  double sum = 0;
  for (std::size_t k = first; k < first + count; ++k) sum += normal.loads()[k] * rows[k].width;
  return sum;
}

TEST(RowNormal, IsHertzOnEllipses) {
  RowNormal normal(40);
  const double load = 80e3, radius = 0.46;
  for (const double lateral_radius : {0.02, 0.08, 0.3, 1.5, 20.0})
    for (const double shift : {0.0, 0.3}) {
      const HertzContact hertz = hertz_from_load({0.5 / radius, 0.5 / lateral_radius}, steel, load);
      const auto rows = rows_over(0.5 / radius, 0.5 / lateral_radius, hertz.b, hertz.approach, 16, shift);
      const RowNormal::Result found = normal.solve(steel, rows, load, false, 40);
      EXPECT_EQ(found.status, Status::ok);
      EXPECT_NEAR(found.lowering, 0, 0.002 * hertz.approach) << lateral_radius;
      double peak = 0, half_length = 0;
      for (std::size_t k = 0; k < rows.size(); ++k) {
        if (!(normal.loads()[k] > 0)) continue;
        peak = std::max(peak, 2 * normal.loads()[k] / (std::numbers::pi * normal.half_lengths()[k]));
        half_length = std::max(half_length, normal.half_lengths()[k]);
      }
      EXPECT_NEAR(peak, hertz.peak_pressure, 0.007 * hertz.peak_pressure) << lateral_radius;
      EXPECT_NEAR(half_length, hertz.a, 0.015 * hertz.a) << lateral_radius;
    }
}

TEST(RowNormal, BearsTheVerticalForceThatItsOwnHeightHas) {
  RowNormal normal(40);
  auto rows = rows_over(1.0, 2.0, 5e-3, 8e-5, 14);
  for (NormalRow& row : rows) row.angle = 0.4, row.shear = -0.2;
  const double load = 40e3, share = std::cos(0.4) - 0.2 * std::sin(0.4);
  const RowNormal::Result found = normal.solve(steel, rows, load, false, 40);
  EXPECT_NEAR(total(normal, rows, 0, rows.size()) * share, load, 1e-9 * load);
  const std::vector<double> loads(normal.loads().begin(), normal.loads().end());
  for (NormalRow& row : rows) row.gap -= found.lowering * std::cos(0.4);
  const RowNormal::Result again = normal.solve(steel, rows, {}, false, 40);
  EXPECT_EQ(again.lowering, 0);
  for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_NEAR(normal.loads()[k], loads[k], 1e-8 * loads[7]);
}

TEST(RowNormal, StartsFromTheLastSolveWithoutChangingTheAnswer) {
  RowNormal cold(40), warm(40);
  warm.solve(steel, rows_over(1.0, 2.0, 5e-3, 6e-5, 14), 30e3, false, 40);
  auto rows = rows_over(1.1, 2.3, 5e-3, 7e-5, 15);
  for (std::size_t k = 0; k < 14; ++k) rows[k].before = k;
  const auto a = cold.solve(steel, rows, 50e3, false, 40), b = warm.solve(steel, rows, 50e3, true, 40);
  EXPECT_NEAR(a.lowering, b.lowering, 1e-14);
  EXPECT_LE(b.steps, a.steps);
}

TEST(RowNormal, LiftsANeighbouringPatchAsItsForceDoes) {
  // Two spheres that overlap alike: each lifts the other off by C F/d, which costs 3/2 F/approach for each metre.
  RowNormal normal(80);
  const double curvature = 0.5 / 0.3, overlap = 5e-5, distance = 0.03;
  const auto one = rows_over(curvature, curvature, 4e-3, overlap, 24);
  auto both = rows_over(curvature, curvature, 4e-3, overlap, 24);
  for (const NormalRow& row : rows_over(curvature, curvature, 4e-3, overlap, 24, 0, distance)) both.push_back(row);
  normal.solve(steel, one, {}, false, 40);
  const double alone = total(normal, one, 0, one.size());
  normal.solve(steel, both, {}, false, 40);
  const double beside = total(normal, both, 0, one.size());
  EXPECT_NEAR(total(normal, both, one.size(), one.size()), beside, 1e-9 * beside);
  const double lift = (1 - steel.poisson_ratio) / (std::numbers::pi * steel.shear_modulus) * beside / distance;
  EXPECT_NEAR(beside, alone * std::pow(1 - lift / overlap, 1.5), 0.003 * alone);
}

TEST(RowNormal, IsTheHalfSpacesContactWhereCurvaturesVary) {
  // Two radii, 30 mm and 600 mm, that meet where the contact is deepest, and 16 rows that follow them.
  const double a_curvature = 0.5 / 0.46, load = 60e3, overlap = 1.2e-4;
  const auto gap = [](double y) { return y < 0 ? y * y / 0.06 : y * y / 1.2; };
  const int mx = 41, my = 81;
  const double x_half = 8e-3, low = -4e-3, high = 16e-3, dx = 2 * x_half / mx, dy = (high - low) / my;
  const ElementGrid grid{.mx = mx, .my = my, .x0 = -x_half + dx / 2, .y0 = low + dy / 2, .dx = dx, .dy = dy};
  std::vector<double> gaps;
  for (int j = 0; j < my; ++j)
    for (int i = 0; i < mx; ++i) gaps.push_back(a_curvature * std::pow(grid.x(i), 2) + gap(grid.y(j)));
  NormalProblem problem(steel, grid);
  const NormalSolution exact = problem.solve(gaps, {NormalLoad::Given::force, load}, 1e-9);

  std::vector<NormalRow> rows;
  const double inner = -std::sqrt(0.06 * overlap), outer = std::sqrt(1.2 * overlap);
  const int few = 8;
  for (int k = 0; k < 2 * few; ++k) {
    const double from = k < few ? inner * (few - k) / few : outer * (k - few) / few;
    const double to = k < few ? inner * (few - k - 1) / few : outer * (k - few + 1) / few;
    rows.push_back(
        {{0, (from + to) / 2, 0}, (from + to) / 2, 0, to - from, gap((from + to) / 2) - overlap, a_curvature, 0});
  }
  RowNormal normal(40);
  const RowNormal::Result found = normal.solve(steel, rows, load, false, 40);
  EXPECT_EQ(found.status, Status::ok);
  EXPECT_NEAR(overlap + found.lowering, exact.approach, 0.005 * exact.approach);
  double centre = 0, exact_centre = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) centre += normal.loads()[k] * rows[k].width * rows[k].place.y / load;
  for (std::size_t k = 0; k < gaps.size(); ++k)
    exact_centre += exact.pressure[k] * grid.element_area() * grid.y(static_cast<int>(k) / mx) / load;
  EXPECT_NEAR(centre, exact_centre, 5e-5);
}

} // namespace
} // namespace microslip
