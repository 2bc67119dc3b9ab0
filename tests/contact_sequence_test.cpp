// Steps of contact that go on from one another, on grids that may change.

#include "microslip/exact/classical/contact_sequence.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/fields.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr CombinedMaterial material = {1e9, 0.28, 0};
constexpr double curvature = 10, friction = 0.3, force = 50;

ElementGrid grid_of(int mx, double x0) {
  return {mx, 18, x0, -1.7e-3, 0.2e-3, 0.2e-3};
}

/// A sphere pressed on.
ContactStep sphere(const ElementGrid& grid) {
  ContactStep step;
  step.grid = grid;
  step.bodies.material = material;
  step.gap = over_grid(grid, [](double x, double y) { return curvature * (std::pow(x, 2) + std::pow(y, 2)); });
  step.load = {NormalLoad::Given::force, force};
  step.friction = {FrictionLaw::coulomb(friction)};
  step.motion.motion = ContactMotion::shift;
  step.motion.tolerance = 1e-10;
  step.force_x = -0.2;
  return step;
}

TEST(ContactSequence, AStepGoesOnFromTheLastOne) {
  // Two shifts to a force one after the other are one shift, for the slip area only grows (Cattaneo and Mindlin).
  const ElementGrid grid = grid_of(18, -1.7e-3);
  ContactSequence in_two, at_once;
  ContactStep step = sphere(grid);
  step.force_x = -0.1;
  const auto first = in_two.solve(step);
  step.force_x = -0.2;
  const auto once = at_once.solve(step);
  step.start = StepStart::previous;
  const auto second = in_two.solve(step);
  const double way = first.creepage.longitudinal + second.creepage.longitudinal;
  EXPECT_NEAR(way, once.creepage.longitudinal, 1e-3 * way);
  EXPECT_EQ(second.slip_elements, once.slip_elements);
  EXPECT_LT(second.creepage.longitudinal, way);
}

/// Two steps of transient rolling of a sphere on a square grid.
ContactStepSolution rolled(ContactStep step, const Creepage& creepage, double heading) {
  step.motion.motion = ContactMotion::transient;
  step.motion.creepage = creepage;
  step.motion.heading = heading;
  step.motion.step = 0.13e-3;
  step.force_x.reset();
  ContactSequence sequence;
  sequence.solve(step);
  step.start = StepStart::previous;
  return sequence.solve(step);
}

/// x -> y, y -> -x: also for unlike bodies, a layer between them and friction that falls and has a memory.
TEST(ContactSequence, RollingAtAnAngleIsRollingAlongXTurned) {
  constexpr double right_angle = 1.5707963267948966;
  for (int variant = 0; variant < 4; ++variant) {
    ContactStep step = sphere(grid_of(18, -1.7e-3));
    if (variant == 1) step.bodies.material.dissimilarity = 0.15;
    if (variant == 2) step.bodies.layer.flexibility = 3e-13;
    if (variant == 3) {
      step.friction = {FrictionLaw::exponential(0.2, {.drop = 0.1, .half_velocity = 1e-3})};
      step.friction_memory = {1e-5, 1e-3};
    }
    const auto along_x = rolled(step, {8e-3, 4e-3, 0.5}, 0), along_y = rolled(step, {-4e-3, 8e-3, 0.5}, right_angle);
    const ContactForces a = along_x.forces(), b = along_y.forces();
    EXPECT_GT(along_x.slip_elements, 5) << variant;
    expect_forces(b, {-a.fy, a.fx, a.mz}, 1e-6 * force, 1e-9 * force, std::to_string(variant));
    EXPECT_EQ(along_y.slip_elements, along_x.slip_elements) << variant;
  }
}

/// A step of two elements obliquely: previous displacements are those of the elements that lie there.
TEST(ContactSequence, RollingAtAnAngleTakesDisplacementsFromWhereParticlesWere) {
  const ElementGrid grid = grid_of(18, -1.7e-3);
  ContactStep step = sphere(grid);
  step.motion.motion = ContactMotion::transient;
  step.motion.creepage = {1e-3, 0.5e-3, 0};
  step.motion.step = 0.2e-3 * std::sqrt(2);
  step.motion.heading = 0.78539816339744831;
  step.force_x.reset();
  ContactSequence sequence;
  const auto first = sequence.solve(step);
  step.start = StepStart::previous;
  const auto second = sequence.solve(step);
  for (int j = 4; j < 14; ++j)
    for (int i = 4; i < 14; ++i) {
      const auto k = static_cast<std::size_t>(j) * 18 + i, from = k + 18 + 1;
      if (!(second.normal.pressure[k] > 0)) continue;
      const VectorField &u = second.fields.displacement, &before = first.fields.displacement;
      EXPECT_NEAR(second.fields.slip.x[k], 1e-3 + (u.x[k] - before.x[from]) / step.motion.step, 1e-9);
      EXPECT_NEAR(second.fields.slip.y[k], 0.5e-3 + (u.y[k] - before.y[from]) / step.motion.step, 1e-9);
    }
}

