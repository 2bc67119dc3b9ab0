#include "microslip/simplified/row_solver.hpp"
#include "tests/test_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Derivatives of (Fx, Fy)/(mu Fn) and Mz/(mu Fn c), c = sqrt(ab), to the inputs over their characteristic sizes: the
/// creepages at which linear theory saturates, and Fn itself.
using Jacobian = std::array<std::array<double, 4>, 3>;
using Inputs = std::array<double, 4>;

Inputs characteristic_inputs(const EllipticContact& contact) {
  const Creepage unit = saturating_creepage(contact);
  return {unit.longitudinal, unit.lateral, unit.spin, contact.normal_force};
}

EllipticContact moved(EllipticContact contact, int input, double by) {
  Creepage& c = contact.creepage;
  (input == 0 ? c.longitudinal : input == 1 ? c.lateral : input == 2 ? c.spin : contact.normal_force) += by;
  return contact;
}

Jacobian jacobian(RowSolver& solver, const EllipticContact& contact) {
  const auto d = solver.differentiate(contact);
  const Inputs size = characteristic_inputs(contact);
  Jacobian result{};
  for (int n = 0; n < 3; ++n)
    for (int k = 0; k < 4; ++k)
      result[n][k] = d.jacobian[n][k] * size[k] / (n == 2 ? friction_moment(contact) : friction_force(contact));
  return result;
}

Jacobian central_differences(RowSolver& solver, const EllipticContact& contact, double step) {
  const Inputs size = characteristic_inputs(contact);
  Jacobian result{};
  for (int k = 0; k < 4; ++k) {
    const auto less = solver.solve(moved(contact, k, -step * size[k]));
    const auto more = solver.solve(moved(contact, k, step * size[k]));
    const double force = 2 * step * friction_force(contact), moment = 2 * step * friction_moment(contact);
    result[0][k] = (more.fx - less.fx) / force;
    result[1][k] = (more.fy - less.fy) / force;
    result[2][k] = (more.mz - less.mz) / moment;
  }
  return result;
}

/// Not a number if one of the derivatives is not.
double distance(const Jacobian& one, const Jacobian& other) {
  double sum = 0;
  for (int n = 0; n < 3; ++n)
    for (int k = 0; k < 4; ++k) sum += std::pow(one[n][k] - other[n][k], 2);
  return std::sqrt(sum);
}

std::vector<EllipticContact> random_contacts(bool falling_friction) {
  RandomContacts random(61);
  std::vector<EllipticContact> contacts;
  for (int k = 0; k < 150; ++k) {
    contacts.push_back(random.next());
    EllipticContact& contact = contacts.back();
    if (!falling_friction) continue;
    const double speed = contact.rolling_speed * random.about(0.3, 3) * saturating_creepage(contact).longitudinal;
    const FrictionTerm first{.drop = 0.3, .half_velocity = speed}, second{.drop = 0.1, .half_velocity = 5 * speed};
    contact.friction = k % 3 == 0   ? FrictionLaw::linear(0.1, first, second)
                       : k % 3 == 1 ? FrictionLaw::rational(0.1, first, second)
                                    : FrictionLaw::exponential(0.1, first, second);
  }
  return contacts;
}

/// The forces have a kink wherever a cell changes between adhesion and slip. Where central differences with two steps
/// agree there is none, and the derivatives must be these differences; that must be nearly everywhere.
void expect_central_differences(RowSolver& solver, const std::vector<EllipticContact>& contacts) {
  SCOPED_TRACE(describe(solver));
  constexpr double step = 1e-6, kink = 1e-7;
  std::size_t smooth = 0;
  for (const EllipticContact& contact : contacts) {
    const Jacobian coarse = central_differences(solver, contact, step);
    const Jacobian fine = central_differences(solver, contact, step / 2);
    if (distance(coarse, fine) > kink) continue;
    ++smooth;
    ASSERT_LT(distance(jacobian(solver, contact), fine), 1e-7) << describe(contact);
  }
  EXPECT_GE(smooth, contacts.size() * 95 / 100);
}

/// All solvers on two grids, with and without slope reduction.
std::vector<RowSolver> solvers() {
  std::vector<RowSolver> solvers;
  for (const auto& [mx, my] : {std::pair{8, 7}, std::pair{2, 3}})
    for (const RowSolver& solver : all_solvers(mx, my)) {
      solvers.push_back(solver);
      SimplifiedOptions options = solver.options();
      options.slope_reduction = {.initial = 0.6, .at_infinity = 0.4, .decay = 0.7};
      solvers.emplace_back(solver.scheme(), options);
    }
  return solvers;
}

TEST(Jacobian, IsTheSlopeOfTheForcesUnderCoulombFriction) {
  const auto contacts = random_contacts(false);
  for (RowSolver& solver : solvers()) expect_central_differences(solver, contacts);
}

TEST(Jacobian, IsTheSlopeOfTheForcesUnderFallingFriction) {
  const auto contacts = random_contacts(true);
  for (RowSolver& solver : solvers()) expect_central_differences(solver, contacts);
}

/// In full sliding without spin the force is -mu Fn w/|w|: its derivatives in closed form. With three
/// flexibilities it points elsewhere.
TEST(Jacobian, OfFullSlidingIsKnown) {
  for (RowSolver& solver : all_solvers(5, 4)) {
    if (solver.options().flexibility == FlexibilityModel::three) continue;
    SCOPED_TRACE(describe(solver));
    EllipticContact contact = every_nth_case(644)[3];
    const double force = friction_force(contact), size = 5.0, xi = 3.0, eta = -4.0;
    contact.creepage = {xi, eta, 0};
    const auto d = solver.differentiate(contact);
    const double expected[2][4] = {
        {-force * eta * eta / std::pow(size, 3), force * xi * eta / std::pow(size, 3), 0, -0.3 * xi / size},
        {force * xi * eta / std::pow(size, 3), -force * xi * xi / std::pow(size, 3), 0, -0.3 * eta / size}};
    for (int n = 0; n < 2; ++n)
      for (const int k : {0, 1, 3})
        EXPECT_NEAR(d.jacobian[n][k], expected[n][k], 1e-6 * (k == 3 ? 0.3 : force / size)) << n << " " << k;
  }
}

} // namespace
} // namespace microslip
