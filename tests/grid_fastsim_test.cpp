// FASTSIM on the rows of a grid: closed forms for a row, and FASTSIM on the rows of an ellipse.

#include "microslip/simplified/grid_fastsim.hpp"

#include "microslip/error.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/simplified/fastsim.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/steel.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr Flexibilities one = {2e-14, 2e-14, 2e-14}; // m/Pa
const std::vector<double> mu = {0.3};

ElementGrid grid_of(int mx, int my, double dx, double dy) {
  return {mx, my, -(mx - 1) * dx / 2, -(my - 1) * dy / 2, dx, dy};
}

Field elliptic_pressure(const ElementGrid& grid, double a, double b, double force) {
  return over_grid(grid,
                   [=](double x, double y) { return traction_bound(TractionBound::elliptic, a, b, force, 1, x, y); });
}

/// Without slip px = -xi (distance from the leading edge)/L, and Fx = -xi dx^2 dy n(n + 1)/(2 L) for n elements.
TEST(GridFastsim, AdhesionIsLinear) {
  const ElementGrid grid = grid_of(10, 1, 1e-3, 2e-3);
  const std::vector<double> pressure(10, 1e12);
  for (const auto direction : {RollingDirection::forward, RollingDirection::backward}) {
    const bool forward = direction == RollingDirection::forward;
    const ContactSolution s =
        GridFastsim(grid, pressure).solve(one, mu, {.creepage = {1e-3, -2e-3, 0}, .direction = direction});
    for (int i = 0; i < 10; ++i) {
      const double n = forward ? 10 - i : i + 1;
      EXPECT_NEAR(s.fields.traction.x[i] / (-1e-3 * n * 1e-3 / 2e-14), 1, 1e-12);
      EXPECT_NEAR(s.fields.traction.y[i] / (2e-3 * n * 1e-3 / 2e-14), 1, 1e-12);
      EXPECT_EQ(s.fields.state[i], CellState::adhesion);
    }
    EXPECT_NEAR(s.totals.fx / (-1e-3 * 1e-6 * 2e-3 * 55 / 2e-14), 1, 1e-12);
    EXPECT_EQ(s.totals.frictional_power, 0);
    EXPECT_NEAR(s.totals.adhesion_area, 2e-5, 1e-18);
  }
}

/// With equal pressure the row adheres over mu p L/xi and slides behind, s = xi.
TEST(GridFastsim, SlidesWhereTheBoundIsReached) {
  const ElementGrid grid = grid_of(1000, 1, 1e-5, 1e-3);
  const double p = 1e9, xi = 2e-3, length = 0.3 * p * one.longitudinal / xi; // 3 mm
  const ContactSolution s =
      GridFastsim(grid, std::vector<double>(1000, p)).solve(one, mu, {.creepage = {xi, 0, 0}, .rolling_speed = 20});
  EXPECT_NEAR(s.totals.adhesion_area / 1e-3, length, 2e-5);
  EXPECT_NEAR(s.totals.fx, -0.3 * p * 1e-3 * (0.01 - length / 2), 2);
  EXPECT_DOUBLE_EQ(s.fields.slip.x[0], xi);
  EXPECT_NEAR(s.totals.frictional_power, 20 * xi * 0.3 * p * 1e-3 * (0.01 - length), 0.1);
  EXPECT_NEAR(s.totals.peak_traction, 0.3 * p, 1);
}

/// Each run of elements begins anew, wherever it lies.
TEST(GridFastsim, RunsAreIndependent) {
  const ElementGrid grid = grid_of(7, 2, 1e-3, 1e-3);
  const std::vector<double> pressure = {0, 1e9, 1e9, 0, 0, 1e9, 1e9, 0, 0, 0, 1e9, 0, 0, 0};
  const GridFastsim fastsim(grid, pressure);
  ASSERT_EQ(fastsim.runs().size(), 3U);
  EXPECT_EQ(fastsim.runs()[1].first, 5);
  EXPECT_EQ(fastsim.runs()[2].row, 1);
  const ContactSolution s = fastsim.solve(one, mu, {.creepage = {1e-3, 0, 0}});
  EXPECT_EQ(s.fields.traction.x[2], s.fields.traction.x[6]);
  EXPECT_EQ(s.fields.traction.x[1], s.fields.traction.x[5]);
  EXPECT_EQ(s.fields.traction.x[6], s.fields.traction.x[10]);
  EXPECT_EQ(s.fields.state[3], CellState::exterior);
  EXPECT_EQ(s.fields.traction.x[3], 0);
  EXPECT_NEAR(fastsim.contact_area(), 5e-6, 1e-18);
  EXPECT_NEAR(fastsim.capacity(mu), 0.3 * 5e3, 1e-9);
  const std::vector<double> by_row = {0.3, 0.1};
  EXPECT_NEAR(fastsim.capacity(by_row), 0.3 * 4e3 + 0.1 * 1e3, 1e-9);
  EXPECT_DOUBLE_EQ(fastsim.solve(one, by_row, {}).fields.bound[10], 0.1 * 1e9);
}

