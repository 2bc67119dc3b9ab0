#include "tangential_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace microslip {
namespace {

TEST(GivenForce, ForcesLeadBackToTheCreepages) {
  for (const ContactMotion motion : {ContactMotion::shift, ContactMotion::transient, ContactMotion::steady}) {
    const EllipticContact contact = steel_contact(1.3);
    const Problem p = elliptic(contact, 13, 12);
    const double length = motion == ContactMotion::shift ? contact.a : motion == ContactMotion::transient ? 5 : 1;
    TangentialInput given;
    given.motion = motion;
    given.tolerance = 1e-12;
    given.creepage = scaled_creepage(contact, 0.5 * length, -0.4 * length, 0.3 * length);
    const ContactSolution s = solve(p, given);
    ASSERT_EQ(s.report.status, Status::ok);
    ASSERT_GT(s.totals.slip_area, 0);
    ASSERT_GT(s.totals.adhesion_area, 0);
    for (const auto& [by_fx, by_fy] : {std::pair{true, false}, {false, true}, {true, true}}) {
      TangentialInput input = given;
      if (by_fx) input.force_x = s.totals.fx;
      if (by_fy) input.force_y = s.totals.fy;
      if (by_fx) input.creepage.longitudinal = 7; // is an unknown: what stands here does not matter
      const ContactSolution f = solve(p, input);
      ASSERT_EQ(f.report.status, Status::ok);
      EXPECT_NEAR(f.creepage.longitudinal, s.creepage.longitudinal, 1e-9 * std::abs(s.creepage.longitudinal));
      EXPECT_NEAR(f.creepage.lateral, s.creepage.lateral, 1e-9 * std::abs(s.creepage.lateral));
      EXPECT_EQ(f.creepage.spin, s.creepage.spin);
      EXPECT_NEAR(f.totals.mz, s.totals.mz, 1e-9 * p.capacity * contact.a);
    }
  }
}

/// Forces on tractions of other forces, begun from these and from none: the creepage does not run away.
TEST(GivenForce, ForcesAfterOtherForces) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 13, 13);
  TangentialProblem problem(p.material, p.grid);
  VectorField none{Field(p.bound.size(), 0.0), Field(p.bound.size(), 0.0)};
  for (VectorField* start : {&none, static_cast<VectorField*>(nullptr)})
    for (const ContactMotion motion : {ContactMotion::shift, ContactMotion::transient}) {
      TangentialInput input;
      input.motion = ContactMotion::shift;
      input.force_x = -0.875 * p.capacity;
      input.force_y = 0;
      VectorField before = problem.solve(p.bound, input).fields.traction;
      input.motion = motion;
      input.start = start;
      for (const double share : {-0.875, -0.4, 0.0, 0.6}) {
        SCOPED_TRACE(share);
        input.previous = &before;
        input.force_x = share * p.capacity;
        const ContactSolution s = problem.solve(p.bound, input);
        expect_solution(p, input, s);
        before = s.fields.traction;
      }
    }
}

/// Forces close to what friction can bear need ever more creepage.
TEST(GivenForce, ForcesCloseToSliding) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 13, 13);
  double before = 0;
  for (const double share : {0.0, 0.5, 0.9, 0.99, 0.999}) {
    SCOPED_TRACE(share);
    TangentialInput input;
    input.force_x = -0.8 * share * p.capacity;
    input.force_y = 0.6 * share * p.capacity;
    input.tolerance = 1e-8;
    const ContactSolution s = solve(p, input);
    expect_solution(p, input, s);
    const double creep = std::hypot(s.creepage.longitudinal, s.creepage.lateral);
    EXPECT_GE(creep, before);
    EXPECT_GE(s.creepage.longitudinal, 0);
    EXPECT_LE(s.creepage.lateral, 0);
    before = creep;
  }
}

TEST(GivenForce, ForceBeyondFrictionHasNoSolution) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 10, 10);
  for (const double share : {1.0, 1.2, 100.0})
    for (const bool both : {false, true}) {
      TangentialInput input;
      input.creepage = {1e-4, 1e-4, 0.05};
      const double c = both ? 0.6 : 1;
      input.force_x = c * share * p.capacity * (1 + 1e-12);
      if (both) input.force_y = -0.8 * share * p.capacity * (1 + 1e-12);
      const ContactSolution s = solve(p, input);
      EXPECT_EQ(s.report.status, Status::no_solution);
      EXPECT_NEAR(s.totals.fx, c * p.capacity, 1e-9 * p.capacity);
      EXPECT_NEAR(s.totals.fy, both ? -0.8 * p.capacity : 0, 1e-9 * p.capacity);
      EXPECT_EQ(s.totals.adhesion_area, 0);
      EXPECT_NEAR(s.report.residual, share - 1, 1e-9 * share);
      for (std::size_t k = 0; k < p.bound.size(); ++k)
        EXPECT_NEAR(std::hypot(s.fields.traction.x[k], s.fields.traction.y[k]), p.bound[k], 1e-15 * p.bound[k]);
      for (const double value :
           {s.creepage.longitudinal, s.creepage.lateral, s.totals.frictional_power, s.totals.elastic_energy})
        EXPECT_TRUE(std::isfinite(value));
    }
}

} // namespace
} // namespace microslip
