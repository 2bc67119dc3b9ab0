#include "microslip/exact/halfspace/surface_operator.hpp"

#include "dense_response.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/numbers.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace microslip {
namespace {

ElementGrid rectangles(int mx, int my, double dx = 3e-4, double dy = 2e-4) {
  return {.mx = mx, .my = my, .x0 = -1e-3, .y0 = 2e-3, .dx = dx, .dy = dy, .line = false};
}
ElementGrid strips(int mx) {
  return {.mx = mx, .my = 1, .x0 = 0, .y0 = 0, .dx = 3e-4, .dy = 7, .line = true};
}

std::vector<ElementGrid> grids() {
  return {rectangles(1, 1),  rectangles(1, 9), rectangles(12, 1), rectangles(5, 7),
          rectangles(16, 9), strips(1),        strips(24),        rectangles(8, 6, 5e-5, 1e-3)};
}

std::string text(const ElementGrid& grid) {
  return std::to_string(grid.mx) + " x " + std::to_string(grid.my) + (grid.line ? " strips" : " rectangles");
}

Field random_tractions(const ElementGrid& grid, unsigned seed) {
  return random_field(grid.count(), seed, 1e6);
}

double dot(const Field& a, const Field& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Rounding, of products and of influences far away, is measured by the displacement of the element itself.
void expect_same(const Field& value, const Field& exact, double scale) {
  ASSERT_EQ(value.size(), exact.size());
  for (std::size_t k = 0; k < value.size(); ++k) ASSERT_NEAR(value[k], exact[k], 1e-13 * scale);
}

PlaneFields apply(TangentialOperator response, const Field& px, const Field& py) {
  PlaneFields u{Field(px.size()), Field(px.size())};
  response.apply(px, py, u.x, u.y);
  return u;
}

/// The size of u for tractions p, of the order of the part of the element itself times the square root of their number.
double scale_of(const ElementGrid& grid, const Field& p) {
  const double self = element_influence(steel, grid, 0, 0).yy;
  return std::abs(self) * largest(p) * std::sqrt(double(grid.count()));
}

TEST(SurfaceResponse, NormalIsTheDenseSum) {
  for (const ElementGrid& grid : grids()) {
    SCOPED_TRACE(text(grid));
    const Field p = random_tractions(grid, 1);
    Field u(p.size());
    NormalOperator(steel, grid).apply(p, u);
    expect_same(u, dense_normal_displacement(steel, grid, p), scale_of(grid, p));
  }
}

TEST(SurfaceResponse, TangentialIsTheDenseSum) {
  for (const ElementGrid& grid : grids()) {
    SCOPED_TRACE(text(grid));
    const Field px = random_tractions(grid, 1), py = random_tractions(grid, 2);
    const PlaneFields u = apply(TangentialOperator::displacement(steel, grid), px, py);
    const PlaneFields exact = dense_displacement(steel, grid, px, py);
    expect_same(u.x, exact.x, scale_of(grid, px));
    expect_same(u.y, exact.y, scale_of(grid, px));
  }
}

/// Any shift, of a part of an element or of more than the grid, forth and back.
TEST(SurfaceResponse, DisplacementAtShiftedPoints) {
  for (const ElementGrid& grid : grids())
    for (const double elements : {0.25, -1.0, 1.7, -40.0}) {
      SCOPED_TRACE(text(grid) + ", shift " + std::to_string(elements));
      const double shift = elements * grid.dx, length = 3.2;
      const Field px = random_tractions(grid, 1), py = random_tractions(grid, 2);
      PlaneFields u = apply(TangentialOperator::displacement(steel, grid, {shift, 0}, length), px, py);
      const PlaneFields exact = dense_displacement(steel, grid, px, py, shift);
      for (Field* field : {&u.x, &u.y})
        for (double& value : *field) value *= length;
      expect_same(u.x, exact.x, scale_of(grid, px));
      expect_same(u.y, exact.y, scale_of(grid, px));
    }
}

/// D p = (u(x) - u(x + step))/|step|, for rolling along +x and -x.
TEST(SurfaceResponse, GrowthIsADifferenceOfDisplacements) {
  for (const ElementGrid& grid : grids())
    for (const double elements : {1.0, -1.0, 0.3, -2.5, 5.0}) {
      SCOPED_TRACE(text(grid) + ", step " + std::to_string(elements));
      const double step = elements * grid.dx, length = std::abs(step);
      const Field px = random_tractions(grid, 1), py = random_tractions(grid, 2);
      PlaneFields difference = apply(TangentialOperator::difference(steel, grid, step), px, py);
      PlaneFields exact = dense_displacement(steel, grid, px, py);
      const PlaneFields before = dense_displacement(steel, grid, px, py, step);
      for (std::size_t k = 0; k < px.size(); ++k) {
        exact.x[k] -= before.x[k];
        exact.y[k] -= before.y[k];
        difference.x[k] *= length;
        difference.y[k] *= length;
      }
      expect_same(difference.x, exact.x, scale_of(grid, px));
      expect_same(difference.y, exact.y, scale_of(grid, px));
    }
}

TEST(SurfaceResponse, DiagonalIsWhatAnElementDoesToItself) {
  const ElementGrid grid = rectangles(4, 3);
  for (const double step : {grid.dx, -2 * grid.dx}) {
    const Influence here = influence(steel, grid.dx, grid.dy, 0, 0),
                    before = influence(steel, grid.dx, grid.dy, step, 0);
    const double d = (here.xx - before.xx + here.yy - before.yy) / 2 / std::abs(step);
    EXPECT_NEAR(TangentialOperator::difference(steel, grid, step).diagonal(), d, 1e-15 * d);
    EXPECT_GT(d, 0);
  }
  const Influence self = influence(steel, grid.dx, grid.dy, 0, 0);
  EXPECT_NEAR(TangentialOperator::displacement(steel, grid, {}, 2).diagonal(), (self.xx + self.yy) / 4,
              1e-14 * self.xx);
}

/// Betti: q.Ap = p.Aq; and the elastic energy p.Ap/2 is positive.
TEST(SurfaceResponse, IsReciprocalAndPositive) {
  for (const ElementGrid& grid : grids()) {
    SCOPED_TRACE(text(grid));
    NormalOperator normal(steel, grid);
    for (unsigned seed = 1; seed < 6; ++seed) {
      const Field px = random_tractions(grid, seed), py = random_tractions(grid, seed + 10);
      const Field qx = random_tractions(grid, seed + 20), qy = random_tractions(grid, seed + 30);
      const PlaneFields u = apply(TangentialOperator::displacement(steel, grid), px, py);
      const PlaneFields v = apply(TangentialOperator::displacement(steel, grid), qx, qy);
      const double energy = dot(px, u.x) + dot(py, u.y);
      EXPECT_GT(energy, 0);
      EXPECT_NEAR(dot(qx, u.x) + dot(qy, u.y), dot(px, v.x) + dot(py, v.y), 1e-12 * energy);
      Field w(px.size()), z(px.size());
      normal.apply(px, w);
      normal.apply(qx, z);
      EXPECT_GT(dot(px, w), 0);
      EXPECT_NEAR(dot(qx, w), dot(px, z), 1e-12 * dot(px, w));
    }
  }
}

double rate_of_work(const CombinedMaterial& material, const ElementGrid& grid, double step, const Field& px,
                    const Field& py) {
  const PlaneFields difference = apply(TangentialOperator::difference(material, grid, step), px, py);
  return dot(px, difference.x) + dot(py, difference.y);
}

/// p.Dp >= 0 although D is not symmetric, for steps of whole elements: a wave of number k is multiplied by the
/// transform of A, which is positive, and by 1 - exp(i k dq).
TEST(SurfaceResponse, GrowthIsPositiveForWholeElements) {
  for (const ElementGrid& grid : grids())
    for (const int elements : {1, -1, 2, 5})
      for (unsigned seed = 1; seed < 6; ++seed)
        EXPECT_GT(rate_of_work(steel, grid, elements * grid.dx, random_tractions(grid, seed),
                               random_tractions(grid, seed + 10)),
                  0)
            << text(grid) << ", step " << elements;
}

/// For shorter steps it need not be: a chessboard of lateral tractions on elements that are long in rolling direction.
TEST(SurfaceResponse, GrowthIsNotPositiveForShortStepsOnLongElements) {
  const CombinedMaterial rubber{1e6, 0.45, 0};
  const ElementGrid grid = rectangles(12, 12, 3e-3, 1e-3);
  Field board(grid.count()), none(grid.count(), 0.0);
  for (std::size_t k = 0; k < board.size(); ++k) board[k] = (k / 12 + k % 12) % 2 == 0 ? 1 : -1;
  EXPECT_LT(rate_of_work(rubber, grid, 0.1 * grid.dx, none, board), 0);
  EXPECT_GT(rate_of_work(rubber, grid, 0.6 * grid.dx, none, board), 0);
}

TEST(SurfaceResponse, CountsItsProductsAndCanBeMoved) {
  const ElementGrid grid = rectangles(6, 4);
  const Field px = random_tractions(grid, 1), py = random_tractions(grid, 2);
  TangentialOperator response = TangentialOperator::difference(steel, grid, grid.dx);
  const PlaneFields exact = apply(TangentialOperator::difference(steel, grid, grid.dx), px, py);
  Field sx(px.size()), sy(px.size());
  for (int k = 0; k < 3; ++k) response.apply(px, py, sx, sy);
  EXPECT_EQ(response.products(), 3);
  TangentialOperator moved(std::move(response));
  moved.apply(px, py, sx, sy);
  EXPECT_EQ(moved.products(), 4);
  EXPECT_EQ(sx, exact.x);
  EXPECT_EQ(sy, exact.y);
  NormalOperator normal(steel, grid);
  normal.apply(px, sx);
  EXPECT_EQ(normal.products(), 1);
}

TEST(SurfaceResponse, DistinctObjectsInDistinctThreads) {
  std::array<Field, 2> alone, together;
  const auto work = [](unsigned thread, Field& u) {
    for (int round = 0; round < 10; ++round) {
      const ElementGrid grid = rectangles(10 + static_cast<int>(thread), 9);
      const Field px = random_tractions(grid, thread), py = random_tractions(grid, 7);
      u = apply(TangentialOperator::difference(steel, grid, grid.dx), px, py).x;
    }
  };
  for (unsigned t = 0; t < 2; ++t) work(t, alone[t]);
  std::thread first(work, 0U, std::ref(together[0])), second(work, 1U, std::ref(together[1]));
  first.join();
  second.join();
  EXPECT_EQ(alone, together);
}

TEST(SurfaceResponse, RefusesGridsThatMakeNoSense) {
  for (const double bad : {0.0, -1e-3, nan}) {
    EXPECT_THROW(NormalOperator(steel, rectangles(3, 3, bad)), Error);
    EXPECT_THROW(TangentialOperator::difference(steel, rectangles(3, 3, 1e-3, bad), 1e-3), Error);
  }
  EXPECT_THROW(NormalOperator(steel, rectangles(0, 3)), Error);
  EXPECT_THROW(TangentialOperator::displacement(steel, rectangles(3, -1)), Error);
  ElementGrid rows = strips(4);
  rows.my = 2;
  expect_error([&] { NormalOperator(steel, rows); }, "grid.my of a line contact", "[-]: must be in [1, 1]");
}

/// Pressure of one patch displaces the other's surface along the normal by the factor; all else is as without patches.
TEST(CoupledOperator, PatchesFactorsWeighWhatPressureDoesAlongTheNormal) {
  const ElementGrid g{.mx = 5, .my = 6, .x0 = 0, .y0 = 0, .dx = 1e-3, .dy = 0.8e-3};
  const Bodies bodies(combine({80e9, 0.3}, {30e9, 0.2}));
  ElementResponse response;
  response.patches = {.count = 2, .patch_of_row = {0, 0, 1, 1, 1, 1}, .factors = {1, 0.3, 0.3, 1}};
  using Fields = std::array<std::vector<double>, 3>;
  const auto product = [&](CoupledOperator op, const Fields& p) {
    Fields u;
    for (auto& field : u) field.resize(g.count());
    op.apply({p[0], p[1], p[2]}, std::array{std::span(u[0]), std::span(u[1]), std::span(u[2])});
    return u;
  };
  constexpr std::size_t of_first_patch = 10; // elements, in two rows
  Fields p, first;
  for (auto* fields : {&p, &first})
    for (auto& field : *fields) field.resize(g.count());
  for (std::size_t k = 0; k < g.count(); ++k) {
    p[0][k] = std::sin(1.0 + double(k));
    p[1][k] = std::cos(3.0 * double(k));
    p[2][k] = 1 + std::sin(double(k));
    if (k < of_first_patch) first[2][k] = p[2][k];
  }
  const Fields plain = product(CoupledOperator::displacement(bodies, g), p);
  const Fields of_first = product(CoupledOperator::displacement(bodies, g), first);
  Fields second = {first[0], first[1], p[2]};
  for (std::size_t k = 0; k < of_first_patch; ++k) second[2][k] = 0;
  const Fields of_second = product(CoupledOperator::displacement(bodies, g), second);
  const Fields found = product(CoupledOperator::displacement(bodies, g, {}, 1, {}, response), p);
  const double tolerance = 1e-13;
  for (std::size_t k = 0; k < g.count(); ++k) {
    EXPECT_EQ(found[0][k], plain[0][k]);
    EXPECT_EQ(found[1][k], plain[1][k]);
    const double other = k < of_first_patch ? of_second[2][k] : of_first[2][k];
    EXPECT_NEAR(found[2][k], plain[2][k] - 0.7 * other, tolerance * std::abs(plain[2][k]));
  }
}

} // namespace
} // namespace microslip