/// The sums tend to those of FASTSIM on the rows of the ellipse, for spin and all three flexibilities as well.
TEST(GridFastsim, TendsToFastsimOnAnEllipse) {
  EllipticContact contact = steel_contact(6e-3, 4e-3, 8e4, {6e-4, -8e-4, 0.3});
  contact.rolling_speed = 10;
  for (const auto direction : {RollingDirection::forward, RollingDirection::backward}) {
    SimplifiedOptions options;
    options.mx = options.my = 400;
    options.bound = TractionBound::elliptic;
    options.direction = direction;
    const ContactForces own = Fastsim(options).solve(contact);
    const ElementGrid grid = ElementGrid::across_ellipse(contact.a, contact.b, 400);
    const Flexibilities l = flexibilities(FlexibilityModel::three, {}, contact);
    const ContactSolution s = GridFastsim(grid, elliptic_pressure(grid, contact.a, contact.b, contact.normal_force))
                                  .solve(l, mu, {.creepage = contact.creepage, .direction = direction});
    const double limit = 2.4e4;
    expect_forces({s.totals.fx / limit, s.totals.fy / limit, s.totals.mz / (limit * 5e-3)},
                  {own.fx / limit, own.fy / limit, own.mz / (limit * 5e-3)}, 1e-3);
    EXPECT_NEAR(s.totals.slip_area / own.slip_area, 1, 0.01);
  }
}

/// The centre of spin moves the creepages; slip given to each element is as good as a creepage.
TEST(GridFastsim, RigidSlip) {
  const ElementGrid grid = grid_of(20, 16, 5e-4, 5e-4);
  const GridFastsim fastsim(grid, elliptic_pressure(grid, 5e-3, 4e-3, 5e4));
  const auto expect_same = [](const ContactSolution& a, const ContactSolution& b) {
    expect_forces(a.forces(), b.forces(), 1e-6, 1e-8);
    EXPECT_GT(std::abs(a.totals.fx), 10);
  };
  const ContactSolution moved = fastsim.solve(one, mu, {.creepage = {1e-3, 2e-3, 0.4}, .spin_centre = {2e-3, -1e-3}});
  const ContactSolution shifted = fastsim.solve(one, mu, {.creepage = {1e-3 - 0.4e-3, 2e-3 - 0.8e-3, 0.4}});
  expect_same(moved, shifted);
  EXPECT_NEAR(moved.creepage.longitudinal, shifted.creepage.longitudinal, 1e-15);
  EXPECT_NEAR(moved.creepage.lateral, shifted.creepage.lateral, 1e-15);
  EXPECT_NEAR(moved.totals.power_by_creepage / shifted.totals.power_by_creepage, 1, 1e-9);
  const std::vector<double> x(grid.count(), 4e-4), y(grid.count(), -3e-4);
  const ContactSolution extra = fastsim.solve(one, mu, {.creepage = {6e-4, 2e-3, 0.4}, .extra_x = x, .extra_y = y});
  expect_same(extra, fastsim.solve(one, mu, {.creepage = {1e-3, 1.7e-3, 0.4}}));
  const ContactSolution no_x =
      fastsim.solve(one, mu, {.creepage = {1e-3, 0, 0.4}, .spin_in_x = false, .spin_in_y = false});
  expect_same(no_x, fastsim.solve(one, mu, {.creepage = {1e-3, 0, 0}}));
  const ContactSolution ahead = fastsim.solve(one, mu, {.creepage = {1e-3, 0, 0.4}, .ahead = {1e-3, 0}});
  expect_same(ahead, fastsim.solve(one, mu, {.creepage = {1e-3, 0.4e-3, 0.4}}));
}

