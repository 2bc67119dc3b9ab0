// Seeded problems of all kinds, from a cold start to a residual of 1e-10, and what does not depend on how they are put.

#include "random_friction_cases.hpp"
#include "tangential_cases.hpp"
#include "tests/oracles/active_set_tangential.hpp"
#include "tests/oracles/convex_gauss_seidel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

namespace microslip {
namespace {

constexpr ContactMotion motions[] = {ContactMotion::shift, ContactMotion::transient, ContactMotion::steady};

/// Calls check(case, its solution) for n seeded cases of each motion.
template <class Check> void for_random_cases(unsigned seed, int n, Check check) {
  RandomContacts random(seed);
  for (int k = 0; k < n; ++k)
    for (const ContactMotion motion : motions) {
      const FrictionCase c = random_friction_case(random, motion);
      SCOPED_TRACE(std::to_string(k) + ", motion " + std::to_string(static_cast<int>(motion)) + ": " + c.name);
      if (c.capacity() > 0) check(c, c.by_newton());
    }
}

double difference(const Field& a, const Field& b, int sign = 1) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += std::pow(a[k] - sign * b[k], 2);
  return std::sqrt(sum);
}

/// The case with element (i, j) at to(i, j) of another grid, x and y components changed as sign_x, sign_y say.
template <class To>
FrictionCase rearranged(const FrictionCase& c, const ElementGrid& grid, int sign_x, int sign_y, To to) {
  FrictionCase r = c;
  r.grid = grid;
  const auto moved = [&](const Field& field, int sign) {
    Field image(field.size());
    for (int j = 0; j < c.grid.my; ++j)
      for (int i = 0; i < c.grid.mx; ++i) image[to(i, j)] = sign * field[static_cast<std::size_t>(j) * c.grid.mx + i];
    return image;
  };
  r.bound = moved(c.bound, 1);
  r.input.creepage.longitudinal *= sign_x;
  r.input.creepage.lateral *= sign_y;
  r.input.creepage.spin *= sign_x * sign_y;
  if (c.input.force_x) *r.input.force_x *= sign_x;
  if (c.input.force_y) *r.input.force_y *= sign_y;
  if (c.before) {
    r.before = std::make_shared<VectorField>(VectorField{moved(c.before->x, sign_x), moved(c.before->y, sign_y)});
    r.input.previous = r.before.get();
  }
  return r;
}

/// Both solutions are the same but for 1e-6 of the bound, `r` being that of a rearranged case.
template <class To>
void expect_same(const FrictionCase& c, const ContactSolution& s, const ContactSolution& r, int sign_x, int sign_y,
                 To to) {
  ASSERT_EQ(r.report.status, Status::ok);
  const double tolerance = 1e-6 * norm(c.bound);
  double sum = 0;
  for (int j = 0; j < c.grid.my; ++j)
    for (int i = 0; i < c.grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * c.grid.mx + i;
      sum += std::pow(r.fields.traction.x[to(i, j)] - sign_x * s.fields.traction.x[k], 2) +
             std::pow(r.fields.traction.y[to(i, j)] - sign_y * s.fields.traction.y[k], 2);
    }
  EXPECT_LE(std::sqrt(sum), tolerance);
  EXPECT_NEAR(r.totals.fx, sign_x * s.totals.fx, 1e-6 * c.capacity());
  EXPECT_NEAR(r.totals.fy, sign_y * s.totals.fy, 1e-6 * c.capacity());
  EXPECT_NEAR(r.totals.elastic_energy, s.totals.elastic_energy, 1e-5 * s.totals.elastic_energy);
}

/// Bound kept, no slip in adhesion, slip against the traction, forces as given, energy and power of the right sign.
TEST(ExactRandom, ConvergesFromAColdStartAndObeysAllConditions) {
  for_random_cases(1, 40, [](const FrictionCase& c, const ContactSolution& s) {
    const double length = -c.grid.x0 + c.grid.dx / 2;
    expect_solution({c.material, c.grid, c.bound, c.capacity(), length}, c.input, s);
    EXPECT_LE(s.report.residual, 1e-10);
    const double slip_unit = 1e-9 * norm(c.bound) * c.response().diagonal();
    EXPECT_GE(s.totals.frictional_power, -slip_unit * c.capacity());
    EXPECT_GE(s.totals.elastic_energy, 0);
  });
}

/// Many more, by their residuals only.
TEST(ExactRandom, ConvergesFromAColdStart) {
  int most = 0;
  for_random_cases(2, 300, [&](const FrictionCase&, const ContactSolution& s) {
    ASSERT_EQ(s.report.status, Status::ok);
    ASSERT_LE(s.report.residual, 1e-10);
    most = std::max(most, s.report.newton_steps);
  });
  EXPECT_LT(most, 100);
}

TEST(ExactRandom, MirrorInY) {
  for_random_cases(3, 20, [](const FrictionCase& c, const ContactSolution& s) {
    const auto to = [&](int i, int j) { return static_cast<std::size_t>(c.grid.my - 1 - j) * c.grid.mx + i; };
    expect_same(c, s, rearranged(c, c.grid, 1, -1, to).by_newton(), 1, -1, to);
  });
}

/// Elements in reverse order along x: rolling in the opposite direction.
TEST(ExactRandom, MirrorInX) {
  for_random_cases(4, 20, [](const FrictionCase& c, const ContactSolution& s) {
    const auto to = [&](int i, int j) { return static_cast<std::size_t>(j) * c.grid.mx + (c.grid.mx - 1 - i); };
    FrictionCase r = rearranged(c, c.grid, -1, 1, to);
    r.input.direction = c.input.direction == forward ? backward : forward;
    expect_same(c, s, r.by_newton(), -1, 1, to);
  });
}

/// All elements in reverse order: the contact turned by half a turn.
TEST(ExactRandom, HalfATurn) {
  for_random_cases(5, 20, [](const FrictionCase& c, const ContactSolution& s) {
    const auto to = [&](int i, int j) { return c.grid.count() - 1 - (static_cast<std::size_t>(j) * c.grid.mx + i); };
    FrictionCase r = rearranged(c, c.grid, -1, -1, to);
    r.input.direction = c.input.direction == forward ? backward : forward;
    expect_same(c, s, r.by_newton(), -1, -1, to);
  });
}

/// Rows become columns; a shift has no direction of rolling.
TEST(ExactRandom, TransposedShifts) {
  for_random_cases(6, 20, [](const FrictionCase& c, const ContactSolution& s) {
    if (c.input.motion != ContactMotion::shift) return;
    const ElementGrid grid{c.grid.my, c.grid.mx, c.grid.y0, c.grid.x0, c.grid.dy, c.grid.dx, false};
    const auto to = [&](int i, int j) { return static_cast<std::size_t>(i) * c.grid.my + j; };
    FrictionCase r = rearranged(c, grid, 1, 1, to);
    std::swap(r.input.creepage.longitudinal, r.input.creepage.lateral);
    r.input.creepage.spin *= -1;
    std::swap(r.input.force_x, r.input.force_y);
    if (r.before) std::swap(r.before->x, r.before->y);
    ContactSolution turned = r.by_newton();
    std::swap(turned.fields.traction.x, turned.fields.traction.y);
    std::swap(turned.totals.fx, turned.totals.fy);
    expect_same(c, s, turned, 1, 1, to);
  });
}

TEST(ExactRandom, UnitsDoNotMatter) {
  const double length = 1e3, pressure = 1e-6; // mm and N
  for_random_cases(7, 20, [&](const FrictionCase& c, const ContactSolution& s) {
    FrictionCase r =
        rearranged(c, c.grid, 1, 1, [&](int i, int j) { return static_cast<std::size_t>(j) * c.grid.mx + i; });
    for (double* value : {&r.grid.x0, &r.grid.y0, &r.grid.dx, &r.grid.dy, &r.input.step}) *value *= length;
    r.material.shear_modulus *= pressure;
    for (double& g : r.bound) g *= pressure;
    if (r.before)
      for (Field* field : {&r.before->x, &r.before->y})
        for (double& p : *field) p *= pressure;
    if (c.input.motion == ContactMotion::shift) {
      r.input.creepage.longitudinal *= length;
      r.input.creepage.lateral *= length;
    } else {
      r.input.creepage.spin /= length;
    }
    const ContactSolution o = r.by_newton();
    ASSERT_EQ(o.report.status, Status::ok);
    for (const auto& [mine, other] :
         {std::pair{&s.fields.traction.x, &o.fields.traction.x}, {&s.fields.traction.y, &o.fields.traction.y}}) {
      Field back = *other;
      for (double& p : back) p /= pressure;
      EXPECT_LE(difference(*mine, back), 1e-6 * norm(c.bound));
    }
    EXPECT_NEAR(o.totals.elastic_energy, s.totals.elastic_energy * length,
                1e-5 * s.totals.elastic_energy * length); // N mm
  });
}

/// The plain methods find the same tractions, where they arrive.
TEST(ExactRandom, ReferenceSolversAgree) {
  int by_sweeps = 0, by_tang = 0, cases = 0;
  for_random_cases(8, 15, [&](const FrictionCase& c, const ContactSolution& s) {
    ASSERT_EQ(s.report.status, Status::ok);
    TangentialOperator response = c.response();
    const PlaneFields free = c.free_slip();
    const FrictionProblem problem = c.problem(response, free);
    ++cases;
    const auto compare = [&](const FrictionSolution& reference, int& count) {
      if (reference.report.status != Status::ok) return;
      ++count;
      EXPECT_LE(difference(reference.traction.x, s.fields.traction.x), 1e-5 * norm(c.bound));
      EXPECT_LE(difference(reference.traction.y, s.fields.traction.y), 1e-5 * norm(c.bound));
    };
    compare(solve_convex_gauss_seidel(problem, c.kernel(), {.tolerance = 1e-8, .most_sweeps = 500}), by_sweeps);
    compare(solve_tang(problem, {.tolerance = 1e-8}), by_tang);
  });
  EXPECT_GE(by_sweeps, cases - 2);
  EXPECT_GE(by_tang, cases - 2);
}

} // namespace
} // namespace microslip
