#include "microslip/exact/fitted/transient_rolling.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/fitted/edge_element.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/test_cases.hpp"
#include "validation/half_line.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Field = std::vector<double>;

CombinedMaterial material_of(const EllipticContact& contact) {
  return {contact.shear_modulus, contact.poisson_ratio, 0};
}

/// A contact on n x n elements that begins to roll.
struct Starting {
  Starting(const EllipticContact& of, int n)
      : contact(of), rolling(material_of(of), fit_ellipse(of.a, of.b, n, n, ContactMotion::transient)),
        bound(rolling.contact().load_share) {
    for (double& g : bound) g *= friction_force(of);
  }

  SecondOrderSolution step(double tolerance = 1e-8) {
    return rolling.step(bound, {.creepage = contact.creepage,
                                .force_x = {},
                                .force_y = {},
                                .start = {},
                                .progress = {},
                                .tolerance = tolerance});
  }
  /// (Fx, Fy) over mu Fn.
  Vec2 forces(const SecondOrderSolution& s) const {
    Vec2 sum{};
    for (std::size_t k = 0; k < bound.size(); ++k) {
      const double area = rolling.contact().elements[k].width() * rolling.contact().grid.dy;
      sum.x += area * s.friction.traction.x[k], sum.y += area * s.friction.traction.y[k];
    }
    return {sum.x / friction_force(contact), sum.y / friction_force(contact)};
  }

  EllipticContact contact;
  TransientRolling rolling;
  Field bound;
};

/// After rolling over the semi-axis a.
Vec2 forces_after_a(const EllipticContact& contact, int n) {
  Starting s(contact, n);
  SecondOrderSolution last;
  for (int k = 0; k < n / 2; ++k) last = s.step();
  return s.forces(last);
}
Vec2 classical_forces_after_a(const EllipticContact& contact, int n) {
  const ContactSolution s = Solver({.mx = n, .my = n, .discretisation = Discretisation::classical, .tolerance = 1e-8})
                                .solve(rolling_problem(contact, {.kind = ContactMotion::transient, .steps = n / 2}));
  return {s.totals.fx / friction_force(contact), s.totals.fy / friction_force(contact)};
}

std::vector<EllipticContact> contacts() {
  return {steel_contact(9e-3, 9e-3, 0.6, 0.5, 0), steel_contact(6e-3, 12e-3, 0.5, -0.6, 0.3),
          steel_contact(12e-3, 6e-3, -0.3, 0.7, 0.4)};
}

TEST(TransientRolling, IsOfSecondOrder) {
  double mean_order = 0;
  for (const EllipticContact& contact : contacts()) {
    const Vec2 coarse = forces_after_a(contact, 40), fine = forces_after_a(contact, 80);
    const Vec2 limit = {fine.x + (fine.x - coarse.x) / 3, fine.y + (fine.y - coarse.y) / 3};
    const auto error = [&](std::initializer_list<int> grids) {
      double sum = 0;
      for (const int n : grids) {
        const Vec2 f = forces_after_a(contact, n);
        sum += std::pow(f.x - limit.x, 2) + std::pow(f.y - limit.y, 2);
      }
      return std::sqrt(sum / static_cast<double>(grids.size()));
    };
    const double order = std::log2(error({8, 10, 12}) / error({24, 30, 36})) / std::log2(3.0);
    EXPECT_GT(order, 1.4) << describe(contact);
    mean_order += order / 3;
    const Vec2 c = classical_forces_after_a(contact, 24), f = classical_forces_after_a(contact, 48);
    EXPECT_NEAR(limit.x, 2 * f.x - c.x, 2e-3) << describe(contact);
    EXPECT_NEAR(limit.y, 2 * f.y - c.y, 2e-3) << describe(contact);
  }
  EXPECT_GT(mean_order, 1.6);
}

