// Bodies with layers to an accuracy: against Carter's closed form and the limit of second order where layers have their
// substrate's material, against finer grids, with forces given.

#include "microslip/rolling/accurate_contact.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const Material steel = {82e9, 0.28}, rubber = {1e6, 0.48};

LayeredBodies equal_layers() {
  const LayeredBody body = {{{3e-4, {steel}}, {1e-3, {steel}}}, {steel}};
  return {body, body};
}

/// A cover that relaxes, on steel.
LayeredBodies relaxing_cover(double speed) {
  return {{{}, {steel}}, {{{2e-3, {rubber, {{0.3, 1e-3}}}}}, {steel}}, speed};
}

RollingProblem problem_of(const GapCurvatures& curvatures, const LayeredBodies& bodies, double normal_force) {
  RollingProblem p;
  p.geometry = curvatures;
  p.layered = bodies;
  p.load = {NormalLoad::Given::force, normal_force};
  p.friction.law = FrictionLaw::coulomb(0.3);
  p.motion.rolling_speed = 2;
  return p;
}

double largest_difference(const ContactForces& a, const ContactForces& b, double length) {
  return std::max({std::abs(a.fx - b.fx), std::abs(a.fy - b.fy), std::abs(a.mz - b.mz) / length});
}

TEST(LayeredAccuracy, RollersOfEqualLayersHaveCartersForce) {
  const double force = 1e6, mu = 0.3, accuracy = 2e-3;
  RollingProblem p = problem_of({5, 0}, equal_layers(), force);
  const double a = line_contact_from_load(5, p.layered->surfaces(), force).half_width;
  AccurateContactSolver solver({.accuracy = accuracy});
  for (const double share : {0.2, 0.6, 0.9}) { // of the creepage from which all slides
    p.motion.creepage.longitudinal = share * mu * a / 0.1;
    const AccurateContact found = solver.solve(p);
    ASSERT_EQ(found.forces.status, Status::ok);
    EXPECT_LE(found.error, accuracy);
    EXPECT_NEAR(-found.forces.fx / (mu * force), 1 - std::pow(1 - share, 2), found.error) << share;
  }
}

TEST(LayeredAccuracy, BallsOfEqualLayersHaveTheLimitOfSecondOrder) {
  RollingProblem p = problem_of({5, 2.5}, equal_layers(), 10e3);
  p.motion.creepage = {1e-3, -5e-4, 0.2};
  const AccurateContact found = AccurateContactSolver({.accuracy = 0.02}).solve(p);
  ASSERT_EQ(found.forces.status, Status::ok);
  EXPECT_LE(found.error, 0.02);
  RollingProblem plain = p;
  plain.layered.reset();
  plain.bodies = p.layered->surfaces();
  const ContactForces exact = AccurateContactSolver({.accuracy = 2e-3}).solve(plain).forces;
  const HertzContact hertz = hertz_contact(plain);
  EXPECT_LE(largest_difference(found.forces, exact, std::sqrt(hertz.a * hertz.b)), 0.3 * 10e3 * found.error);
}

TEST(LayeredAccuracy, EstimateIsNotBelowTheErrorOfACover) {
  RollingProblem p = problem_of({5, 0}, relaxing_cover(2), 2e3);
  p.motion.creepage = {0.01, 0.005, 1};
  const AccurateContact rough = AccurateContactSolver({.accuracy = 0.03}).solve(p),
                        fine = AccurateContactSolver({.accuracy = 1e-3}).solve(p);
  ASSERT_EQ(fine.forces.status, Status::ok);
  EXPECT_GT(fine.elements, rough.elements);
  const double half_width = fine.finest.elements.grid.dx * fine.elements / 2;
  EXPECT_LE(largest_difference(rough.forces, fine.forces, half_width), 0.3 * 2e3 * rough.error);
}

/// With the forces that creepages have, the creepages are found again, to what the forces' errors are worth.
TEST(LayeredAccuracy, ForcesGivenHaveALimitOfTheCreepage) {
  RollingProblem p = problem_of({5, 0}, relaxing_cover(2), 2e3);
  p.motion.creepage = {0.01, 0.005, 0};
  AccurateContactSolver solver({.accuracy = 2e-3});
  const AccurateContact forward = solver.solve(p);
  p.motion.force_x = forward.forces.fx;
  p.motion.force_y = forward.forces.fy;
  const AccurateContact back = solver.solve(p);
  ASSERT_EQ(back.forces.status, Status::ok);
  EXPECT_LE(back.error, 2e-3);
  EXPECT_NEAR(back.creepage.longitudinal, 0.01, 5e-4);
  EXPECT_NEAR(back.creepage.lateral, 0.005, 5e-4);
  EXPECT_NEAR(back.forces.fx, *p.motion.force_x, 1e-4 * 0.3 * 2e3);
}

TEST(LayeredAccuracy, DoesNotDependOnWhatWasSolvedBefore) {
  RollingProblem p = problem_of({5, 0}, relaxing_cover(2), 2e3), other = p;
  p.motion.creepage.longitudinal = 0.01;
  other.load.value = 500;
  Solver kept({.accuracy = 0.02});
  kept.solve(other);
  const ContactSolution after = kept.solve(p), alone = Solver({.accuracy = 0.02}).solve(p);
  EXPECT_EQ(after.totals.fx, alone.totals.fx);
  EXPECT_EQ(after.report.estimated_error, alone.report.estimated_error);
  EXPECT_EQ(kept.deformed_gap(p).gap, alone.fields.gap);
}

TEST(LayeredAccuracy, ProgressMayEndIt) {
  RollingProblem p = problem_of({5, 0}, relaxing_cover(2), 2e3);
  p.motion.creepage.longitudinal = 0.01;
  int calls = 0;
  const AccurateContact ended = AccurateContactSolver({.accuracy = 1e-4}).solve(p, [&](double) { return ++calls < 5; });
  EXPECT_EQ(ended.forces.status, Status::not_converged);
  EXPECT_TRUE(std::isnan(ended.forces.fx));
}

} // namespace
} // namespace microslip
