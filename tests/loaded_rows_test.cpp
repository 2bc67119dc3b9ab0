#include "microslip/simplified/loaded_rows.hpp"

#include "microslip/simplified/fastsim2.hpp"
#include "tests/support/expect_close.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace microslip {
namespace {

constexpr double shear_modulus = 82e9, poisson_ratio = 0.28;
constexpr double a = 6e-3, b = 4e-3, load = 60e3, friction = 0.3;

/// The rows of an ellipse with Hertz's pressure, all moving as one body.
std::vector<LoadedRow> ellipse(int n, const Creepage& w, double x0 = 0, double y0 = 0) {
  std::vector<LoadedRow> rows;
  for (int j = 0; j < n; ++j) {
    const double t = (2 * j + 1.0) / n - 1, y = y0 + b * t, length = std::sqrt(1 - t * t);
    rows.push_back({.y = y,
                    .width = 2 * b / n,
                    .centre = x0,
                    .half_length = a * length,
                    .load = load * 0.75 * (1 - t * t) * 2 / n,
                    .friction = friction,
                    .creepage = {w.longitudinal - w.spin * (y - y0), w.lateral - w.spin * x0, w.spin}});
  }
  return rows;
}

ContactForces total(const std::vector<LoadedRow>& rows) {
  LoadedRowSolver solver(16, static_cast<int>(rows.size()));
  std::vector<RowForces> forces(rows.size());
  solver.solve(shear_modulus, poisson_ratio, rows, forces);
  ContactForces sum;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    sum.fx += forces[j].fx, sum.fy += forces[j].fy;
    sum.mz += forces[j].mz - rows[j].y * forces[j].fx;
    sum.slip_area += forces[j].slip_area;
  }
  return sum;
}

TEST(LoadedRows, LieBetweenTheBoundsOfFastsim2OnAnEllipse) {
  for (const Creepage w : {Creepage{5e-4, 0, 0}, Creepage{3e-4, -4e-4, 0}, Creepage{2e-4, 1e-4, 0.2}}) {
    EllipticContact contact{.a = a,
                            .b = b,
                            .shear_modulus = shear_modulus,
                            .poisson_ratio = poisson_ratio,
                            .normal_force = load,
                            .friction = FrictionLaw::coulomb(friction),
                            .creepage = w};
    const auto by = [&](TractionBound bound) {
      const SimplifiedOptions options{.mx = 16, .my = 40, .bound = bound, .flexibility = FlexibilityModel::blended};
      return std::hypot(Fastsim2(options).solve(contact).fx, Fastsim2(options).solve(contact).fy);
    };
    const ContactForces rows = total(ellipse(40, w));
    const double size = std::hypot(rows.fx, rows.fy);
    EXPECT_GT(size, by(TractionBound::parabolic) * 0.999);
    EXPECT_LT(size, by(TractionBound::elliptic) * 1.001);
  }
}

TEST(LoadedRows, GiveAllOfFrictionInFullSliding) {
  const auto rows = ellipse(11, {1, 0, 0});
  const double bears = std::accumulate(rows.begin(), rows.end(), 0.0,
                                       [](double sum, const LoadedRow& row) { return sum + row.load * row.friction; });
  const ContactForces f = total(rows);
  EXPECT_NEAR(f.fx, -bears, 1e-10 * bears);
}

TEST(LoadedRows, DoNotDependOnWhereTheContactIs) {
  const Creepage w{2e-4, 1e-4, 0.2};
  const ContactForces here = total(ellipse(12, w)), there = total(ellipse(12, w, 3e-3, -0.7));
  expect_forces({there.fx, there.fy, there.mz - 3e-3 * there.fy - 0.7 * there.fx}, here, 1e-9 * load);
}

TEST(LoadedRows, CarryNothingWithoutLoad) {
  auto rows = ellipse(12, {2e-4, 1e-4, 0.2});
  const ContactForces without = total(rows);
  rows.push_back({.y = 0.1, .width = 1e-3, .half_length = 1e-3, .load = 0, .friction = friction});
  const ContactForces with = total(rows);
  EXPECT_EQ(with.fx, without.fx);
  for (LoadedRow& row : rows) row.load = 0;
  EXPECT_EQ(total(rows).fy, 0);
}

// What the cells have adds up to what the rows have, wherever the contact is and in whichever direction it rolls.
TEST(LoadedRows, HaveFieldsThatAddUp) {
  for (const RollingDirection direction : {RollingDirection::forward, RollingDirection::backward})
    for (const Creepage w : {Creepage{5e-4, 0, 0}, Creepage{3e-4, -4e-4, 0}, Creepage{2e-4, 1e-4, 0.2}}) {
      auto rows = ellipse(12, w, 3e-3, -0.2);
      rows[3].friction = 0.2, rows[11].load = 0;
      LoadedRowSolver solver(16, 12, direction);
      std::vector<RowForces> forces(rows.size());
      solver.solve(shear_modulus, poisson_ratio, rows, forces);
      const ContactSolution s = solver.solve_with_fields(shear_modulus, poisson_ratio, rows, 2);
      ContactForces sum;
      double normal = 0, power = 0;
      for (std::size_t j = 0; j < rows.size(); ++j) {
        const RowForces& f = forces[j];
        const Creepage& c = rows[j].creepage;
        sum.fx += f.fx, sum.fy += f.fy, sum.mz += f.mz - rows[j].y * f.fx;
        if (rows[j].load > 0) sum.slip_area += f.slip_area;
        power -= 2 * (c.longitudinal * f.fx + c.lateral * f.fy + c.spin * f.mz);
        double of_row = 0;
        for (int i = 0; i < 16; ++i) {
          const std::size_t k = s.elements.index(i, static_cast<int>(j));
          of_row += s.fields.pressure[k] * s.elements.area[k];
          EXPECT_EQ(s.fields.state[k] == CellState::exterior, rows[j].load == 0);
          EXPECT_LE(std::abs(s.elements.x[k] - rows[j].centre), rows[j].half_length);
          EXPECT_EQ(s.elements.y[k], rows[j].y);
          EXPECT_NEAR(s.elements.grid.y(static_cast<int>(j)), rows[j].y, 1e-15);
          if (s.fields.state[k] != CellState::slip) continue;
          EXPECT_NEAR(std::hypot(s.fields.traction.x[k], s.fields.traction.y[k]), s.fields.bound[k],
                      1e-12 * s.fields.bound[k]);
        }
        EXPECT_NEAR(of_row, rows[j].load, 1e-12 * load);
        normal += of_row;
      }
      expect_forces(s.totals, sum, 1e-12 * load);
      EXPECT_NEAR(s.totals.slip_area, sum.slip_area, 1e-12 * a * b);
      EXPECT_NEAR(s.totals.frictional_power, power, 1e-10 * power);
      EXPECT_GT(normal, 0);
    }
}

// A particle of a row that slides slips by the creepage.
TEST(LoadedRows, SlipByTheCreepageInFullSliding) {
  LoadedRowSolver solver(16, 11);
  const ContactSolution s = solver.solve_with_fields(shear_modulus, poisson_ratio, ellipse(11, {0.3, -0.4, 0}), 1);
  for (std::size_t k = 0; k < s.elements.size(); ++k) {
    ASSERT_EQ(s.fields.state[k], CellState::slip);
    EXPECT_NEAR(s.fields.slip.x[k], 0.3, 0.01);
    EXPECT_NEAR(s.fields.slip.y[k], -0.4, 0.01);
  }
}

} // namespace
} // namespace microslip
