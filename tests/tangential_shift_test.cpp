#include "tangential_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>

namespace microslip {
namespace {

using std::numbers::pi;

/// Sphere under 7/8 of the sliding force (Johnson 1985, section 7.2). Cattaneo's and Mindlin's solution is exact for
/// nu = 0, where tractions along x move the surface along x only.
struct Cattaneo {
  double radius = 1e-3, share = 0.875;
  Problem problem;
  double shift, energy, work; ///< closed forms

  Cattaneo(double poisson_ratio, int n) {
    const CombinedMaterial material{200e6, poisson_ratio, 0};
    const HertzContact hertz = hertz_from_ellipse(radius, radius, material, 9.1954);
    const double mu = 0.4;
    problem = with_gap(material, ElementGrid::across_ellipse(radius, radius, n, 2), hertz.gap, hertz.normal_force, mu,
                       radius);
    const double whole =
        3 * problem.capacity * (2 - poisson_ratio) / (8 * radius * material.shear_modulus); // shift at full sliding
    const double rest = 1 - share, fraction = 1 - std::pow(rest, 2.0 / 3);
    shift = whole * fraction;
    // Work done by the force, the integral of F over the shift
    const double by_force = problem.capacity * whole * (fraction - 0.4 * (1 - std::pow(rest, 5.0 / 3)));
    const double product = share * problem.capacity * shift;
    energy = product - by_force;
    work = 2 * by_force - product;
  }

