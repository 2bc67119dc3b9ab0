// What the exact theory says to problems at the limits, and to those that make no sense.

#include "microslip/exact/normal/normal_contact.hpp"
#include "tangential_cases.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace microslip {
namespace {

constexpr ContactMotion motions[] = {ContactMotion::shift, ContactMotion::transient, ContactMotion::steady};

double ball(double x, double y) {
  return 0.5 * (x * x + y * y);
}

bool all_finite(const ContactSolution& s) {
  const ContactForces& f = s.forces();
  for (const double value :
       {f.fx, f.fy, f.mz, s.totals.elastic_energy, s.totals.frictional_power, s.totals.power_by_creepage,
        s.totals.peak_traction, s.report.residual, s.creepage.longitudinal, s.creepage.lateral})
    if (!std::isfinite(value)) return false;
  for (const Field* field : {&s.fields.traction.x, &s.fields.traction.y, &s.fields.displacement.x,
                             &s.fields.displacement.y, &s.fields.slip.x, &s.fields.slip.y})
    if (!std::all_of(field->begin(), field->end(), [](double value) { return std::isfinite(value); })) return false;
  return true;
}

TEST(ExactBadInput, NoContactAtAll) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 4e-3, 8);
  const NormalContact c = solve_normal_contact(steel, ball, grid, {NormalLoad::Given::approach, -1e-6});
  EXPECT_EQ(c.solution.status, Status::no_contact);
  EXPECT_EQ(c.solution.normal_force, 0);
  TangentialInput input;
  input.creepage = {1e-3, 0, 0};
  const ContactSolution s = TangentialProblem(steel, grid).solve(c.solution.pressure, input);
  EXPECT_EQ(s.report.status, Status::ok);
  EXPECT_EQ(s.totals.fx, 0);
  EXPECT_EQ(s.totals.adhesion_area + s.totals.slip_area, 0);
  EXPECT_TRUE(all_finite(s));
}

TEST(ExactBadInput, ContactReachesTheBorder) {
  const ElementGrid grid = ElementGrid::across_ellipse(1e-3, 1e-3, 8);
  expect_words(
      [&] {
        solve_normal_contact(steel, ball, grid, {NormalLoad::Given::force, 1e4});
      },
      "reaches its border at x = -0.001000 m, x = 0.001000 m");
}

TEST(ExactBadInput, OneElement) {
  const ElementGrid grid{.mx = 1, .my = 1, .x0 = 0, .y0 = 0, .dx = 1e-3, .dy = 1e-3, .line = false};
  const NormalContact c = solve_normal_contact(steel, ball, grid, {NormalLoad::Given::force, 100}, 50);
  EXPECT_EQ(c.solution.status, Status::ok);
  const Problem p{steel, grid, {0.3 * c.solution.pressure[0]}, 30, 5e-4};
  for (const ContactMotion motion : motions)
    for (const double size : {1e-9, 1e-6, 1.0}) {
      TangentialInput input;
      input.motion = motion;
      input.creepage = {size, -2 * size, 10 * size};
      expect_solution(p, input, solve(p, input));
      input.force_x = 12;
      expect_solution(p, input, solve(p, input));
    }
}

/// 1 x n and n x 1.
TEST(ExactBadInput, RowsAndColumns) {
  for (const bool column : {false, true})
    for (const ContactMotion motion : motions)
      for (const bool given : {false, true}) {
        ElementGrid grid{.mx = 14, .my = 1, .x0 = -6.5e-4, .y0 = 0, .dx = 1e-4, .dy = 1.5e-4, .line = false};
        if (column) grid = {.mx = 1, .my = 14, .x0 = 0, .y0 = -6.5e-4, .dx = 1.5e-4, .dy = 1e-4, .line = false};
        const NormalContact c = solve_normal_contact(steel, ball, grid, {NormalLoad::Given::force, 40}, 100);
        Problem p{steel, c.grid, c.solution.pressure, 0, 7e-4};
        for (double& g : p.bound) p.capacity += (g *= 0.3) * grid.element_area();
        TangentialInput input;
        input.motion = motion;
        const double way = motion == ContactMotion::shift ? 1e-3 : 1;
        input.creepage = {3e-4 * way, 2e-4 * way, 2 * way};
        if (given) input.force_x = 0.5 * p.capacity, input.force_y = -0.7 * p.capacity;
        expect_solution(p, input, solve(p, input));
      }
}

TEST(ExactBadInput, GapWithNaN) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 4e-3, 4);
  Field gap(grid.count(), 0.0);
  for (const double bad : {nan, infinity, -infinity}) {
    gap[5] = bad;
    expect_error(
        [&] {
          NormalProblem(steel, grid).solve(gap, {NormalLoad::Given::force, 1});
        },
        "gap[5]", "[m]: must be finite");
    const auto hole = [&](double x, double y) { return x > 0 && y > 0 ? bad : 0; };
    expect_error(
        [&] {
          solve_normal_contact(steel, hole, grid, {NormalLoad::Given::force, 1});
        },
        "gap at x = 0.001000 m, y = 0.001000 m", "[m]: must be finite");
  }
}