TEST(ContactSequence, OnlyRollingHasAHeading) {
  ContactStep step = sphere(grid_of(18, -1.7e-3));
  step.motion.motion = ContactMotion::shift;
  step.motion.heading = 0.5;
  EXPECT_THROW(ContactSequence().solve(step), Error);
  step.motion.motion = ContactMotion::steady;
  EXPECT_EQ(ContactSequence().solve(step).report.status, Status::ok);
}

/// Fields and totals are those of both problems, also where nothing resists.
TEST(ContactSequence, ASolutionHasBothProblems) {
  for (const bool frictionless : {false, true})
    for (const double dissimilarity : {0.0, 0.1}) {
      ContactStep step = sphere(grid_of(18, -1.7e-3));
      step.frictionless = frictionless;
      step.bodies.material.dissimilarity = dissimilarity;
      const ContactStepSolution s = ContactSequence().solve(step);
      ASSERT_EQ(s.report.status, Status::ok);
      EXPECT_EQ(s.motion, ContactMotion::shift);
      EXPECT_EQ(s.elements.grid, step.grid);
      EXPECT_EQ(s.fields.pressure, s.normal.pressure);
      EXPECT_EQ(s.fields.gap, s.normal.gap);
      EXPECT_EQ(s.approach, s.normal.approach);
      EXPECT_EQ(s.totals.peak_pressure, s.normal.peak_pressure);
      EXPECT_NEAR(s.totals.fx, frictionless ? 0 : -0.2 * force, 1e-8 * force);
      const Totals summed = find_totals(s.elements, s.fields, s.creepage, 1);
      for (const auto total : {&Totals::fx, &Totals::fy, &Totals::mz, &Totals::my, &Totals::adhesion_area,
                               &Totals::slip_area, &Totals::frictional_power, &Totals::elastic_energy})
        EXPECT_EQ(s.totals.*total, summed.*total);
    }
}

TEST(ContactSequence, ARepeatedStepIsTheSame) {
  ContactSequence sequence;
  ContactStep step = sphere(grid_of(18, -1.7e-3));
  step.force_x = -0.1;
  sequence.solve(step);
  step.start = StepStart::previous;
  step.force_x = -0.2;
  const auto once = sequence.solve(step);
  step.start = StepStart::repeated;
  const auto again = sequence.solve(step);
  EXPECT_EQ(again.creepage.longitudinal, once.creepage.longitudinal);
  step.start = StepStart::fresh;
  EXPECT_GT(sequence.solve(step).creepage.longitudinal, 1.3 * once.creepage.longitudinal);
}

TEST(ContactSequence, RollingIsShiftsWithAGridThatFollows) {
  // In the frame of the contact, and in that of the bodies with the contact moving element by element.
  const ElementGrid grid = grid_of(20, -1.9e-3);
  ContactSequence rolling, shifting;
  const ContactStep start = sphere(grid);
  auto rolled = rolling.solve(start), shifted = shifting.solve(start);
  for (int k = 1; k <= 4; ++k) {
    ContactStep roll = start;
    roll.motion.motion = ContactMotion::transient;
    roll.start = StepStart::previous;
    rolled = rolling.solve(roll);
    ContactStep shift = start; // the contact has moved by k elements, and its grid with it
    shift.grid.x0 += k * grid.dx;
    shift.start = StepStart::previous;
    shifted = shifting.solve(shift);
    EXPECT_NEAR(shifted.creepage.longitudinal, rolled.creepage.longitudinal * grid.dx,
                1e-6 * rolled.creepage.longitudinal * grid.dx);
    EXPECT_EQ(shifted.adhesion_elements, rolled.adhesion_elements);
  }
}

TEST(ContactSequence, WarmStartsChangeNothing) {
  ContactSequence cold, warm;
  ContactStep step = sphere(grid_of(20, -1.9e-3));
  step.motion.motion = ContactMotion::steady;
  for (const double share : {-0.1, -0.15, -0.2}) {
    step.force_x = share;
    step.warm_start = false;
    const auto a = cold.solve(step);
    step.warm_start = true;
    const auto b = warm.solve(step);
    EXPECT_NEAR(b.creepage.longitudinal / a.creepage.longitudinal, 1, 1e-7);
  }
}

