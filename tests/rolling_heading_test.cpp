// Steady rolling in any direction of the grid.

#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/rolled.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double pi = std::numbers::pi;

/// An ellipse on nx x ny elements, rolling at an angle to the x axis.
ContactStep rolling(double a, double b, int nx, int ny, double heading, double dissimilarity = 0) {
  const CombinedMaterial material = {82e9, 0.28, dissimilarity};
  ContactStep s;
  s.bodies = material;
  s.grid = ElementGrid::across_ellipse(a, b, nx, ny, 2);
  const HertzContact hertz = hertz_from_ellipse(a, b, material, 50e3);
  s.gap = over_grid(s.grid,
                    [&](double x, double y) { return hertz.gap.x * std::pow(x, 2) + hertz.gap.y * std::pow(y, 2); });
  s.load = {NormalLoad::Given::force, 50e3};
  s.friction = {FrictionLaw::coulomb(0.3)};
  s.motion.heading = heading;
  s.motion.tolerance = 1e-10;
  return s;
}

ContactForces forces_of(const ContactStep& step) {
  const ContactStepSolution s = ContactSequence().solve(step);
  EXPECT_EQ(s.report.status, Status::ok);
  return s.forces();
}

/// Rolling along y is rolling along x of the contact turned by a right angle, element by element.
TEST(RollingHeading, AQuarterTurnTurnsTheSolution) {
  for (const double dissimilarity : {0.0, 0.2}) {
    ContactStep along_x = rolling(4e-3, 6e-3, 12, 10, 0, dissimilarity);
    ContactStep along_y = rolling(6e-3, 4e-3, 10, 12, pi / 2, dissimilarity);
    const double step = along_x.grid.dx;
    along_x.motion.step = along_y.motion.step = step;
    along_x.motion.creepage = {1e-3, -5e-4, 0.3};
    along_y.motion.creepage = {5e-4, 1e-3, 0.3}; // (x, y) turned to (-y, x)
    const ContactForces x = forces_of(along_x), y = forces_of(along_y);
    const double rounding = 1e-7 * 0.3 * 50e3;
    EXPECT_GT(std::hypot(x.fx, x.fy), 0.1 * 0.3 * 50e3);
    expect_forces(y, {-x.fy, x.fx, x.mz}, rounding, rounding * 5e-3);
  }
}

/// A half turn is rolling backward.
TEST(RollingHeading, AHalfTurnRollsBackward) {
  ContactStep turned = rolling(4e-3, 6e-3, 12, 10, pi), backward = rolling(4e-3, 6e-3, 12, 10, 0);
  backward.motion.direction = RollingDirection::backward;
  turned.motion.creepage = backward.motion.creepage = {1e-3, -5e-4, 0.3};
  const ContactForces a = forces_of(turned), b = forces_of(backward);
  EXPECT_NEAR(a.fx, b.fx, 1e-6 * std::abs(b.fx));
  EXPECT_NEAR(a.fy, b.fy, 1e-6 * std::abs(b.fx));
}

/// A circle has no direction: forces turn with the creepages, up to the discretisation.
TEST(RollingHeading, TurnsWithTheCreepageOnACircle) {
  double last = 1;
  for (const int n : {12, 24}) {
    ContactStep along = rolling(5e-3, 5e-3, n, n, 0), turned = rolling(5e-3, 5e-3, n, n, pi / 4);
    along.motion.creepage = {1e-3, 0, 0};
    turned.motion.creepage = {1e-3 * std::cos(pi / 4), 1e-3 * std::sin(pi / 4), 0};
    const ContactForces x = forces_of(along), y = forces_of(turned);
    const double across = std::abs(y.fx - y.fy), error = std::abs(std::hypot(y.fx, y.fy) / std::abs(x.fx) - 1);
    EXPECT_LT(across, 1e-6 * std::abs(x.fx));
    EXPECT_LT(error, last);
    last = 0.7 * error;
  }
  EXPECT_LT(last, 0.01);
}

/// Transient rolling at an angle ends there.
TEST(RollingHeading, IsTheEndOfTransientRolling) {
  ContactStep step = rolling(4e-3, 6e-3, 10, 10, 0.6);
  step.motion.creepage = {1e-3, -5e-4, 0.3};
  const ContactForces steady = forces_of(step);
  const ContactStepSolution s = rolled(step, 40);
  ASSERT_EQ(s.report.status, Status::ok);
  EXPECT_NEAR(s.totals.fx, steady.fx, 2e-2 * std::abs(steady.fx)); // tractions between elements' centres
  EXPECT_NEAR(s.totals.fy, steady.fy, 2e-2 * std::abs(steady.fx));
}

TEST(RollingHeading, RefusesWhatGoesAlongRows) {
  ContactStep step = rolling(4e-3, 6e-3, 8, 8, 0.6);
  step.bodies.layer = {.flexibility = 0, .yield_stress = 1e8};
  expect_error([&] { ContactSequence().solve(step); }, "heading", "[rad]");
  step = rolling(4e-3, 6e-3, 8, 8, 0.6);
  step.friction = {FrictionLaw::linear(0.2, {.drop = 0.1, .half_velocity = 1})};
  EXPECT_EQ(ContactSequence().solve(step).report.status, Status::ok);
  step.friction_memory = {.distance = 1e-4, .slowest = 0};
  expect_error([&] { ContactSequence().solve(step); }, "heading", "[rad]");
}

} // namespace
} // namespace microslip
