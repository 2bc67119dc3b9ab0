// Steady rolling from coarser grids: the solution is that without them, and Newton's steps do not grow with the grid,
// whatever the shape of the contact.

#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/exact/fitted/patch_rolling.hpp"
#include "tangential_cases.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace microslip {
namespace {

/// An egg and beside it a smaller patch.
Problem two_patches(int n, double ratio) {
  const EllipticContact c = steel_contact(ratio);
  const CombinedMaterial material{c.shear_modulus, c.poisson_ratio, 0};
  const GapCurvatures curvature = hertz_from_ellipse(c.a, c.b, material, c.normal_force).gap;
  Problem p{material, ElementGrid::across_ellipse(1.3 * c.a, 2.2 * c.b, n, 2 * n, 4), {}, 0, c.a};
  Field gap;
  for (int j = 0; j < p.grid.my; ++j)
    for (int i = 0; i < p.grid.mx; ++i) {
      const double x = p.grid.x(i), y = p.grid.y(j) + 0.9 * c.b, beside = y - 2.1 * c.b;
      const double egg = curvature.x * x * x * (1 + 0.2 * x / c.a + 0.15 * y / c.b) + curvature.y * y * y;
      gap.push_back(std::min(egg, curvature.x * x * x + 2 * curvature.y * beside * beside + 3e-6));
    }
  p.bound = NormalProblem(material, p.grid).solve(gap, {NormalLoad::Given::force, c.normal_force}).pressure;
  for (double& g : p.bound) g *= 0.3;
  p.capacity = 0.3 * c.normal_force;
  return p;
}

TangentialInput input_for(double ratio, double xi, double eta, double phi) {
  TangentialInput input;
  input.creepage = scaled_creepage(steel_contact(ratio), xi, eta, phi);
  input.tolerance = 1e-8;
  return input;
}

TEST(NestedGrids, TheSolutionIsThatFromZeroTractions) {
  const Problem p = two_patches(32, 1);
  const VectorField zero{Field(p.grid.count()), Field(p.grid.count())};
  for (TangentialInput input : {input_for(1, 0.3, 0.2, 0.1), input_for(1, -0.1, 0, 0.6)})
    for (const bool backward : {false, true})
      for (const bool corrected : {false, true})
        for (const double step : {1.0, 1.4}) {
          input.direction = backward ? RollingDirection::backward : RollingDirection::forward;
          if (corrected) input.leading_edge.emplace();
          input.step = step * p.grid.dx;
          const ContactSolution nested = solve(p, input);
          input.start = &zero;
          const ContactSolution direct = solve(p, input);
          input.start = nullptr;
          input.leading_edge.reset();
          EXPECT_EQ(nested.report.status, Status::ok);
          EXPECT_LE(nested.report.newton_steps, direct.report.newton_steps);
          EXPECT_NEAR(nested.totals.fx, direct.totals.fx, 1e-7 * p.capacity);
          EXPECT_NEAR(nested.totals.fy, direct.totals.fy, 1e-7 * p.capacity);
          for (std::size_t k = 0; k < p.grid.count(); ++k)
            EXPECT_NEAR(nested.fields.displacement.x[k], direct.fields.displacement.x[k],
                        1e-6 * std::abs(direct.fields.displacement.x[p.grid.count() / 2 + p.grid.mx / 2]));
        }
}

TEST(NestedGrids, NewtonStepsDoNotGrowWithTheGrid) {
  for (const double ratio : {0.3, 1.0, 5.0})
    for (const TangentialInput& input : {input_for(ratio, 0.3, 0.2, 0.1), input_for(ratio, -0.1, 0, 0.6)})
      for (const int n : {24, 48, 96}) {
        const ContactSolution s = solve(two_patches(n, ratio), input);
        EXPECT_EQ(s.report.status, Status::ok);
        EXPECT_LE(s.report.newton_steps, 12) << ratio << ' ' << n;
      }
}

TEST(NestedGrids, NewtonStepsDoNotGrowWithForcesPrescribed) {
  for (const double ratio : {0.3, 1.0, 5.0})
    for (const int n : {24, 48, 96}) {
      const Problem p = two_patches(n, ratio);
      TangentialInput input = input_for(ratio, 0.3, 0.2, 0.1);
      const ContactSolution by_creepage = solve(p, input);
      const Creepage wanted = input.creepage;
      input.creepage.longitudinal = input.creepage.lateral = 0;
      input.force_x = by_creepage.totals.fx;
      input.force_y = by_creepage.totals.fy;
      const ContactSolution by_force = solve(p, input);
      EXPECT_EQ(by_force.report.status, Status::ok);
      EXPECT_LE(by_force.report.newton_steps, 12) << ratio << ' ' << n;
      EXPECT_NEAR(by_force.creepage.longitudinal, wanted.longitudinal, 1e-5 * std::abs(wanted.longitudinal));
      EXPECT_NEAR(by_force.creepage.lateral, wanted.lateral, 1e-5 * std::abs(wanted.lateral));
    }
}

/// A step of two elements: z = -1 is a wave of tractions that hardly slips, which the preconditioner knows.
TEST(NestedGrids, StepsOfTwoElementsTakeAtMostTwiceTheProducts) {
  long of_one = 0, of_two = 0;
  for (const double ratio : {0.3, 1.0, 5.0}) {
    const Problem p = two_patches(64, ratio);
    TangentialInput input = input_for(ratio, 0.3, 0.2, 0.1);
    for (const int step : {1, 2}) {
      input.step = step * p.grid.dx;
      const ContactSolution s = solve(p, input);
      EXPECT_EQ(s.report.status, Status::ok);
      (step == 1 ? of_one : of_two) += s.report.products;
    }
  }
  EXPECT_LE(double(of_two), 2 * double(of_one));
}

/// From a layer that is elastic nearly everywhere to one that yields nearly everywhere, on elements of n across.
TEST(NestedGrids, NewtonStepsDoNotGrowOnALayerThatYields) {
  for (const bool rows_differ : {false, true}) {
    std::array<int, 2> steps = {};
    for (const int n : {24, 97}) {
      const EllipticContact c = steel_contact(0.7);
      const HertzContact hertz = hertz_from_ellipse(c.a, c.b, {c.shear_modulus, c.poisson_ratio, 0}, c.normal_force);
      ContactStep step;
      step.grid = ElementGrid::across_ellipse(c.a, c.b, n, 2);
      step.bodies = CombinedMaterial{c.shear_modulus, c.poisson_ratio, 0};
      step.bodies.layer = {.flexibility = 2.5e-14, .yield_stress = 0.03 * hertz.peak_pressure, .hardening = 5e12};
      for (int j = 0; j < step.grid.my; ++j) {
        for (int i = 0; i < step.grid.mx; ++i) {
          const double x = step.grid.x(i), y = step.grid.y(j);
          step.gap.push_back(hertz.gap.x * x * x + hertz.gap.y * y * y);
        }
        if (j == 0 || rows_differ) step.friction.push_back(FrictionLaw::coulomb(0.3 + 0.02 * step.grid.y(j) / c.b));
      }
      step.load = {NormalLoad::Given::force, c.normal_force};
      for (const double size : {0.1, 0.3, 1.0, 3.0}) {
        step.motion.creepage = scaled_creepage(c, size, -0.3 * size, 0.1);
        step.motion.tolerance = 1e-8;
        const ContactStepSolution s = ContactSequence().solve(step);
        EXPECT_EQ(s.report.status, Status::ok);
        EXPECT_GT(s.plastic_elements, 0) << size;
        steps[n > 24] += s.report.newton_steps;
      }
    }
    EXPECT_LE(steps[1], 1.5 * steps[0]);
  }
}

TEST(NestedGrids, ExtraSlipIsPartOfTheStart) {
  const Problem p = two_patches(64, 1);
  TangentialInput input = input_for(1, 0, 0, 0);
  Field extra_x, extra_y;
  const Creepage unit = scaled_creepage(steel_contact(1), 0.3, 0.3, 0);
  for (std::size_t k = 0; k < p.grid.count(); ++k) {
    extra_x.push_back(unit.longitudinal * std::cos(p.grid.y(static_cast<int>(k / p.grid.mx)) / 4e-3));
    extra_y.push_back(unit.lateral * std::sin(p.grid.x(static_cast<int>(k % p.grid.mx)) / 4e-3));
  }
  input.extra_x = extra_x, input.extra_y = extra_y;
  const ContactSolution s = solve(p, input);
  EXPECT_EQ(s.report.status, Status::ok);
  EXPECT_LE(s.report.newton_steps, 8);
}

TEST(NestedGrids, PatchesTakeAsManyStepsOnEveryGrid) {
  for (const double ratio : {0.3, 1.0, 5.0})
    for (const int n : {24, 48, 96}) {
      const EllipticContact c = steel_contact(ratio);
      const CombinedMaterial material{c.shear_modulus, c.poisson_ratio, 0};
      const GapCurvatures curvature = hertz_from_ellipse(c.a, c.b, material, c.normal_force).gap;
      const ElementGrid grid = ElementGrid::across_ellipse(c.a, c.b, n, 5 + n / 4);
      Field gap;
      for (std::size_t k = 0; k < grid.count(); ++k) {
        const double x = grid.x(static_cast<int>(k % grid.mx)), y = grid.y(static_cast<int>(k / grid.mx));
        gap.push_back(curvature.x * x * x * (1 + 0.2 * x / c.a + 0.15 * y / c.b) + curvature.y * y * y);
      }
      for (const auto& [xi, eta, phi] : {std::array{0.3, 0.2, 0.1}, std::array{-0.1, 0.0, 0.6}})
        for (const auto direction : {forward, backward}) {
          PatchRolling rolling(material, grid, gap, {NormalLoad::Given::force, c.normal_force}, direction);
          PatchRollingMotion motion{.friction = 0.3, .creepage = scaled_creepage(c, xi, eta, phi)};
          const ContactSolution s = rolling.solve(motion);
          EXPECT_EQ(s.report.status, Status::ok);
          EXPECT_LE(s.report.newton_steps, n < 48 ? 12 : 8) << ratio << ' ' << n;
          motion.force_x = s.totals.fx;
          motion.force_y = s.totals.fy;
          const ContactSolution by_force = rolling.solve(motion);
          EXPECT_EQ(by_force.report.status, Status::ok);
          EXPECT_LE(by_force.report.newton_steps, 12) << ratio << ' ' << n;
        }
    }
}

} // namespace
} // namespace microslip
