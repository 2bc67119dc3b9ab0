#include "microslip/rolling/solver.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/test_cases.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

EllipticContact contact() {
  return steel_contact(9e-3, 6e-3, 0.4, -0.5, 0.3);
}

/// The same contact as values of Hertz's gap on the classical grid across its ellipse.
RollingProblem on_grid(const EllipticContact& c, int n, int margin) {
  RollingProblem problem = rolling_problem(c);
  const GapCurvatures gap = hertz_contact(problem).gap;
  const ElementGrid grid = ElementGrid::across_ellipse(c.a, c.b, n, n, margin);
  problem.geometry = GapValues{grid, hertzian_gap(gap, grid)};
  return problem;
}

void expect_same(const ContactSolution& one, const ContactSolution& other) {
  EXPECT_EQ(one.totals.fx, other.totals.fx);
  EXPECT_EQ(one.totals.fy, other.totals.fy);
  EXPECT_EQ(one.totals.mz, other.totals.mz);
  EXPECT_EQ(one.fields.traction.x, other.fields.traction.x);
  EXPECT_EQ(one.fields.pressure, other.fields.pressure);
  EXPECT_EQ(one.report.status, other.report.status);
}

TEST(Solver, SolvesAnEllipseAsTheSimplifiedTheoryDoes) {
  const EllipticContact c = contact();
  const ContactSolution simplified = Solver({.theory = Theory::fastsim2, .mx = 16, .my = 16}).solve(rolling_problem(c));
  expect_same(simplified, Fastsim2({.mx = 16, .my = 16}).fields(c));
}

TEST(Solver, FindsTheEllipseOfCurvaturesByForceAndByApproach) {
  RollingProblem problem = rolling_problem(contact());
  const HertzContact hertz = hertz_contact(problem);
  const ContactSolution ellipse = Solver({.mx = 12, .my = 12}).solve(problem);
  problem.geometry = hertz.gap;
  const double unit = friction_force(contact());
  EXPECT_NEAR(Solver({.mx = 12, .my = 12}).solve(problem).totals.fx, ellipse.totals.fx, 1e-6 * unit);
  problem.load = {NormalLoad::Given::approach, hertz.approach};
  EXPECT_NEAR(Solver({.mx = 12, .my = 12}).solve(problem).totals.fx, ellipse.totals.fx, 1e-6 * unit);
  problem.geometry = Ellipse{hertz.a, hertz.b};
  EXPECT_NEAR(Solver({.mx = 12, .my = 12}).solve(problem).totals.fx, ellipse.totals.fx, 1e-6 * unit);
}

TEST(Solver, AccuracyGivesTheLimitWithItsError) {
  const EllipticContact c = contact();
  const ContactSolution found = Solver({.accuracy = 3e-3}).solve(rolling_problem(c));
  const AccurateContact limit = AccurateContactSolver({.accuracy = 3e-3}).solve(rolling_problem(c));
  EXPECT_EQ(found.totals.fx, limit.forces.fx);
  ASSERT_TRUE(found.report.estimated_error.has_value());
  EXPECT_EQ(*found.report.estimated_error, limit.error);
  EXPECT_LE(*found.report.estimated_error, 3e-3);
}

/// A gap on a grid, as values or as a formula: at second order the ellipse's forces but for the elements' size.
TEST(Solver, SolvesAnyGapAtSecondOrder) {
  const EllipticContact c = contact();
  RollingProblem problem = on_grid(c, 32, 5);
  Solver solver;
  const ContactSolution values = solver.solve(problem),
                        ellipse = Solver({.mx = 32, .my = 32}).solve(rolling_problem(c));
  const double unit = friction_force(c);
  EXPECT_EQ(values.report.status, Status::ok) << values.report.reason;
  EXPECT_NEAR(values.totals.fx, ellipse.totals.fx, 3e-3 * unit);
  EXPECT_NEAR(values.totals.fy, ellipse.totals.fy, 3e-3 * unit);
  const GapCurvatures gap = hertz_contact(rolling_problem(c)).gap;
  problem.geometry = GapFormula{std::get<GapValues>(problem.geometry).grid,
                                [&](double x, double y) { return gap.x * x * x + gap.y * y * y; }};
  EXPECT_NEAR(solver.solve(problem).totals.fx, values.totals.fx, 1e-9 * unit);
}

