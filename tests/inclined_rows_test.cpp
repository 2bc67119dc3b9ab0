// Products for rows that are turned against one another: sums over pairs of elements, planes, reciprocity.

#include "microslip/exact/halfspace/offset_kernel.hpp"
#include "microslip/exact/halfspace/surface_operator.hpp"
#include "tests/support/expect_error.hpp"

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Field = std::vector<double>;
using Fields = std::array<Field, 3>;

const ElementGrid grid{.mx = 7, .my = 6, .x0 = -1e-3, .y0 = -2e-3, .dx = 0.4e-3, .dy = 0.6e-3};
const Bodies dissimilar(combine({80e9, 0.3}, {30e9, 0.2}));
const Bodies similar(combine({80e9, 0.28}, {80e9, 0.28}));

RowInclination turned(double share) {
  return {{-0.31, -0.2, 0.02, 0.1, 0.33, 0.4}, share};
}

Fields random_fields(unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> any(-1e6, 1e6);
  Fields p;
  for (Field& field : p)
    for (std::size_t k = 0; k < grid.count(); ++k) field.push_back(any(engine));
  return p;
}

Fields product(CoupledOperator op, const Fields& p) {
  Fields u;
  for (Field& field : u) field.resize(grid.count());
  op.apply({p[0], p[1], p[2]}, std::array{std::span(u[0]), std::span(u[1]), std::span(u[2])});
  return u;
}

CoupledOperator displacement(const Bodies& bodies, const RowInclination& inclination) {
  ElementResponse response;
  response.inclination = inclination;
  return CoupledOperator::displacement(bodies, grid, {}, 1, {}, response);
}

CoupledOperator difference(const Bodies& bodies, const RowInclination& inclination) {
  ElementResponse response;
  response.inclination = inclination;
  return CoupledOperator::difference(bodies, grid, {0.4e-3, 0}, {}, response);
}

using Vector = std::array<double, 3>;

/// R(angle) v.
Vector turn(double angle, const Vector& v) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {v[0], c * v[1] - s * v[2], s * v[1] + c * v[2]};
}

/// What a half-space's element does to a point at an offset.
Vector half_space(const Bodies& bodies, double x, double y, const Vector& p) {
  const Influence a = element_influence(bodies.material, grid, grid.dx, x, y);
  return {a.xx * p[0] + a.xy * p[1] + a.xz * p[2], a.xy * p[0] + a.yy * p[1] + a.yz * p[2],
          -a.xz * p[0] - a.yz * p[1] + a.zz * p[2]};
}

/// Sums over all pairs of elements; displacements at points `ahead` [m] further along x.
Fields by_pairs(const Bodies& bodies, const RowInclination& inclination, const Fields& p, double ahead) {
  const double c = inclination.traction_share;
  Fields u;
  for (Field& field : u) field.resize(grid.count());
  for (std::size_t k = 0; k < grid.count(); ++k)
    for (std::size_t l = 0; l < grid.count(); ++l) {
      const auto column = [](std::size_t e) { return static_cast<int>(e % grid.mx); };
      const auto row = [](std::size_t e) { return static_cast<int>(e / grid.mx); };
      const double alpha =
          inclination.angle[static_cast<std::size_t>(row(l))] - inclination.angle[static_cast<std::size_t>(row(k))];
      const double x = grid.x(column(k)) - grid.x(column(l)) + ahead, y = grid.y(row(k)) - grid.y(row(l));
      Vector own = turn((1 - c) * alpha, half_space(bodies, x, y, turn(c * alpha, {p[0][l], p[1][l], p[2][l]})));
      if (inclination.plane_along_x)
        own[0] = half_space(bodies, x, y, turn(c * alpha, {p[0][l], p[1][l], 0}))[0] +
                 half_space(bodies, x, y, {0, 0, p[2][l]})[0];
      for (std::size_t i = 0; i < 3; ++i) u[i][k] += own[i];
    }
  return u;
}

void expect_near(const Fields& a, const Fields& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) {
    double scale = 0;
    for (const double value : b[i]) scale = std::max(scale, std::abs(value));
    for (std::size_t k = 0; k < a[i].size(); ++k) ASSERT_NEAR(a[i][k], b[i][k], tolerance * scale) << i << " " << k;
  }
}