  TangentialInput input() const {
    TangentialInput input;
    input.motion = ContactMotion::shift;
    input.force_x = -share * problem.capacity;
    input.force_y = 0;
    input.tolerance = 1e-9;
    return input;
  }
};

TEST(TangentialShift, CattaneoShiftIsOfSecondOrder) {
  for (const int n : {10, 20, 40}) {
    SCOPED_TRACE(n);
    const Cattaneo c(0, n);
    const ContactSolution s = solve(c.problem, c.input());
    ASSERT_EQ(s.report.status, Status::ok);
    // The rim of the adhesion area passes through elements, so that errors jitter about second order.
    EXPECT_NEAR(s.creepage.longitudinal, c.shift, 0.3 / (n * n) * c.shift);
    EXPECT_NEAR(s.creepage.lateral, 0, 1e-9 * c.shift);
    EXPECT_NEAR(s.totals.elastic_energy, c.energy, 0.3 / (n * n) * c.energy);
    EXPECT_NEAR(s.totals.frictional_power, c.work, 2.0 / (n * n) * c.work);
    const double radius = std::sqrt(s.totals.adhesion_area / pi);
    EXPECT_NEAR(radius, 0.5 * c.radius, 0.6 / n * c.radius);
    EXPECT_NEAR(s.totals.fx, -c.share * c.problem.capacity, 1e-9 * c.problem.capacity);
  }
}

/// In adhesion p = -mu p0 (sqrt(1 - r^2) - c sqrt(1 - r^2/c^2)), c = 1/2, with r in units of the contact's radius.
TEST(TangentialShift, CattaneoTractions) {
  const Cattaneo c(0, 40);
  const ContactSolution s = solve(c.problem, c.input());
  const double peak = 1.5 * c.problem.capacity / (pi * c.radius * c.radius);
  const ElementGrid& grid = c.problem.grid;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      const double r2 = (grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / (c.radius * c.radius);
      const double p = std::sqrt(std::max(0.0, 1 - r2)) - 0.5 * std::sqrt(std::max(0.0, 1 - 4 * r2));
      EXPECT_NEAR(s.fields.traction.x[k] / peak, -p, r2 < 0.8 ? 0.02 : 0.08);
      EXPECT_NEAR(s.fields.traction.y[k] / peak, 0, 1e-6);
      if (r2 < 0.2) {
        EXPECT_EQ(s.fields.state[k], CellState::adhesion);
      } else if (r2 > 0.3 && r2 < 0.95) {
        EXPECT_EQ(s.fields.state[k], CellState::slip);
      }
    }
}

/// For nu = 0.42 Mindlin's shift is an approximation; CONTACT's printed figures for the same 15 elements (User guide,
/// section 5.1): approach, shift, work, energy less that of the normal problem, elements.
TEST(TangentialShift, CattaneoAsContactPrintsIt) {
  const Cattaneo c(0.42, 15);
  const ContactSolution s = solve(c.problem, c.input());
  EXPECT_NEAR(s.creepage.longitudinal, 8.155e-6, 0.0005e-6);
  EXPECT_NEAR(s.totals.frictional_power, 2.750e-6, 0.0005e-6);
  EXPECT_NEAR(s.totals.elastic_energy, 8.525e-5 - 7.350e-5, 0.001e-5);
  EXPECT_NEAR(s.totals.adhesion_area / c.problem.grid.element_area(), 45, 1e-9);
  EXPECT_NEAR(s.totals.slip_area / c.problem.grid.element_area(), 132, 1e-9);
}

/// Unloading from the force F1 to F2 (Johnson 1985, equation (7.50)): the path counts, not the force.
TEST(TangentialShift, UnloadingFollowsMindlinAndDeresiewicz) {
  const Cattaneo c(0, 30);
  TangentialProblem problem(c.problem.material, c.problem.grid);
  TangentialInput input = c.input();
  ContactSolution s = problem.solve(c.problem.bound, input);
  const double whole = c.shift / (1 - std::pow(1 - c.share, 2.0 / 3));
  double total = s.creepage.longitudinal;
  for (const double share : {0.4, 0.0, -0.5}) {
    SCOPED_TRACE(share);
    const VectorField before = s.fields.traction;
    input.previous = input.start = &before;
    input.force_x = -share * c.problem.capacity;
    s = problem.solve(c.problem.bound, input);
    ASSERT_EQ(s.report.status, Status::ok);
    total += s.creepage.longitudinal;
    const double power = 2.0 / 3, down = 1 - std::pow(1 - (c.share - share) / 2, power);
    EXPECT_NEAR(total, c.shift - 2 * whole * down, 1e-3 * whole);
  }
}

/// A shift in two parts is the whole one while slip keeps its direction.
TEST(TangentialShift, TwoHalfShiftsAreAWholeOne) {
  const Cattaneo c(0, 15);
  TangentialInput input;
  input.motion = ContactMotion::shift;
  input.tolerance = 1e-10;
  input.creepage.longitudinal = c.shift;
  const ContactSolution whole = solve(c.problem, input);
  input.creepage.longitudinal = c.shift / 2;
  const ContactSolution half = solve(c.problem, input);
  input.previous = &half.fields.traction;
  const ContactSolution second = solve(c.problem, input);
  EXPECT_GT(std::abs(second.totals.fx), std::abs(half.totals.fx));
  EXPECT_NEAR(second.totals.fx, whole.totals.fx, 1e-8 * c.problem.capacity);
  EXPECT_NEAR(second.totals.elastic_energy, whole.totals.elastic_energy, 1e-7 * whole.totals.elastic_energy);
}

/// A shift from no tractions: w = s - u, so -p.w is twice the elastic energy and the work of friction.
TEST(TangentialShift, EnergyBalanceOfAShift) {
  const Problem p = elliptic(steel_contact(1), 12, 12);
  TangentialInput input;
  input.motion = ContactMotion::shift;
  input.tolerance = 1e-11;
  input.creepage = {1e-5, -5e-6, 1e-3};
  const ContactSolution s = solve(p, input);
  EXPECT_GT(s.totals.frictional_power, 0);
  EXPECT_GT(s.totals.elastic_energy, 0);
  EXPECT_NEAR(s.totals.power_by_creepage, 2 * s.totals.elastic_energy + s.totals.frictional_power,
              1e-9 * s.totals.power_by_creepage);
}

/// By the near inverse of the displacements: without it products grow with the grid, and steps where adhesion is told
/// from slip by an element's displacement.
TEST(TangentialShift, StepsAndProductsHardlyGrowWithTheGrid) {
  for (const bool by_force : {false, true})
    for (const int n : {16, 32, 64, 128}) {
      SCOPED_TRACE(std::to_string(n) + (by_force ? ", forces given" : ", shift given"));
      const Cattaneo c(0.28, n);
      TangentialInput input = c.input();
      if (!by_force) {
        input.force_x = input.force_y = std::nullopt;
        input.creepage = {c.shift, 0.3 * c.shift, 0.4 * c.shift / c.radius};
      }
      const ContactSolution s = solve(c.problem, input);
      EXPECT_EQ(s.report.status, Status::ok);
      EXPECT_LE(s.report.residual, input.tolerance);
      EXPECT_LE(s.report.newton_steps, 16);
      EXPECT_LE(s.report.products, 60);
    }
}

/// Where the elements lie does not matter to what is kept of them.
TEST(TangentialShift, OfElementsThatAreMoved) {
  const Cattaneo c(0.28, 12);
  TangentialInput input = c.input();
  input.force_x = input.force_y = std::nullopt;
  input.creepage = {c.shift, 0, c.shift / c.radius};
  ElementGrid elsewhere = c.problem.grid;
  elsewhere.x0 += 0.3 * c.radius, elsewhere.y0 -= 0.2 * c.radius;
  TangentialProblem there(c.problem.material, elsewhere), moved(c.problem.material, c.problem.grid);
  moved.move_to(elsewhere.x0, elsewhere.y0);
  const ContactSolution a = there.solve(c.problem.bound, input), b = moved.solve(c.problem.bound, input);
  EXPECT_EQ(a.fields.traction.x, b.fields.traction.x);
  EXPECT_EQ(a.totals.mz, b.totals.mz);
}

} // namespace
} // namespace microslip
