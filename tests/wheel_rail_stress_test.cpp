// Stresses inside wheel and rail below their patches.

#include "microslip/elasticity/hertz.hpp"
#include "microslip/elasticity/stress.hpp"
#include "microslip/interior/interior_grid.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/rolling/solver.hpp"

#include "tests/support/sphere_on_rail.hpp"
#include "tests/support/steel.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double load = 5e3, radius = 0.1, friction = 0.3;

/// A sphere on a rail with a top of this radius.
WheelRail sphere_with_fields(Theory theory, double head) {
  return WheelRail(sphere_on_rail(radius, head, 0.02), {.theory = theory, .elements = 32, .fields = true});
}

/// Rolling with a creepage, or none.
WheelRailSolution solution_of(Theory theory, double head, double creepage) {
  WheelState<double> state;
  state.forward_velocity = 2, state.pitch_velocity = 2 / radius * (1 - creepage);
  return sphere_with_fields(theory, head).solve(state, load);
}

double error_of(Theory theory) {
  return theory == Theory::exact ? 0.003 : 0.025;
}

// Johnson 1985, (3.45): below the middle of a circle, with z in radii.
TEST(WheelRailStress, IsHertzsBelowTheMiddleOfACircle) {
  const double flat = 1e3;
  const HertzContact hertz =
      hertz_from_load(gap_curvatures({radius, std::numeric_limits<double>::infinity(), radius, flat}), steel, load);
  for (const Theory theory : {Theory::fastsim2, Theory::exact}) {
    const WheelRailSolution s = solution_of(theory, flat, 0);
    ASSERT_EQ(s.fields.size(), 1u);
    const double p0 = hertz.peak_pressure, nu = steel_body.poisson_ratio;
    for (const double depth : {0.5, 0.8, 1.5, -0.5, -1.0}) {
      const double d = std::abs(depth);
      const auto states = interior_states(steel_body, steel_body, s.fields[0], {{0}, {0}, {depth * hertz.a}});
      const double along = -p0 / (1 + d * d), across = -p0 * (1 + nu) * (1 - d * std::atan(1 / d)) - along / 2;
      EXPECT_NEAR(states[0].stress.zz / p0, along / p0, error_of(theory)) << depth;
      EXPECT_NEAR(states[0].stress.xx / p0, across / p0, error_of(theory)) << depth;
      EXPECT_NEAR(states[0].stress.yy / p0, across / p0, error_of(theory)) << depth;
    }
  }
}

TEST(WheelRailStress, IsThatOfThePlainContactWithTheSameEllipse) {
  const HertzContact hertz =
      hertz_from_load(gap_curvatures({radius, std::numeric_limits<double>::infinity(), radius, radius}), steel, load);
  for (const Theory theory : {Theory::fastsim2, Theory::exact}) {
    const WheelRailSolution s = solution_of(theory, radius, 1e-3);
    ASSERT_EQ(s.fields.size(), 1u);
    const ContactSolution plain = Solver({.mx = 32, .my = 32})
                                      .solve(rolling_problem({.a = hertz.a,
                                                              .b = hertz.b,
                                                              .shear_modulus = steel_body.shear_modulus,
                                                              .poisson_ratio = steel_body.poisson_ratio,
                                                              .normal_force = load,
                                                              .friction = FrictionLaw::coulomb(friction),
                                                              .creepage = s.patches[0].creepage,
                                                              .rolling_speed = 2}));
    const InteriorGrid points{{-0.7 * hertz.a, 0, 0.8 * hertz.a}, {0, 0.4 * hertz.b}, {0.4 * hertz.a, -0.8 * hertz.a}};
    const auto there = interior_states(steel_body, steel_body, plain, points),
               here = interior_states(steel_body, steel_body, s.fields[0], points);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t k = 0; k < here.size(); ++k) {
      const Stress &a = here[k].stress, &b = there[k].stress;
      for (const auto part : {&Stress::xx, &Stress::yy, &Stress::zz, &Stress::xy, &Stress::xz, &Stress::yz})
        EXPECT_NEAR(a.*part / hertz.peak_pressure, b.*part / hertz.peak_pressure, error_of(theory)) << k;
      EXPECT_NEAR(von_mises(a) / von_mises(b), 1, 3 * error_of(theory)) << k;
    }
  }
}

// What is far away feels the force only: Boussinesq.
TEST(WheelRailStress, FarBelowIsThatOfAPointForce) {
  constexpr double pi = 3.14159265358979323846;
  for (const Theory theory : {Theory::fastsim2, Theory::exact}) {
    const WheelRailSolution s = solution_of(theory, radius, 0);
    const double depth = 0.05;
    const auto states = interior_states(steel_body, steel_body, s.fields[0], {{0}, {0}, {depth}});
    EXPECT_NEAR(states[0].stress.zz, -3 * s.patches[0].normal_force / (2 * pi * depth * depth),
                1e-3 * load / depth / depth);
  }
}

} // namespace
} // namespace microslip
