// Creepages that go with prescribed forces, by the solvers of the simplified theory on an ellipse.

#include "microslip/simplified/prescribed_forces.hpp"

#include "microslip/simplified/fastsim.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "tests/support/steel.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace microslip {
namespace {

EllipticContact contact_with(const Creepage& creepage) {
  return steel_contact(6e-3, 4e-3, 8e4, creepage);
}

SimplifiedOptions options() {
  SimplifiedOptions o;
  o.mx = 20;
  o.my = 15;
  return o;
}

/// The creepages of the forces that creepages give are these.
void expect_back(RowSolver&& solver) {
  for (const Creepage& c : {Creepage{1e-3, 0, 0}, {-4e-4, 8e-4, 0}, {1e-3, -5e-4, 0.4}, {3e-3, 2e-3, -0.3}}) {
    const ContactForces forces = solver.solve(contact_with(c));
    const FoundCreepage found = find_creepage(solver, contact_with({0.1, 0.2, c.spin}), {forces.fx, forces.fy});
    EXPECT_EQ(found.status, Status::ok);
    EXPECT_LT(found.residual, 1e-9);
    EXPECT_NEAR(found.creepage.longitudinal, c.longitudinal, 1e-9);
    EXPECT_NEAR(found.creepage.lateral, c.lateral, 1e-9);
    EXPECT_EQ(found.creepage.spin, c.spin);
  }
}

TEST(PrescribedForces, Fastsim2) {
  expect_back(Fastsim2(options()));
}

TEST(PrescribedForces, Fastsim) {
  expect_back(Fastsim(options()));
  expect_back(Fastsim(options(), FirstStep::half));
}

/// Fx = -G ab C11 xi without slip; the lateral creepage is that of the contact, as is the longitudinal one with Fy.
TEST(PrescribedForces, OneForceLeavesTheOtherCreepage) {
  Fastsim2 solver(options());
  const EllipticContact contact = contact_with({2e-4, -3e-4, 0});
  const FoundCreepage x = find_creepage(solver, contact, {.x = -9e3});
  EXPECT_EQ(x.status, Status::ok);
  EXPECT_EQ(x.creepage.lateral, -3e-4);
  EXPECT_NEAR(solver.solve(contact_with(x.creepage)).fx, -9e3, 1e-4);
  const FoundCreepage y = find_creepage(solver, contact, {.y = 5e3});
  EXPECT_EQ(y.status, Status::ok);
  EXPECT_EQ(y.creepage.longitudinal, 2e-4);
  EXPECT_NEAR(solver.solve(contact_with(y.creepage)).fy, 5e3, 1e-4);
  const FoundCreepage small = find_creepage(solver, contact_with({}), {.x = -1e-3}, 1e-15);
  const double c11 = creepage_coefficients(1.5, 0.28).c11;
  EXPECT_NEAR(small.creepage.longitudinal / (1e-3 / (82e9 * 24e-6 * c11)), 1, 2e-3);
}

TEST(PrescribedForces, NothingPrescribedIsTheContactAsItIs) {
  Fastsim2 solver(options());
  EXPECT_EQ(find_creepage(solver, contact_with({1e-3, 2e-3, 0.1}), {}).creepage.lateral, 2e-3);
}

/// Up to nearly all that friction bears, and not beyond.
TEST(PrescribedForces, UpToFullSliding) {
  Fastsim2 solver(options());
  for (const double share : {0.9, 0.99, 0.9999}) {
    const FoundCreepage found = find_creepage(solver, contact_with({}), {-share * 2.4e4, 0});
    EXPECT_EQ(found.status, Status::ok) << share;
    EXPECT_NEAR(solver.solve(contact_with(found.creepage)).fx, -share * 2.4e4, 1e-4);
  }
  const FoundCreepage beyond = find_creepage(solver, contact_with({0, 0, 0.1}), {-1.8e4, 2.4e4});
  EXPECT_EQ(beyond.status, Status::no_solution);
  EXPECT_NEAR(beyond.residual, 0.25, 1e-12);
  EXPECT_EQ(beyond.creepage.spin, 0.1);
}

/// A jump in the force has no creepage.
TEST(PrescribedForces, WhatIsNotFoundIsSaid) {
  const auto jump = [](const Creepage& c) -> ContactForces { return {.fx = c.longitudinal < 1 ? 0 : -1.0}; };
  EXPECT_EQ(find_creepage(jump, {-0.5, 0}, {}, 1, 1, 1e-9).status, Status::not_converged);
}

} // namespace
} // namespace microslip
