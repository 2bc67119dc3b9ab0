#include "microslip/exact/fitted/patch_rolling.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/fitted/contact_edges.hpp"
#include "microslip/exact/fitted/pressure_curvature.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace microslip {
namespace {

using Gap = std::function<double(double, double)>;

constexpr double friction = 0.3, radius = 3e-3, load = 10e3, capacity = friction * load;

const HertzContact& hertz() {
  static const HertzContact contact = hertz_from_ellipse(radius, radius, steel, load);
  return contact;
}
double circular(double x, double y) {
  return hertz().gap.x * (x * x + y * y);
}
double egg(double x, double y) {
  return hertz().gap.x * (x * x * (1 + 0.15 * x / radius + 0.2 * y / radius) + y * y);
}
double side_by_side(double x, double y) {
  return std::min(circular(x, y - 1.5 * radius), circular(x, y + 1.5 * radius) + 2e-6);
}
double one_behind_the_other(double x, double y) {
  return side_by_side(y, x);
}

/// n elements over 2 radius, a centre at `x`, `y` elements from the origin.
ElementGrid grid_over(double half_x, double half_y, int n, double x, double y) {
  const double h = 2 * radius / n;
  const int nx = static_cast<int>(std::ceil(half_x / h)) + 5, ny = static_cast<int>(std::ceil(half_y / h)) + 2;
  return {.mx = 2 * nx + 1, .my = 2 * ny + 1, .x0 = (x - nx) * h, .y0 = (y - ny) * h, .dx = h, .dy = h};
}

PatchRolling rolling(const Gap& gap, const ElementGrid& grid, double force = load,
                     RollingDirection direction = RollingDirection::forward) {
  return {steel, grid, over_grid(grid, gap), {NormalLoad::Given::force, force}, direction};
}

PatchRollingMotion motion(double xi, double eta, double phi) {
  const double unit = friction * hertz().gap.x;
  return {.friction = friction, .creepage = {xi * unit * radius, eta * unit * radius, phi * unit}};
}
const PatchRollingMotion lengthwise = motion(1, 0, 0), mixed = motion(0.4, 0.6, 0.5);

constexpr std::pair<double, double> positions[] = {{0, 0}, {0.3, 0.2}, {0.6, 0.65}};

/// The root of the mean square, over positions of the patch on the grid, of the force's error over mu Fn.
double rms_error(const Gap& gap, double half_x, double half_y, double force, int n, const PatchRollingMotion& m,
                 Vec2 exact) {
  double sum = 0;
  for (const auto& [x, y] : positions) {
    const ContactSolution s = rolling(gap, grid_over(half_x, half_y, n, x, y), force).solve(m);
    EXPECT_EQ(s.report.status, Status::ok);
    sum += (std::pow(s.totals.fx - exact.x, 2) + std::pow(s.totals.fy - exact.y, 2)) / 3;
  }
  return std::sqrt(sum) / (friction * force);
}

Vec2 fine_forces(const Gap& gap, double half_x, double half_y, double force, const PatchRollingMotion& m) {
  const ContactSolution s = rolling(gap, grid_over(half_x, half_y, 72, 0.3, 0.2), force).solve(m);
  return {s.totals.fx, s.totals.fy};
}

TEST(PatchRolling, IsOfSecondOrderForHertz) {
  for (const PatchRollingMotion& m : {lengthwise, mixed}) {
    SecondOrderRolling exact_edges(steel, fit_ellipse(radius, radius, 96, 96));
    Field bound = exact_edges.contact().load_share;
    for (double& g : bound) g *= capacity;
    const SecondOrderSolution s = exact_edges.solve(
        bound, {.creepage = m.creepage, .force_x = {}, .force_y = {}, .start = {}, .tolerance = 1e-7});
    Vec2 exact{0, 0};
    for (std::size_t k = 0; k < bound.size(); ++k) {
      const double area = exact_edges.contact().elements[k].width() * exact_edges.contact().grid.dy;
      exact.x += s.friction.traction.x[k] * area;
      exact.y += s.friction.traction.y[k] * area;
    }
    const double coarse = rms_error(circular, radius, radius, load, 10, m, exact);
    const double fine = rms_error(circular, radius, radius, load, 40, m, exact);
    EXPECT_GT(std::log2(coarse / fine) / 2, 1.7);
    EXPECT_LT(fine, 6e-4);
  }
}

TEST(PatchRolling, FindsCartersForceOfCylinders) {
  constexpr double half_width = 1e-3, curvature = 1, adhesion = 0.4;
  const double line_load = line_contact_from_half_width(curvature, steel, half_width).force_per_length;
  const double creepage = 2 * curvature * friction * half_width * (1 - adhesion);
  const auto error = [&](int n) {
    double sum = 0;
    for (const double place : {0.0, 0.2, 0.4, 0.6, 0.8}) {
      ElementGrid grid = ElementGrid::across_line(half_width, n, 5);
      grid.x0 += place * grid.dx;
      const Field gap = over_grid(grid, [](double x, double) { return curvature * x * x; });
      PatchRolling contact(steel, grid, gap, {NormalLoad::Given::force, line_load});
      const ContactSolution s = contact.solve({.friction = friction, .creepage = {-creepage, 0, 0}});
      EXPECT_EQ(s.report.status, Status::ok);
      sum += std::pow(s.totals.fx / (friction * line_load) - (1 - adhesion * adhesion), 2) / 5;
    }
    return std::sqrt(sum);
  };
  const double coarse = error(12), fine = error(96);
  EXPECT_GT(std::log2(coarse / fine) / 3, 1.5);
  EXPECT_LT(fine, 8e-5);
}

TEST(PatchRolling, IsOfSecondOrderForOtherShapesAndForTwoPatches) {
  struct Case {
    Gap gap;
    double half_x, half_y, force;
  };
  for (const Case& c : {Case{egg, 1.5 * radius, 1.2 * radius, load}, Case{side_by_side, radius, 2.7 * radius, 2 * load},
                        Case{one_behind_the_other, 2.7 * radius, radius, 2 * load}})
    for (const PatchRollingMotion& m : {lengthwise, mixed}) {
      const Vec2 exact = fine_forces(c.gap, c.half_x, c.half_y, c.force, m);
      const double coarse = rms_error(c.gap, c.half_x, c.half_y, c.force, 8, m, exact);
      const double fine = rms_error(c.gap, c.half_x, c.half_y, c.force, 32, m, exact);
      EXPECT_GT(std::log2(coarse / fine) / 2, 1.7);
      EXPECT_LT(fine, 1.5e-3);
    }
}

TEST(PatchRolling, AlongMinusXIsTheMirrorImage) {
  const Gap image = [](double x, double y) { return egg(-x, y); };
  const ElementGrid grid = grid_over(1.5 * radius, 1.2 * radius, 16, 0, 0.3);
  PatchRollingMotion m = mixed;
  const ContactSolution forward = rolling(egg, grid).solve(m);
  m.creepage.longitudinal *= -1;
  m.creepage.spin *= -1;
  const ContactSolution backward = rolling(image, grid, load, RollingDirection::backward).solve(m);
  expect_forces(backward.totals, {-forward.totals.fx, forward.totals.fy, -forward.totals.mz}, 1e-5 * capacity,
                1e-5 * capacity * radius);
}

TEST(PatchRolling, FullSlidingGivesFrictionTimesTheLoad) {
  for (const Gap& gap : {Gap(circular), Gap(one_behind_the_other)}) {
    const ElementGrid grid = grid_over(2.7 * radius, 2.7 * radius, 12, 0.2, 0.4);
    const ContactSolution s = rolling(gap, grid).solve(motion(100, 0, 0));
    double whole = 0;
    for (std::size_t k = 0; k < s.fields.traction.x.size(); ++k) {
      whole += s.fields.bound[k] * s.elements.area[k];
      EXPECT_NEAR(std::hypot(s.fields.traction.x[k], s.fields.traction.y[k]), s.fields.bound[k],
                  1e-6 * s.fields.bound[k]);
    }
    EXPECT_NEAR(whole, capacity, 1e-12 * capacity);
    EXPECT_NEAR(s.totals.fx, -capacity, 1e-6 * capacity); // slip has a small part across, too
    EXPECT_EQ(s.totals.adhesion_area, 0);
  }
}

TEST(PatchRolling, ForcesGiveTheCreepagesBack) {
  PatchRolling contact = rolling(egg, grid_over(1.5 * radius, 1.2 * radius, 16, 0.2, 0.3));
  const ContactSolution given = contact.solve(mixed);
  PatchRollingMotion m = mixed;
  m.creepage.longitudinal = m.creepage.lateral = 0;
  m.force_x = given.totals.fx, m.force_y = given.totals.fy;
  const ContactSolution found = contact.solve(m);
  EXPECT_EQ(found.report.status, Status::ok);
  EXPECT_NEAR(found.creepage.longitudinal / mixed.creepage.longitudinal, 1, 2e-3);
  EXPECT_NEAR(found.creepage.lateral / mixed.creepage.lateral, 1, 2e-3);
}

TEST(PatchRolling, WithoutContactIsAStatus) {
  const ElementGrid grid = grid_over(radius, radius, 8, 0, 0);
  PatchRolling apart(steel, grid, over_grid(grid, circular), {NormalLoad::Given::approach, -1e-6});
  EXPECT_EQ(apart.contact(), nullptr);
  EXPECT_EQ(apart.solve(mixed).report.status, Status::no_contact);
}

/// The root of the mean square error of the edges [elements] that the normal problem's pressure tells, over positions.
double rms_edge_error(int n) {
  double sum = 0, count = 0;
  for (const auto& [x, y] : positions) {
    const ElementGrid grid = grid_over(radius, radius, n, x, y);
    const NormalSolution normal =
        NormalProblem(steel, grid).solve(over_grid(grid, circular), {NormalLoad::Given::force, load});
    for (const ContactRun& run : contact_runs(grid, normal.pressure)) {
      const double row = grid.y(run.row);
      if (std::abs(row) > 0.9 * radius) continue;
      const double edge = std::sqrt(radius * radius - row * row);
      sum += std::pow((run.high - edge) / grid.dx, 2) + std::pow((run.low + edge) / grid.dx, 2);
      count += 2;
    }
  }
  return std::sqrt(sum / count);
}

TEST(ContactEdges, AreFoundWithinAFractionOfAnElementThatFalls) {
  EXPECT_LT(rms_edge_error(12), 0.05);
  EXPECT_LT(rms_edge_error(24), 0.035);
  EXPECT_LT(rms_edge_error(48), 0.023);
  EXPECT_LT(rms_edge_error(96), 0.016);
}

/// Whether it has four neighbours, and p^2 of each is a tenth of the element's or more.
bool is_well_inside(const ElementGrid& grid, const Field& pressure, std::size_t k) {
  const std::size_t mx = grid.mx, i = k % mx, j = k / mx;
  if (i == 0 || i + 1 == mx || j == 0 || j + 1 == std::size_t(grid.my)) return false;
  const double least = std::min({pressure[k - 1], pressure[k + 1], pressure[k - mx], pressure[k + mx]});
  return least * least > 0.1 * pressure[k] * pressure[k];
}

TEST(PressureCurvature, IsExactWherePressureSquaredIsQuadratic) {
  ElementGrid grid = grid_over(radius, radius, 14, 0.3, 0.1);
  grid.dy *= 0.7;
  const Field pressure = over_grid(grid, [](double x, double y) { return hertz().pressure(x, y); });
  const Field curvature = pressure_curvature(grid, pressure);
  int inner = 0;
  for (std::size_t k = 0; k < curvature.size(); ++k) {
    if (!(pressure[k] > 0) || !is_well_inside(grid, pressure, k)) continue;
    const double x = grid.x(static_cast<int>(k % grid.mx)), y = grid.y(static_cast<int>(k / grid.mx));
    const double s = 1 - (x * x + y * y) / (radius * radius); // p = p0 sqrt(s)
    const double scale = hertz().peak_pressure / (radius * radius * std::sqrt(s));
    const double by_x = -(1 + x * x / (radius * radius * s)), by_y = -(1 + y * y / (radius * radius * s));
    EXPECT_NEAR(curvature[k], scale * (grid.dx * grid.dx * by_x + grid.dy * grid.dy * by_y), 1e-9 * pressure[k]);
    ++inner;
  }
  EXPECT_GT(inner, 100);
}

/// (E38): the error of the elements' pressures is of second order, that of p + c/24 higher.
TEST(PressureCurvature, GivesThePressureAtTheCentre) {
  const auto error = [](int n, double share) {
    const ElementGrid grid = grid_over(radius, radius, n, 0, 0);
    const Field pressure =
        NormalProblem(steel, grid).solve(over_grid(grid, circular), {NormalLoad::Given::force, load}, 1e-11).pressure;
    const Field curvature = pressure_curvature(grid, pressure);
    double sum = 0;
    int count = 0;
    for (std::size_t k = 0; k < pressure.size(); ++k) {
      const double x = grid.x(static_cast<int>(k % grid.mx)), y = grid.y(static_cast<int>(k / grid.mx));
      if (std::hypot(x, y) > 0.8 * radius) continue;
      sum += std::pow((pressure[k] + share * curvature[k]) / hertz().pressure(x, y) - 1, 2);
      ++count;
    }
    return std::sqrt(sum / count);
  };
  for (const int n : {24, 48, 96}) EXPECT_LT(error(n, 1.0 / 24), 0.5 * error(n, 0)) << n;
}

TEST(FittedContact, HasTheElementsOfEveryRunOfARowWithoutOverlap) {
  const ElementGrid grid = grid_over(2.7 * radius, radius, 16, 0.2, 0.4);
  const PatchRolling contact = rolling(one_behind_the_other, grid, 2 * load);
  const FittedContact& fitted = *contact.contact();
  int second_runs = 0;
  double whole = 0;
  for (std::size_t k = 0; k < fitted.elements.size(); ++k) {
    const FittedElement& e = fitted.elements[k];
    whole += fitted.load_share[k] * e.width() * grid.dy;
    EXPECT_GE(fitted.load_share[k], 0);
    if (k == 0 || fitted.elements[k - 1].row != e.row) continue;
    EXPECT_GE(e.left, fitted.elements[k - 1].right - 1e-9 * grid.dx);
    EXPECT_EQ(e.trails, fitted.elements[k - 1].leads);
    second_runs += e.trails;
  }
  EXPECT_GT(second_runs, 12);
  EXPECT_NEAR(whole, 1, 1e-12);
}

TEST(FittedContact, NeedsColumnsToSpare) {
  ElementGrid grid{.mx = 9, .my = 3, .x0 = 0, .y0 = 0, .dx = 1, .dy = 1};
  Field pressure(grid.count(), 0.0);
  EXPECT_THROW(fit_contact(grid, pressure), Error);
  pressure[9 + 5] = 1;
  EXPECT_NO_THROW(fit_contact(grid, pressure));
  pressure[9 + 6] = 1;
  EXPECT_THROW(fit_contact(grid, pressure), Error);
  pressure[9 + 6] = -1;
  EXPECT_THROW(fit_contact(grid, pressure), Error);
}

/// The rigid motion of a contact told row by row.
RowVariation in_rows(const Creepage& w) {
  return {.creepage = [w](double y) { return Creepage{w.longitudinal - w.spin * y, w.lateral, w.spin}; }};
}

/// Both begin with other tractions, which may tell if an element is on the very edge of slip; here none is.
TEST(PatchRolling, TakesTheMotionRowByRow) {
  for (const RollingDirection direction : {RollingDirection::forward, RollingDirection::backward}) {
    PatchRolling patch = rolling(egg, grid_over(1.3 * radius, 1.3 * radius, 16, 0.3, 0.4), load, direction);
    const ContactSolution rigid = patch.solve(mixed);
    PatchRollingMotion m = mixed;
    m.creepage = {};
    m.variation = in_rows(mixed.creepage);
    const ContactSolution rows = patch.solve(m);
    ASSERT_EQ(rows.report.status, Status::ok);
    expect_forces(rows.totals, rigid.totals, 2e-6 * capacity, 2e-6 * capacity * radius);
    EXPECT_NEAR(rows.totals.frictional_power, rigid.totals.frictional_power, 1e-5 * rigid.totals.frictional_power);
  }
}

TEST(PatchRolling, SlidesAtTheFrictionOfEachRow) {
  PatchRolling patch = rolling(circular, grid_over(1.3 * radius, 1.3 * radius, 16, 0.3, 0.2));
  PatchRollingMotion sliding = motion(1000, 0, 0);
  sliding.variation.friction = [](double y) { return 1 + 100 * y; };
  const ContactSolution s = patch.solve(sliding);
  double expected = 0;
  for (std::size_t k = 0; k < s.elements.size(); ++k)
    expected -= friction * (1 + 100 * s.elements.y[k]) * s.fields.pressure[k] * s.elements.area[k];
  EXPECT_NEAR(s.totals.fx, expected, 1e-7 * capacity);
  EXPECT_GT(std::abs(s.totals.mz), 1e-3 * capacity * radius);
}

TEST(PatchRolling, TakesASolvedNormalProblemAndTractionsNearby) {
  const ElementGrid grid = grid_over(1.3 * radius, 1.3 * radius, 20, 0.3, 0.4);
  const Field gap = over_grid(grid, egg);
  const NormalSolution normal = NormalProblem(steel, grid).solve(gap, {NormalLoad::Given::force, load});
  for (const RollingDirection direction : {RollingDirection::forward, RollingDirection::backward}) {
    const ContactSolution from_gap = rolling(egg, grid, load, direction).solve(mixed);
    PatchRolling patch(steel, grid, normal, direction);
    const ContactSolution first = patch.solve(mixed);
    EXPECT_NEAR(first.totals.fx, from_gap.totals.fx, 1e-6 * friction * load);
    EXPECT_NEAR(first.totals.fy, from_gap.totals.fy, 1e-6 * friction * load);

    PatchRollingMotion again = mixed;
    again.creepage.longitudinal *= 1.001;
    const ContactSolution cold = patch.solve(again);
    again.start = first.fields.traction;
    const ContactSolution warm = patch.solve(again);
    EXPECT_NEAR(warm.totals.fx, cold.totals.fx, 2e-5 * friction * load);
    EXPECT_NEAR(warm.totals.fy, cold.totals.fy, 2e-5 * friction * load);
    EXPECT_LT(warm.report.newton_steps, cold.report.newton_steps);
  }
}

TEST(PatchRolling, KeepsItsElementsUnderAnotherLoad) {
  const ElementGrid grid = grid_over(1.3 * radius, 1.3 * radius, 20, 0.3, 0.4);
  const Field gap = over_grid(grid, egg);
  NormalProblem normal(steel, grid);
  PatchRolling patch(steel, grid, normal.solve(gap, {NormalLoad::Given::force, load}));
  const NormalSolution more = normal.solve(gap, {NormalLoad::Given::force, 1.001 * load});
  PatchRolling fitted(steel, grid, more);
  patch.reload(more);
  const ContactSolution a = patch.solve(mixed), b = fitted.solve(mixed);
  double normal_force = 0;
  for (std::size_t k = 0; k < a.elements.size(); ++k) normal_force += a.fields.pressure[k] * a.elements.area[k];
  EXPECT_NEAR(normal_force, 1.001 * load, 1e-7 * load);
  EXPECT_NEAR(a.totals.fx, b.totals.fx, 1e-3 * friction * load);
  EXPECT_NEAR(a.totals.fy, b.totals.fy, 1e-3 * friction * load);
}

} // namespace
} // namespace microslip