TEST(ExactBadInput, ZeroFriction) {
  Problem p = elliptic(steel_contact(1), 8, 8);
  std::fill(p.bound.begin(), p.bound.end(), 0.0);
  for (const ContactMotion motion : motions) {
    TangentialInput input;
    input.motion = motion;
    input.creepage = {1e-3, 1e-3, 0.1};
    const ContactSolution s = solve(p, input);
    EXPECT_EQ(s.report.status, Status::ok);
    EXPECT_EQ(std::abs(s.totals.fx) + std::abs(s.totals.fy) + std::abs(s.totals.frictional_power), 0);
    EXPECT_TRUE(all_finite(s));
    input.force_x = 1e-3; // nothing bears it
    EXPECT_EQ(solve(p, input).report.status, Status::no_solution);
    input.force_x = 0;
    EXPECT_EQ(solve(p, input).report.status, Status::ok);
  }
}

TEST(ExactBadInput, StepOfZeroMeansAnElement) {
  const Problem p = elliptic(steel_contact(1), 8, 8);
  TangentialInput input;
  input.creepage = {1e-3, 0, 0};
  const double by_default = solve(p, input).totals.fx;
  input.step = p.grid.dx;
  EXPECT_EQ(solve(p, input).totals.fx, by_default);
}

TEST(ExactBadInput, NegativeStepIsRefused) {
  const Problem p = elliptic(steel_contact(1), 8, 8);
  for (const ContactMotion motion : motions) {
    TangentialInput input;
    input.motion = motion;
    input.step = -1e-4;
    expect_error([&] { solve(p, input); }, "step", "[m]: must be in [0, ");
  }
}

/// Steps much longer than the contact, with spin, creepages or forces.
TEST(ExactBadInput, StepOfAHundredElements) {
  const EllipticContact contact = steel_contact(2);
  const Problem p = elliptic(contact, 11, 9);
  for (const ContactMotion motion : {ContactMotion::transient, ContactMotion::steady})
    for (const double spin : {0.0, 0.5, 4.0})
      for (const int given : {0, 1, 2, 3}) {
        SCOPED_TRACE("spin " + std::to_string(spin) + ", forces " + std::to_string(given));
        TangentialInput input;
        input.motion = motion;
        input.step = 100 * p.grid.dx;
        input.creepage = scaled_creepage(contact, 0.1, 0.05, spin);
        input.tolerance = 1e-10;
        if (given & 1) input.force_x = 0.7 * p.capacity;
        if (given & 2) input.force_y = -0.6 * p.capacity;
        expect_solution(p, input, solve(p, input));
      }
}

TEST(ExactBadInput, ForceBeyondFrictionSlidesFully) {
  const Problem p = elliptic(steel_contact(1), 8, 8);
  for (const ContactMotion motion : motions) {
    TangentialInput input;
    input.motion = motion;
    input.force_x = -0.9 * p.capacity;
    input.force_y = 0.9 * p.capacity;
    const ContactSolution s = solve(p, input);
    EXPECT_EQ(s.report.status, Status::no_solution);
    EXPECT_EQ(s.totals.adhesion_area, 0);
    EXPECT_NEAR(s.totals.fx, -p.capacity / std::sqrt(2), 1e-9 * p.capacity);
    EXPECT_NEAR(s.totals.fy, p.capacity / std::sqrt(2), 1e-9 * p.capacity);
    EXPECT_NEAR(s.report.residual, 0.9 * std::sqrt(2) - 1, 1e-9);
    EXPECT_TRUE(all_finite(s));
  }
}

/// Numbers so large that products overflow: never a result that is not a number with Status::ok.
TEST(ExactBadInput, Overflow) {
  const Problem p = elliptic(steel_contact(1), 6, 6);
  int refused = 0;
  for (const ContactMotion motion : motions)
    for (const double size : {1e10, 1e150, 1e300, 1.7e308})
      for (const double speed : {1e-300, 1.0, 1e300})
        for (const double bound : {1.0, 1e150, 1e290}) {
          Problem q = p;
          for (double& g : q.bound) g *= bound;
          TangentialInput input;
          input.motion = motion;
          input.creepage = {size, -size, size};
          input.rolling_speed = speed;
          const ContactSolution s = solve(q, input);
          if (s.report.status == Status::ok) {
            EXPECT_TRUE(all_finite(s)) << size << ' ' << speed << ' ' << bound;
          } else {
            EXPECT_EQ(s.report.status, Status::invalid_input);
            ++refused;
          }
        }
  EXPECT_GT(refused, 0);
}

TEST(ExactBadInput, MoreMemoryThanTheMachineHas) {
  const ElementGrid grid{.mx = 1000000, .my = 1000000, .x0 = 0, .y0 = 0, .dx = 1e-6, .dy = 1e-6, .line = false};
  EXPECT_THROW(NormalProblem(steel, grid), Error);
  EXPECT_THROW(TangentialProblem(steel, grid), Error);
}

} // namespace
} // namespace microslip
