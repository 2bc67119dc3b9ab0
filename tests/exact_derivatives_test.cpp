// The Jacobian of the exact theory against differences of its forces.

#include "microslip/rolling/solver.hpp"
#include "validation/test_set.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace microslip {
namespace {

std::array<double, 3> components(const ContactForces& f, double length) {
  return {f.fx, f.fy, f.mz / length};
}

TEST(ExactDerivatives, AreThoseOfTheForces) {
  constexpr std::array members = {&Creepage::longitudinal, &Creepage::lateral, &Creepage::spin};
  constexpr std::array steps = {3e-8, 3e-8, 3e-6};
  for (const auto direction : {RollingDirection::forward, RollingDirection::backward})
    for (const std::size_t number : {500, 1510, 1700, 2310, 3000}) {
      Solver solver({.mx = 16, .my = 16});
      Solver precise({.mx = 16, .my = 16, .tolerance = 1e-11});
      const EllipticContact contact = validation::test_set_contacts()[number];
      const double length = std::sqrt(contact.a * contact.b);
      const ExactDerivatives d = solver.differentiate(rolling_problem(contact, {.direction = direction}));
      ASSERT_EQ(d.solution.report.status, Status::ok);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto forces = [&](double step) {
          EllipticContact moved = contact;
          moved.creepage.*members[i] += step;
          return components(precise.differentiate(rolling_problem(moved, {.direction = direction})).solution.forces(),
                            length);
        };
        const auto plus = forces(steps[i]), minus = forces(-steps[i]);
        const std::array column = {d.jacobian[0][i], d.jacobian[1][i], d.jacobian[2][i] / length};
        const double size = std::hypot(column[0], column[1], column[2]);
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_NEAR((plus[k] - minus[k]) / (2 * steps[i]), column[k], 1e-5 * size) << number << ' ' << i << k;
      }
    }
}

TEST(ExactDerivatives, VanishInFullSlidingAlongTheCreepage) {
  Solver solver({.mx = 8, .my = 8});
  EllipticContact contact = validation::test_set_contacts()[0];
  contact.creepage = {0.5, 0, 0};
  const ExactDerivatives d = solver.differentiate(rolling_problem(contact));
  const double limit = contact.friction.static_coefficient() * contact.normal_force;
  EXPECT_NEAR(d.jacobian[0][0], 0, 1e-3 * limit / 0.5);
  EXPECT_NEAR(d.jacobian[1][1], -limit / 0.5, 1e-2 * limit / 0.5); // the traction turns with the creepage
}

/// Lengths in units of 1e-20 and 1e20 of theirs, with the same pressures: forces go with the square, moments with the
/// cube, the spin's column with one power more than the others.
TEST(ExactDerivatives, DoNotDependOnTheUnitOfLength) {
  const EllipticContact contact = validation::test_set_contacts()[1700];
  const ExactDerivatives d = Solver({.mx = 12, .my = 12}).differentiate(rolling_problem(contact));
  for (const double unit : {1e-20, 1e20}) {
    EllipticContact other = contact;
    other.a *= unit;
    other.b *= unit;
    other.normal_force *= unit * unit;
    other.creepage.spin /= unit;
    const ExactDerivatives moved = Solver({.mx = 12, .my = 12}).differentiate(rolling_problem(other));
    ASSERT_EQ(moved.solution.report.status, Status::ok);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        const double scale = std::pow(unit, 2 + (k == 2) + (i == 2));
        EXPECT_NEAR(moved.jacobian[k][i] / scale, d.jacobian[k][i], 1e-5 * std::abs(d.jacobian[k][k])) << k << i;
      }
  }
}

TEST(ExactDerivatives, BadInputIsMarked) {
  EllipticContact contact = validation::test_set_contacts()[500];
  contact.normal_force = -1;
  EXPECT_EQ(Solver({.mx = 8, .my = 8}).differentiate(rolling_problem(contact)).solution.report.status,
            Status::invalid_input);
}

} // namespace
} // namespace microslip
