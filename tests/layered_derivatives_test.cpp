// Derivatives of the forces of bodies with layers, dissimilar and viscoelastic bodies against differences of forces.

#include "microslip/error.hpp"
#include "microslip/rolling/solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const Material steel = {82e9, 0.28}, brass = {37e9, 0.35}, rubber = {1e6, 0.48};
const ViscoelasticMaterial rigid = {{std::numeric_limits<double>::infinity(), 0}};
constexpr double mu = 0.3, half_length = 2e-3;

/// On a grid, so that elements stay as they are when the load changes.
RollingProblem on_grid(double normal_force, bool line = false) {
  RollingProblem p;
  ElementGrid grid = ElementGrid::across_ellipse(half_length, half_length, 12, line ? 1 : 10, 2);
  if (line) grid.line = true, grid.my = 1, grid.dy = 1, grid.y0 = 0;
  p.geometry = GapFormula{grid, [line](double x, double y) { return 5 * x * x + (line ? 0 : 7 * y * y); }};
  p.load = {NormalLoad::Given::force, normal_force};
  p.friction.law = FrictionLaw::coulomb(mu);
  p.motion.rolling_speed = 2;
  return p;
}

std::array<double, 3> components(const ContactSolution& s) {
  return {s.totals.fx, s.totals.fy, s.totals.mz / half_length};
}

/// Each column is compared with central differences of precise solutions.
void expect_slopes(const RollingProblem& at, Method method, double tolerance = 1e-5) {
  method.tolerance = 1e-12;
  Solver solver(method);
  const ExactDerivatives found = solver.differentiate(at);
  ASSERT_EQ(found.solution.report.status, Status::ok) << found.solution.report.reason;
  EXPECT_EQ(found.solution.totals.fx, solver.solve(at).totals.fx);
  const auto expect = [&](const char* by, double step, auto change, const std::array<double, 3>& column) {
    RollingProblem plus = at, minus = at;
    change(plus, step), change(minus, -step);
    const auto above = components(solver.solve(plus)), below = components(solver.solve(minus));
    const double size = std::max({std::abs(column[0]), std::abs(column[1]), std::abs(column[2])});
    EXPECT_GT(size, 0);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR((above[k] - below[k]) / (2 * step), column[k], tolerance * size) << by << ' ' << k;
  };
  const auto column = [&](int i) -> std::array<double, 3> {
    return {found.jacobian[0][i], found.jacobian[1][i], found.jacobian[2][i] / half_length};
  };
  const double small = 1e-6 * std::hypot(at.motion.creepage.longitudinal, at.motion.creepage.lateral);
  expect(
      "xi", small, [](RollingProblem& p, double d) { p.motion.creepage.longitudinal += d; }, column(0));
  expect(
      "eta", small, [](RollingProblem& p, double d) { p.motion.creepage.lateral += d; }, column(1));
  expect(
      "phi", small / half_length, [](RollingProblem& p, double d) { p.motion.creepage.spin += d; }, column(2));
  if (std::holds_alternative<GapCurvatures>(at.geometry)) return; // the load changes the elements
  expect("load", 1e-6 * at.load.value, [](RollingProblem& p, double d) { p.load.value += d; },
         {found.by_load[0], found.by_load[1], found.by_load[2] / half_length});
}

LayeredBodies coated() {
  return {{{{4e-4, {brass}}}, {steel}}, {{}, {steel}}};
}
LayeredBodies covered(const PronySeries& relaxation = {}) {
  return {{{}, rigid}, {{{1.5e-3, {rubber, relaxation}}}, {steel}}, 2};
}

TEST(LayeredDerivatives, OfElasticLayers) {
  RollingProblem p = on_grid(3000);
  p.layered = coated();
  p.motion.creepage = {1e-3, -5e-4, 0.3};
  expect_slopes(p, {});
  p.motion.direction = RollingDirection::backward;
  expect_slopes(p, {});
  p.load = {NormalLoad::Given::approach, 1.5e-5};
  expect_slopes(p, {});
}

TEST(LayeredDerivatives, OfViscoelasticLayers) {
  RollingProblem p = on_grid(0.3);
  p.layered = covered({{0.3, 5e-4}, {0.2, 5e-3}});
  p.motion.creepage = {4e-3, 2e-3, 1};
  expect_slopes(p, {});
}

TEST(LayeredDerivatives, OfRollers) {
  RollingProblem p = on_grid(120, true);
  p.layered = covered({{0.3, 5e-4}});
  p.motion.creepage = {4e-3, 2e-3, 0};
  expect_slopes(p, {});
}

/// Elements that follow the contact stay when creepages change.
TEST(LayeredDerivatives, OfBodiesByTheirRadii) {
  RollingProblem p = on_grid(3000);
  p.geometry = GapCurvatures{5, 7};
  p.layered = coated();
  p.motion.creepage = {1e-3, -5e-4, 0.3};
  expect_slopes(p, {.mx = 12, .my = 12});
}