TEST(ContactSequence, TractionsMoveBetweenGrids) {
  const ElementGrid from{3, 2, 0, 0, 1, 1};
  const TangentialState state{.traction = {{1, 2, 3, 4, 5, 6}, {0, 1, 0, 0, 0, 0}}};
  ElementGrid to = from;
  EXPECT_EQ(moved_to(to, state, from).traction.x, state.traction.x);
  to.x0 = 1.0001; // as good as one element, from a file with few digits
  EXPECT_EQ(moved_to(to, state, from).traction.x, (std::vector<double>{2, 3, 0, 5, 6, 0}));
  to.x0 = -1, to.y0 = -1;
  EXPECT_EQ(moved_to(to, state, from).traction.x, (std::vector<double>{0, 0, 0, 0, 1, 2}));
  to.x0 = 0.25, to.y0 = 0.5;
  const VectorField between = moved_to(to, state, from).traction;
  EXPECT_DOUBLE_EQ(between.x[0], 0.5 * (0.75 * 1 + 0.25 * 2) + 0.5 * (0.75 * 4 + 0.25 * 5));
  EXPECT_DOUBLE_EQ(between.y[0], 0.125);
  to.x0 = 1e12;
  EXPECT_EQ(moved_to(to, state, from).traction.x, std::vector<double>(6, 0.0));
}

TEST(ContactSequence, AnExcludedRegionCarriesNothing) {
  // A flat punch, pressed on where it may touch.
  ContactStep step = sphere(grid_of(18, -1.7e-3));
  std::fill(step.gap.begin(), step.gap.end(), 0.0);
  step.excluded.assign(step.gap.size(), 1);
  for (int j = 5; j < 13; ++j)
    for (int i = 4; i < 12; ++i) step.excluded[static_cast<std::size_t>(j) * 18 + i] = 0;
  step.frictionless = true;
  const auto punch = ContactSequence().solve(step);
  ASSERT_EQ(punch.report.status, Status::ok);
  EXPECT_EQ(punch.contact_elements, 64);
  EXPECT_NEAR(punch.normal_force, force, 1e-9 * force);
  // The punch alone on a grid of its size.
  ContactStep alone = step;
  alone.grid = {8, 8, 0, 0, step.grid.dx, step.grid.dy};
  alone.gap.assign(64, 0.0);
  alone.excluded.clear();
  EXPECT_NEAR(punch.normal.approach / ContactSequence().solve(alone).normal.approach, 1, 1e-6);
}

TEST(ContactSequence, FrictionByRowsBoundsEachRow) {
  ContactStep step = sphere(grid_of(18, -1.7e-3));
  step.friction.clear();
  for (int j = 0; j < 18; ++j) step.friction.push_back(FrictionLaw::coulomb(0.01 * j));
  step.motion.motion = ContactMotion::steady;
  step.force_x.reset();
  step.motion.creepage.longitudinal = 0.1; // slides all over
  const auto s = ContactSequence().solve(step);
  double wanted = 0;
  for (std::size_t k = 0; k < step.gap.size(); ++k)
    wanted -= step.friction[k / 18].static_coefficient() * s.normal.pressure[k] * step.grid.element_area();
  EXPECT_NEAR(s.totals.fx / wanted, 1, 1e-4);
  EXPECT_EQ(s.adhesion_elements, 0);
}

TEST(ContactSequence, WithoutFrictionNothingResists) {
  ContactStep step = sphere(grid_of(18, -1.7e-3));
  step.friction = {FrictionLaw()};
  step.force_x.reset();
  step.motion.creepage.longitudinal = 1e-3;
  const auto sliding = ContactSequence().solve(step);
  EXPECT_EQ(sliding.totals.fx, 0);
  EXPECT_EQ(sliding.slip_elements, sliding.contact_elements);
  step.frictionless = true;
  const auto frictionless = ContactSequence().solve(step);
  EXPECT_EQ(frictionless.adhesion_elements, frictionless.contact_elements);
}

TEST(ContactSequence, AGivenPressureIsTaken) {
  ContactStep step = sphere(grid_of(18, -1.7e-3));
  const auto solved = ContactSequence().solve(step);
  step.given = GivenPressure{solved.normal.pressure, solved.normal.approach, solved.normal_force};
  const auto given = ContactSequence().solve(step);
  EXPECT_EQ(given.contact_elements, solved.contact_elements);
  EXPECT_NEAR(given.normal.elastic_energy / solved.normal.elastic_energy, 1, 1e-12);
  EXPECT_NEAR(given.creepage.longitudinal / solved.creepage.longitudinal, 1, 1e-8);
}

TEST(ContactSequence, RefusesFieldsOfAnotherSize) {
  ContactSequence sequence;
  ContactStep step = sphere(grid_of(18, -1.7e-3));
  step.gap.pop_back();
  EXPECT_THROW(sequence.solve(step), Error);
  step = sphere(grid_of(18, -1.7e-3));
  step.friction = {FrictionLaw::coulomb(0.1), FrictionLaw::coulomb(0.2)};
  EXPECT_THROW(sequence.solve(step), Error);
}

} // namespace
} // namespace microslip