/// Steps of an element's length, each from the one before moved by an element, end in steady rolling.
TEST(GridFastsim, TransientRollingBecomesSteady) {
  const ElementGrid grid = grid_of(12, 8, 1e-3, 1e-3);
  const GridFastsim fastsim(grid, elliptic_pressure(grid, 6e-3, 4e-3, 5e4));
  const GridRolling steady = {.creepage = {1e-3, -5e-4, 0.2}};
  VectorField springs;
  ContactSolution s;
  for (int step = 0; step < 12; ++step) {
    GridRolling rolling = steady;
    rolling.before = &springs;
    rolling.step = grid.dx;
    s = fastsim.solve(one, mu, rolling);
    VectorField moved = {std::vector<double>(grid.count()), std::vector<double>(grid.count())};
    for (std::size_t k = 0; k + 1 < grid.count(); ++k) {
      if ((k + 1) % grid.mx == 0) continue; // particles that enter
      moved.x[k] = s.fields.displacement.x[k + 1];
      moved.y[k] = s.fields.displacement.y[k + 1];
    }
    springs = moved;
  }
  const ContactSolution end = fastsim.solve(one, mu, steady);
  EXPECT_EQ(s.fields.traction.x, end.fields.traction.x);
  EXPECT_EQ(s.fields.slip.y, end.fields.slip.y);
  EXPECT_GT(end.totals.slip_area, 0);
}

TEST(GridFastsim, FullSlidingTakesAllThatFrictionBears) {
  const ElementGrid grid = grid_of(20, 16, 5e-4, 5e-4);
  const GridFastsim fastsim(grid, elliptic_pressure(grid, 5e-3, 4e-3, 5e4));
  const ContactSolution s = fastsim.slide(one, mu, {0.6, -0.8});
  EXPECT_NEAR(s.totals.fx / (0.6 * fastsim.capacity(mu)), 1, 1e-12);
  EXPECT_NEAR(s.totals.fy / (-0.8 * fastsim.capacity(mu)), 1, 1e-12);
  EXPECT_EQ(s.totals.adhesion_area, 0);
  EXPECT_NEAR(s.totals.mz, 0, 1e-9);
  EXPECT_DOUBLE_EQ(s.fields.displacement.x[8 * 20 + 10], one.longitudinal * s.fields.traction.x[8 * 20 + 10]);
  double energy = 0; // of the springs
  for (std::size_t k = 0; k < grid.count(); ++k)
    energy +=
        0.5 * grid.element_area() *
        (one.longitudinal * std::pow(s.fields.traction.x[k], 2) + one.lateral * std::pow(s.fields.traction.y[k], 2));
  EXPECT_NEAR(s.totals.elastic_energy, energy, 1e-12 * energy);
}

TEST(GridFastsim, EquivalentEllipse) {
  const ElementGrid grid = grid_of(300, 200, 5e-5, 5e-5);
  const Vec2 axes = GridFastsim(grid, elliptic_pressure(grid, 6e-3, 4e-3, 5e4)).equivalent_axes();
  EXPECT_NEAR(axes.x / 6e-3, 1, 2e-3);
  EXPECT_NEAR(axes.y / 4e-3, 1, 2e-3);
}

TEST(GridFastsim, NamesInputOutOfRange) {
  const ElementGrid grid = grid_of(2, 3, 1e-3, 1e-3);
  const std::vector<double> pressure(6, 1e9), two(2), five(5);
  const GridFastsim fastsim(grid, pressure);
  const auto message = [&](const Flexibilities& l, const std::vector<double>& friction, const GridRolling& rolling) {
    return error_of([&] { fastsim.solve(l, friction, rolling); });
  };
  const VectorField none, wrong = {five, five}, uneven = {pressure, five};
  EXPECT_THROW(GridFastsim(grid, five), Error);
  EXPECT_THROW(GridFastsim(ElementGrid(), {}), Error);
  EXPECT_EQ(message({1e-14, -1, 1e-14}, mu, {}).find("flexibilities.lateral = -1 [m/Pa]"), 0U);
  EXPECT_EQ(message(one, two, {}), "friction: must have one value, or one for each of the 3 rows");
  EXPECT_EQ(message(one, mu, {.extra_y = five}), "extra_y: must have mx times my = 6 values");
  EXPECT_EQ(message(one, mu, {.before = &none}).find("step = 0 [m]"), 0U);
  EXPECT_EQ(message(one, mu, {.before = &wrong, .step = 1}), "before.x: must have mx times my = 6 values");
  EXPECT_EQ(message(one, mu, {.before = &uneven, .step = 1}), "before.y: must have as many values as before.x");
}

} // namespace
} // namespace microslip
