// Friction that falls with the slip velocity, in the simplified theory: at each point with the velocity of the rigid
// slip.

#include "microslip/simplified/row_solver.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/test_cases.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

struct NamedLaw {
  std::string name;
  std::function<FrictionLaw(double kinetic, double drop)> make;
};

/// Laws of every kind with velocities of the size that the test cases have at V = 1 m/s.
std::vector<NamedLaw> laws() {
  return {{"linear", [](double kinetic,
                        double drop) { return FrictionLaw::linear(kinetic, {.drop = drop, .half_velocity = 2e-3}); }},
          {"rational",
           [](double kinetic, double drop) {
             return FrictionLaw::rational(kinetic, {.drop = drop / 2, .half_velocity = 1e-3},
                                          {.drop = drop / 2, .half_velocity = 5e-3});
           }},
          {"exponential", [](double kinetic, double drop) {
             return FrictionLaw::exponential(kinetic, {.drop = drop, .half_velocity = 1e-3});
           }}};
}

TEST(FallingFriction, WithoutADropIsCoulombFriction) {
  const auto cases = every_nth_case(61);
  for (RowSolver& solver : all_solvers(6, 7)) {
    SCOPED_TRACE(describe(solver));
    for (EllipticContact contact : cases) {
      const ContactForces coulomb = solver.solve(contact);
      for (const auto& [name, make] : laws()) {
        SCOPED_TRACE(name);
        contact.friction = make(0.3, 0);
        const ContactForces f = solver.solve(contact);
        const double force = friction_force(contact);
        expect_forces(f, coulomb, 1e-14 * force, 1e-14 * friction_moment(contact));
      }
    }
  }
}

TEST(FallingFriction, FullSlidingWithoutSpinGivesTheCoefficientOfItsVelocity) {
  for (RowSolver& solver : all_solvers(6, 7)) {
    SCOPED_TRACE(describe(solver));
    for (const auto& [name, make] : laws())
      for (const double speed : {0.01, 1.0, 60.0}) {
        SCOPED_TRACE(name);
        EllipticContact contact = test_cases()[0];
        contact.friction = make(0.1, 0.3);
        contact.rolling_speed = speed;
        contact.creepage = {0.05, 0.08, 0};
        const double friction = contact.friction.coefficient(std::hypot(0.05, 0.08) * speed);
        const ContactForces f = solver.solve(contact);
        EXPECT_NEAR(std::hypot(f.fx, f.fy), friction * contact.normal_force, 1e-14 * contact.normal_force);
      }
  }
}

/// FASTSIM as one would write it down first, (F16), with the bound at each point's friction.
struct PlainForces {
  double fx = 0, fy = 0, mz = 0;
};
PlainForces plain_fastsim(const EllipticContact& c, const SimplifiedOptions& options) {
  const Flexibilities l = flexibilities(options.flexibility, {}, c);
  const double sign = options.direction == RollingDirection::forward ? 1 : -1;
  const auto& [xi, eta, phi] = c.creepage;
  PlainForces f;
  double load = 0;
  for (int j = 0; j < options.my; ++j) {
    const double y = -c.b + (j + 0.5) * 2 * c.b / options.my, edge = c.a * std::sqrt(1 - y * y / (c.b * c.b));
    const double cell = 2 * edge / options.mx;
    double px = 0, py = 0;
    for (int i = 0; i < options.mx; ++i) {
      const double x = sign * (edge - (i + 0.5) * cell);
      const double friction = c.friction.coefficient(std::hypot(xi - phi * y, eta + phi * x) * c.rolling_speed);
      const double pressure = traction_bound(options.bound, c.a, c.b, c.normal_force, 1, x, y);
      px -= cell * (xi / l.longitudinal - y * phi / l.spin);
      py -= cell * (eta / l.lateral + x * phi / l.spin);
      const double share = friction * pressure / std::hypot(px, py);
      if (share < 1) {
        px *= share;
        py *= share;
      }
      f.fx += cell * px;
      f.fy += cell * py;
      f.mz += cell * (x * py - y * px);
      load += cell * pressure;
    }
  }
  const double exact = c.normal_force / load;
  return {f.fx * exact, f.fy * exact, f.mz * exact};
}

TEST(FallingFriction, AgreesWithThePlainAlgorithm) {
  for (RowSolver& solver : all_solvers(6, 7)) {
    if (solver.scheme() != MarchingScheme::fastsim) continue;
    SCOPED_TRACE(describe(solver));
    for (EllipticContact contact : every_nth_case(19))
      for (const auto& [name, make] : laws()) {
        contact.friction = make(0.1, 0.3);
        const ContactForces f = solver.solve(contact);
        const PlainForces plain = plain_fastsim(contact, solver.options());
        expect_forces(f, plain, 1e-13 * friction_force(contact), 1e-13 * friction_moment(contact));
      }
  }
}

/// Force of a contact with creepage along x only.
double longitudinal_force(RowSolver& solver, const FrictionLaw& law, double creepage, double speed) {
  static const EllipticContact first = test_cases()[0];
  EllipticContact contact = first;
  contact.friction = law;
  contact.creepage = {creepage, 0, 0};
  contact.rolling_speed = speed;
  return -solver.solve(contact).fx;
}

/// The more a law falls, and the faster the bodies roll, the smaller the force.
TEST(FallingFriction, LowersTheForce) {
  for (RowSolver& solver : all_solvers(10, 7)) {
    SCOPED_TRACE(describe(solver));
    for (const auto& [name, make] : laws())
      for (const double creepage : {3e-4, 1e-3, 3e-3, 1e-2}) {
        SCOPED_TRACE(name);
        double previous = longitudinal_force(solver, FrictionLaw::coulomb(0.3), creepage, 1);
        for (const double drop : {0.05, 0.1, 0.2, 0.28}) {
          const double force = longitudinal_force(solver, make(0.3 - drop, drop), creepage, 1);
          EXPECT_LE(force, previous);
          EXPECT_GT(force, 0);
          previous = force;
        }
        previous = longitudinal_force(solver, make(0.1, 0.2), creepage, 0.01);
        for (const double speed : {0.1, 1.0, 10.0, 100.0}) {
          const double force = longitudinal_force(solver, make(0.1, 0.2), creepage, speed);
          EXPECT_LE(force, previous);
          previous = force;
        }
      }
  }
}

/// Coulomb friction makes the creep curve rise to the end; a falling law makes it fall after a maximum.
TEST(FallingFriction, GivesTheCreepCurveAMaximum) {
  for (const auto scheme : all_schemes) {
    RowSolver solver(scheme, {});
    for (const auto& [name, make] : laws()) {
      const auto force = [&solver, &make = make](double creepage) {
        return longitudinal_force(solver, make(0.1, 0.3), creepage, 0.2);
      };
      EXPECT_LT(force(1e-4), 0.5 * force(2e-3));
      EXPECT_GT(force(2e-3), 1.5 * force(5e-2));
    }
  }
}

} // namespace
} // namespace microslip