/// Where a problem needs the classical discretisation, the gap's grid is that of the ellipse's solver, to the last bit.
TEST(Solver, SolvesAnyGapClassicallyAsTheEllipsesSolver) {
  EllipticContact c = contact();
  c.friction = FrictionLaw::exponential(0.2, {.drop = 0.1, .half_velocity = 0.5});
  expect_same(Solver().solve(on_grid(c, 12, contact_margin)), Solver({.mx = 12, .my = 12}).solve(rolling_problem(c)));
  c = contact();
  c.dissimilarity = 0.1;
  expect_same(Solver().solve(on_grid(c, 12, contact_margin)), Solver({.mx = 12, .my = 12}).solve(rolling_problem(c)));
  RollingProblem transient = on_grid(contact(), 12, contact_margin);
  transient.motion.kind = ContactMotion::transient;
  transient.motion.steps = 3;
  const ContactSolution found = Solver().solve(transient);
  ASSERT_EQ(found.history.size(), 3u);
  const ContactSolution wanted = Solver({.mx = 12, .my = 12, .discretisation = Discretisation::classical})
                                     .solve(rolling_problem(contact(), {.kind = ContactMotion::transient, .steps = 3}));
  EXPECT_NEAR(found.totals.fx, wanted.totals.fx, 1e-5 * friction_force(contact()));
}

/// What a solver keeps from one problem leaves no trace in the next.
TEST(Solver, CanBeUsedForOneProblemAfterTheOther) {
  RollingProblem backward = rolling_problem(contact()), unlike = rolling_problem(contact());
  backward.motion.direction = RollingDirection::backward;
  unlike.bodies.material.dissimilarity = 0.1;
  const RollingProblem grid = on_grid(contact(), 12, 5), coarser = on_grid(contact(), 10, 5);
  Solver solver({.mx = 10, .my = 10});
  for (const RollingProblem& p : {backward, unlike, grid, coarser, backward, grid})
    expect_same(solver.solve(p), Solver({.mx = 10, .my = 10}).solve(p));
}

/// A solve that progress has ended leaves nothing half done behind.
TEST(Solver, GoesOnAfterProgressHasEndedASolve) {
  for (const int calls : {0, 1, 3, 30}) {
    const RollingProblem problem = on_grid(contact(), 12, 5);
    Solver solver;
    int told = 0;
    const ContactSolution ended = solver.solve(problem, [&](double) { return ++told <= calls; });
    EXPECT_EQ(ended.report.status, Status::not_converged) << calls;
    EXPECT_FALSE(ended.report.reason.empty()) << calls;
    expect_same(solver.solve(problem), Solver().solve(problem));
  }
}

/// The grid of a gap tells the shape of its elements, the method may tell another.
TEST(Solver, HonoursTheShapeOfAGridsElements) {
  RollingProblem constant = on_grid(contact(), 12, 5), bilinear = constant;
  auto& grid = std::get<GapValues>(bilinear.geometry).grid;
  grid.shape = ElementShape::bilinear;
  const Method classical{.discretisation = Discretisation::classical};
  Method as_bilinear = classical, as_constant = classical;
  as_bilinear.elements = ElementShape::bilinear;
  as_constant.elements = ElementShape::constant;
  expect_same(Solver(classical).solve(bilinear), Solver(as_bilinear).solve(constant));
  expect_same(Solver(as_constant).solve(bilinear), Solver(classical).solve(constant));
  EXPECT_NE(Solver(classical).solve(bilinear).totals.fx, Solver(classical).solve(constant).totals.fx);
  EXPECT_THROW(Solver({.discretisation = Discretisation::second_order}).solve(bilinear), Error);
  expect_same(Solver({.elements = ElementShape::constant}).solve(bilinear), Solver().solve(constant));
}

TEST(Solver, FieldsOfAnyGapGoStraightToOtherGrids) {
  const ContactSolution s = Solver().solve(on_grid(contact(), 16, 5));
  const std::vector<double> same = sampled(s.elements, s.fields.pressure, s.elements.grid);
  for (std::size_t k = 0; k < same.size(); ++k) {
    const bool regular = s.elements.width[k] == s.elements.grid.dx;
    if (regular && s.elements.x[k] == s.elements.grid.x(static_cast<int>(k) % s.elements.mx())) {
      EXPECT_EQ(same[k], s.fields.pressure[k]);
    }
  }
  const ElementGrid fine = ElementGrid::across_ellipse(9e-3, 6e-3, 64, 64, 4);
  double load = 0;
  for (const double p : sampled(s.elements, s.fields.pressure, fine)) load += p * fine.element_area();
  EXPECT_NEAR(load, contact().normal_force, 0.02 * contact().normal_force);
  EXPECT_THROW(sampled(s.elements, {1.0}, fine), Error);
}

TEST(Solver, RefusesNumbersOutOfRange) {
  expect_error([] { Solver({.mx = 0}); }, "mx", "must be in [1, 4000]");
  expect_error([] { Solver({.tolerance = 0}); }, "tolerance", "must be in [1e-14, 0.1]");
  expect_error([] { Solver({.accuracy = 1}); }, "accuracy", "must be in [1e-05, 0.1]");
  RollingProblem problem = rolling_problem(contact());
  problem.motion.rolling_speed = -1;
  const ContactSolution s = Solver({.mx = 8, .my = 8}).solve(problem);
  EXPECT_EQ(s.report.status, Status::invalid_input);
  EXPECT_NE(s.report.reason.find("rolling_speed = -1 [m/s]: must be positive"), std::string::npos) << s.report.reason;
}

} // namespace
} // namespace microslip