/// Far from the start it is the steady state, whose discretisation is another one.
TEST(TransientRolling, TendsToSteadyRolling) {
  for (const EllipticContact& contact : contacts()) {
    const auto difference = [&](int n) {
      Starting s(contact, n);
      SecondOrderSolution last;
      for (int k = 0; k < 5 * n; ++k) last = s.step(); // over 10 a
      const ContactSolution steady = Solver({.mx = n, .my = n, .tolerance = 1e-8}).solve(rolling_problem(contact));
      const Vec2 f = s.forces(last);
      return std::hypot(f.x - steady.totals.fx / friction_force(contact),
                        f.y - steady.totals.fy / friction_force(contact));
    };
    EXPECT_LT(difference(12), 5e-3) << describe(contact);
    EXPECT_LT(difference(24), 1e-3) << describe(contact);
  }
}

TEST(TransientRolling, ObeysCoulombsLaw) {
  for (const EllipticContact& contact : contacts()) {
    Starting s(contact, 16);
    for (int k = 0; k < 6; ++k) {
      const SecondOrderSolution found = s.step(1e-9);
      ASSERT_EQ(found.friction.report.status, Status::ok);
      std::size_t sliding = 0;
      for (std::size_t e = 0; e < s.bound.size(); ++e) {
        const double px = found.friction.traction.x[e], py = found.friction.traction.y[e], g = s.bound[e];
        EXPECT_LE(std::hypot(px, py), g * (1 + 1e-15));
        if (!found.friction.sliding[e]) continue;
        ++sliding;
        EXPECT_GE(std::hypot(px, py), g * (1 - 1e-15));
        EXPECT_LT(px * found.friction.slip.x[e] + py * found.friction.slip.y[e], 1e-12);
      }
      EXPECT_GT(sliding, 0U);
      EXPECT_LT(sliding, s.bound.size());
    }
  }
}

TEST(TransientRolling, RestartsFromRest) {
  Starting s(contacts()[1], 10);
  const SecondOrderSolution first = s.step();
  s.step();
  s.rolling.restart();
  EXPECT_EQ(s.step().friction.traction.x, first.friction.traction.x);
}

TEST(TransientRolling, BackwardIsTheMirrorImage) {
  EllipticContact contact = contacts()[1];
  const Motion motion{.kind = ContactMotion::transient, .steps = 6};
  const ContactSolution forward = Solver({.mx = 12, .my = 12}).solve(rolling_problem(contact, motion));
  contact.creepage.longitudinal *= -1;
  contact.creepage.spin *= -1;
  Motion backward_motion = motion;
  backward_motion.direction = RollingDirection::backward;
  const ContactSolution backward = Solver({.mx = 12, .my = 12}).solve(rolling_problem(contact, backward_motion));
  expect_forces(backward.totals, {-forward.totals.fx, forward.totals.fy, -forward.totals.mz},
                1e-9 * friction_force(contact), 1e-9 * friction_moment(contact));
}

TEST(TransientRolling, ForcesThatArePrescribedAreThoseOfEachStep) {
  const EllipticContact contact = contacts()[0];
  const Motion motion{.kind = ContactMotion::transient,
                      .force_x = -0.4 * friction_force(contact),
                      .force_y = 0.3 * friction_force(contact),
                      .steps = 5};
  const ContactSolution s = Solver({.mx = 12, .my = 12}).solve(rolling_problem(contact, motion));
  EXPECT_EQ(s.report.status, Status::ok);
  for (const SolutionStep& step : s.history) {
    EXPECT_NEAR(step.totals.fx, *motion.force_x, 1e-6 * friction_force(contact));
    EXPECT_NEAR(step.totals.fy, *motion.force_y, 1e-6 * friction_force(contact));
  }
}

/// omega + beta(omega) is the distance, by the factorisation of the half-line with points at 1/2 and 3/2.
TEST(LeadingElementWidthOfStep, IsThatOfTheHalfLine) {
  const validation::HalfLine line(0.25);
  for (const double distance : {1.3, 1.42, 1.63, 1.87, 2.04, 2.3})
    EXPECT_NEAR(line.distance(leading_element_width_of_step(distance), {0.5, 1.5}), distance, 2e-3) << distance;
  EXPECT_THROW(leading_element_width_of_step(1.29), Error);
  EXPECT_THROW(leading_element_width_of_step(2.31), Error);
}

} // namespace
} // namespace microslip