double work(const Fields& p, const Fields& u) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < p[i].size(); ++k) sum += p[i][k] * u[i][k];
  return sum;
}

TEST(InclinedRows, DisplacementsAreTheSumsOverPairsOfElements) {
  const Fields p = random_fields(1);
  for (const Bodies& bodies : {similar, dissimilar})
    for (const double share : {0.0, 0.5, 0.8, 1.0}) {
      SCOPED_TRACE(share);
      expect_near(product(displacement(bodies, turned(share)), p), by_pairs(bodies, turned(share), p, 0), 1e-12);
    }
}

TEST(InclinedRows, PressureMayActAlongXAsInAPlane) {
  const Fields p = random_fields(1);
  RowInclination inclination = turned(1);
  inclination.plane_along_x = true;
  for (const Bodies& bodies : {similar, dissimilar})
    expect_near(product(displacement(bodies, inclination), p), by_pairs(bodies, inclination, p, 0), 1e-12);
  Fields expected = by_pairs(dissimilar, inclination, p, 0);
  const Fields before = by_pairs(dissimilar, inclination, p, 0.4e-3);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < grid.count(); ++k) expected[i][k] = (expected[i][k] - before[i][k]) / 0.4e-3;
  expect_near(product(difference(dissimilar, inclination), p), expected, 1e-11);
}

/// The normal displacement stays one; slip is that of the tangential ones.
TEST(InclinedRows, SlipIsTheDifferenceOfDisplacementsInTheirOwnRow) {
  const Fields p = random_fields(2);
  for (const double share : {0.0, 0.5, 1.0}) {
    Fields expected = by_pairs(dissimilar, turned(share), p, 0);
    const Fields before = by_pairs(dissimilar, turned(share), p, 0.4e-3);
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < grid.count(); ++k) expected[i][k] = (expected[i][k] - before[i][k]) / 0.4e-3;
    expect_near(product(difference(dissimilar, turned(share)), p), expected, 1e-11);
  }
}

/// Whatever the angle of the plane.
TEST(InclinedRows, InOnePlaneAreAHalfSpaces) {
  const Fields p = random_fields(3);
  const Fields expected = product(CoupledOperator::displacement(dissimilar, grid), p);
  for (const double angle : {0.0, 0.7}) {
    const RowInclination plane{Field(6, angle), 0.5};
    expect_near(product(displacement(dissimilar, plane), p), expected, 1e-12);
  }
}

/// Only where traction and displacement are turned by half each is the work of one load on the other's displacements
/// the same in both directions.
TEST(InclinedRows, HalvesAreReciprocal) {
  const Fields p = random_fields(4), q = random_fields(5);
  const auto mismatch = [&](double share) {
    const double there = work(p, product(displacement(similar, turned(share)), q));
    const double back = work(q, product(displacement(similar, turned(share)), p));
    return std::abs(there - back) / std::sqrt(work(p, product(displacement(similar, turned(share)), p)) *
                                              work(q, product(displacement(similar, turned(share)), q)));
  };
  EXPECT_LT(mismatch(0.5), 1e-13);
  EXPECT_GT(mismatch(0), 1e-4);
  EXPECT_GT(mismatch(1), 1e-4);
}

/// Turning the load is the transpose of turning the displacement.
TEST(InclinedRows, LoadsAndDisplacementsTurnedAreTransposes) {
  const Fields p = random_fields(6), q = random_fields(7);
  const double load = work(p, product(displacement(dissimilar, turned(1)), q));
  const double displaced = work(q, product(displacement(dissimilar, turned(0)), p));
  EXPECT_NEAR(load / displaced, 1, 1e-12);
}

TEST(InclinedRows, BadInclinationsAreNamed) {
  const auto message = [](const RowInclination& inclination) {
    return error_of([&] { displacement(similar, inclination); });
  };
  EXPECT_NE(message({Field(5, 0.1), 0.5}).find("must have an angle for each of the 6 rows"), std::string::npos);
  EXPECT_NE(message({Field(6, NAN), 0.5}).find("inclination"), std::string::npos);
  EXPECT_NE(message({Field(6, 0.1), 1.5}).find("traction_share = 1.5"), std::string::npos);
}

} // namespace
} // namespace microslip