TEST(LayeredDerivatives, OfDissimilarAndViscoelasticHalfSpaces) {
  RollingProblem p = on_grid(3000);
  p.motion.creepage = {1e-3, -5e-4, 0.3};
  p.bodies = combine(rubber, steel);
  p.load.value = 0.3;
  p.motion.creepage = {4e-3, 2e-3, 1};
  expect_slopes(p, {});
  p.bodies = viscoelastic(rubber, {0.5, 5e-4}, steel, {0, 0}, 2);
  expect_slopes(p, {});
  p.bodies = viscoelastic(rubber, {0.5, 5e-4}, rubber, {0.5, 5e-4}, 2); // tractions do not change the pressure
  expect_slopes(p, {});
}

TEST(LayeredDerivatives, OfClassicalElementsAndALayerBetween) {
  RollingProblem p = on_grid(3000);
  p.motion.creepage = {1e-3, -5e-4, 0.3};
  p.bodies = combine(steel, steel);
  expect_slopes(p, {.discretisation = Discretisation::classical});
  p.bodies.layer.flexibility = 1e-15;
  expect_slopes(p, {});
}

/// Layers of the substrate's material have the derivatives of half-spaces, to the solutions' tolerance.
TEST(LayeredDerivatives, OfEqualLayersAreThoseOfHalfSpaces) {
  RollingProblem p = on_grid(3000), plain = p;
  p.motion.creepage = plain.motion.creepage = {1e-3, -5e-4, 0.3};
  p.layered = LayeredBodies{{{{4e-4, {steel}}}, {steel}}, {{}, {steel}}};
  plain.bodies = p.layered->surfaces();
  const Method method{.discretisation = Discretisation::classical, .tolerance = 1e-11};
  const ExactDerivatives layered = Solver(method).differentiate(p), half_spaces = Solver(method).differentiate(plain);
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) {
      const double unit = std::pow(half_length, (k == 2) + (i == 2));
      EXPECT_NEAR(layered.jacobian[k][i] / unit, half_spaces.jacobian[k][i] / unit,
                  1e-6 * std::abs(half_spaces.jacobian[0][0]));
    }
    EXPECT_NEAR(layered.by_load[k], half_spaces.by_load[k], 1e-6);
  }
}

/// Where all slides along the creepage, forces are mu Fn.
TEST(LayeredDerivatives, InFullSlidingForcesGrowWithTheLoad) {
  RollingProblem p = on_grid(3000);
  p.layered = coated();
  p.motion.creepage = {0.5, 0, 0};
  const ExactDerivatives found = Solver().differentiate(p);
  EXPECT_NEAR(found.by_load[0], -mu, 1e-6);
  EXPECT_NEAR(found.jacobian[0][0], 0, 1e-3 * mu * 3000 / 0.5);
  EXPECT_NEAR(found.jacobian[1][1], -mu * 3000 / 0.5, 1e-2 * mu * 3000 / 0.5);
}

TEST(LayeredDerivatives, OfAHertzianContactByItsLoad) {
  RollingProblem p;
  p.geometry = GapCurvatures{5, 7};
  p.bodies = combine(steel, steel);
  p.load = {NormalLoad::Given::force, 3000};
  p.friction.law = FrictionLaw::coulomb(mu);
  p.motion.creepage = {1e-3, -5e-4, 0.3};
  const auto expect = [&](const RollingProblem& at) {
    Solver solver({.mx = 12, .my = 12, .tolerance = 1e-11});
    const ExactDerivatives found = solver.differentiate(at);
    const double step = 1e-6 * at.load.value;
    RollingProblem plus = at, minus = at;
    plus.load.value += step, minus.load.value -= step;
    const auto above = components(solver.solve(plus)), below = components(solver.solve(minus));
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR((above[k] - below[k]) / (2 * step), found.by_load[k] / (k == 2 ? half_length : 1),
                  1e-4 * std::abs(found.by_load[0]));
  };
  expect(p);
  p.motion.direction = RollingDirection::backward;
  p.load = {NormalLoad::Given::approach, hertz_contact(p).approach};
  expect(p);
}

TEST(LayeredDerivatives, RefusesWhatHasNone) {
  RollingProblem p = on_grid(3000);
  p.layered = coated();
  const auto refusal = [](const RollingProblem& problem, const Method& method = {}) -> std::string {
    try {
      Solver(method).differentiate(problem);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  };
  RollingProblem transient = p, forced = p, falling = p, plain = p;
  transient.motion.kind = ContactMotion::transient;
  EXPECT_NE(refusal(transient).find("steady rolling with creepages given"), std::string::npos);
  forced.motion.force_x = 1;
  EXPECT_NE(refusal(forced).find("steady rolling with creepages given"), std::string::npos);
  falling.friction.law = FrictionLaw::polach(0.3, 0.5, 1);
  EXPECT_NE(refusal(falling).find("Coulomb friction"), std::string::npos);
  plain.layered.reset();
  plain.bodies = combine(steel, steel);
  EXPECT_NE(refusal(plain).find("classical"), std::string::npos);
}

} // namespace
} // namespace microslip
