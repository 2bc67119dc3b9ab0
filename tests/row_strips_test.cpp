// The strips that tell the theory table what a patch's shape changes.

#include "microslip/railway/rows/row_strips.hpp"

#include "microslip/simplified/creepage_coefficients.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace microslip {
namespace {

constexpr double a = 6e-3, b = 4e-3, mu = 0.3, load = 60e3, capacity = mu * load;
const double c = std::sqrt(a * b);

/// Rows of an ellipse whose middles lie on x = slant y, moving as one plane body.
std::vector<LoadedRow> ellipse_rows(int count, double slant, const Creepage& at_centre) {
  std::vector<LoadedRow> rows;
  const double width = 2 * b / count;
  for (int k = 0; k < count; ++k) {
    const double y = -b + (k + 0.5) * width, rest = 1 - y * y / (b * b);
    rows.push_back({.y = y,
                    .width = width,
                    .centre = slant * y,
                    .half_length = a * std::sqrt(rest),
                    .load = 0.75 * load * rest * width / b,
                    .friction = mu,
                    .creepage = {at_centre.longitudinal - at_centre.spin * y, at_centre.lateral, at_centre.spin}});
  }
  return rows;
}

RowForces total(const RowStrips& strips, const std::vector<LoadedRow>& rows) {
  double stiffness = 0;
  for (const LoadedRow& row : rows) stiffness += strips.stiffness(row);
  RowForces sum;
  for (const LoadedRow& row : rows) {
    const RowForces f = strips.row(row, stiffness);
    sum.fx += f.fx, sum.fy += f.fy, sum.mz += f.mz - row.y * f.fx;
  }
  return sum;
}

TEST(RowStrips, RowsOfAnEllipseBearWhatItsStripsDo) {
  const Creepage creepages[] = {{1e-3, 0, 0}, {-3e-4, 8e-4, 0.2}, {2e-4, -5e-4, -0.8}, {1e-4, -1e-4, 1.5}};
  for (const double slant : {0.0, 0.3})
    for (const Creepage& w : creepages) {
      const RowStrips strips(steel, {.a = a, .b = b, .slant = slant}, capacity);
      const RowForces rows = total(strips, ellipse_rows(400, slant, w)), ellipse = strips.ellipse(w);
      expect_forces(rows, ellipse, 1e-3 * capacity, 1e-3 * capacity * c);
    }
}

TEST(RowStrips, AnEllipseIsAsStiffAsLinearTheoryHasIt) {
  const auto coefficients = creepage_coefficients(a / b, steel.poisson_ratio, CreepageTable::computed);
  const RowStrips strips(steel, {.a = a, .b = b}, capacity);
  const double stiffness = steel.shear_modulus * a * b, small = 1e-9;
  EXPECT_NEAR(strips.ellipse({small, 0, 0}).fx, -stiffness * coefficients.c11 * small, 1e-6 * stiffness * small);
  // Its lateral force by spin has the ratio to that by lateral creepage of linear theory.
  const double by_lateral = strips.ellipse({0, small, 0}).fy, by_spin = strips.ellipse({0, 0, small / c}).fy;
  EXPECT_NEAR(by_spin / by_lateral, coefficients.c23 / coefficients.c22, 1e-6);
}

TEST(RowStrips, StripsThatSlideBearWhatFrictionDoes) {
  const Creepage w{0.6, 0.8, 0};
  const RowStrips strips(steel, {.a = a, .b = b}, capacity);
  const RowForces f = strips.ellipse(w);
  expect_forces(f, {-0.6 * capacity, -0.8 * capacity, 0}, 1e-5 * capacity, 1e-5 * capacity * c);
}

TEST(RowStrips, ASkewedLoadMakesAPatchStiffer) {
  const std::vector<LoadedRow> rows = ellipse_rows(40, 0, {1e-9, 0, 0});
  const double even = total(RowStrips(steel, {.a = a, .b = b}, capacity), rows).fx;
  for (const double skewness : {-1.0, 1.0}) {
    const double skew = total(RowStrips(steel, {.a = a, .b = b, .skewness = skewness}, capacity), rows).fx;
    EXPECT_NEAR(skew / even, 1.048, 1e-6);
  }
}

} // namespace
} // namespace microslip
