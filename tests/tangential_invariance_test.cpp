#include "tangential_cases.hpp"
#include "tests/support/expect_close.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace microslip {
namespace {

TEST(TangentialInvariance, MirrorAcrossTheRollingDirection) {
  const EllipticContact contact = steel_contact(0.5);
  const Problem p = elliptic(contact, 11, 12);
  TangentialInput input, mirrored;
  input.tolerance = mirrored.tolerance = 1e-10;
  input.creepage = scaled_creepage(contact, 0.4, 0.3, 0.5);
  mirrored.creepage = scaled_creepage(contact, 0.4, -0.3, -0.5);
  const ContactSolution s = solve(p, input), m = solve(p, mirrored);
  for (int j = 0; j < p.grid.my; ++j)
    for (int i = 0; i < p.grid.mx; ++i) {
      const std::size_t here = static_cast<std::size_t>(j) * p.grid.mx + i;
      const std::size_t there = static_cast<std::size_t>(p.grid.my - 1 - j) * p.grid.mx + i;
      EXPECT_NEAR(m.fields.traction.x[there], s.fields.traction.x[here], 1e-7 * s.totals.peak_traction);
      EXPECT_NEAR(m.fields.traction.y[there], -s.fields.traction.y[here], 1e-7 * s.totals.peak_traction);
    }
}

TEST(TangentialInvariance, ReversedCreepagesReverseTheTractions) {
  const EllipticContact contact = steel_contact(3);
  const Problem p = elliptic(contact, 11, 12);
  TangentialInput input = with_creepage(scaled_creepage(contact, 0.4, 0.3, 0.5));
  const ContactSolution s = solve(p, input);
  input.creepage = scaled_creepage(contact, -0.4, -0.3, -0.5);
  const ContactSolution r = solve(p, input);
  for (std::size_t k = 0; k < p.bound.size(); ++k) {
    EXPECT_EQ(r.fields.traction.x[k], -s.fields.traction.x[k]);
    EXPECT_EQ(r.fields.traction.y[k], -s.fields.traction.y[k]);
  }
}

/// Rolling along -x is the mirror image of rolling along +x, steady and step by step.
TEST(TangentialInvariance, RollingBackwardIsTheMirrorImage) {
  const EllipticContact contact = steel_contact(2);
  const Problem p = elliptic(contact, 12, 9);
  const auto mirrored = [&](const Field& field, int sign) {
    Field image(field.size());
    for (std::size_t k = 0; k < field.size(); ++k) {
      const std::size_t i = k % p.grid.mx;
      image[k - i + static_cast<std::size_t>(p.grid.mx) - 1 - i] = sign * field[k];
    }
    return image;
  };
  for (const ContactMotion motion : {ContactMotion::steady, ContactMotion::transient}) {
    TangentialInput ahead, back;
    VectorField before, before_mirrored;
    ahead.tolerance = back.tolerance = 1e-10;
    ahead.motion = back.motion = motion;
    ahead.creepage = scaled_creepage(contact, 0.3, 0.4, 0.6);
    back.creepage = scaled_creepage(contact, -0.3, 0.4, -0.6);
    back.direction = backward;
    ahead.step = back.step = 0.7 * p.grid.dx;
    if (motion == ContactMotion::transient) {
      before = solve(p, ahead).fields.traction;
      before_mirrored = {mirrored(before.x, -1), mirrored(before.y, 1)};
      ahead.previous = &before;
      back.previous = &before_mirrored;
    }
    const ContactSolution s = solve(p, ahead), b = solve(p, back);
    const Field px = mirrored(b.fields.traction.x, -1), py = mirrored(b.fields.traction.y, 1);
    for (std::size_t k = 0; k < px.size(); ++k) {
      EXPECT_NEAR(px[k], s.fields.traction.x[k], 1e-7 * s.totals.peak_traction);
      EXPECT_NEAR(py[k], s.fields.traction.y[k], 1e-7 * s.totals.peak_traction);
    }
    expect_forces(b.forces(), {-s.totals.fx, s.totals.fy, -s.totals.mz}, 1e-8 * p.capacity,
                  1e-8 * p.capacity * contact.a);
    EXPECT_NEAR(b.totals.frictional_power, s.totals.frictional_power, 1e-8 * s.totals.frictional_power);
  }
}

/// A shift knows no direction: x and y may be exchanged.
TEST(TangentialInvariance, ShiftTurnedByARightAngle) {
  EllipticContact contact = steel_contact(2), turned = contact;
  std::swap(turned.a, turned.b);
  const Problem p = elliptic(contact, 12, 9), t = elliptic(turned, 9, 12);
  TangentialInput input;
  input.motion = ContactMotion::shift;
  input.tolerance = 1e-10;
  const double unit = 1e-6;
  input.creepage = {5 * unit, 3 * unit, 400 * unit};
  const ContactSolution s = solve(p, input);
  input.creepage = {3 * unit, 5 * unit, -400 * unit};
  const ContactSolution r = solve(t, input);
  EXPECT_GT(s.totals.slip_area, 0);
  EXPECT_GT(s.totals.adhesion_area, 0);
  expect_forces(r.forces(), {s.totals.fy, s.totals.fx, -s.totals.mz}, 1e-6 * p.capacity, 1e-6 * p.capacity * contact.a);
}

TEST(TangentialInvariance, UnitsDoNotMatter) {
  const EllipticContact contact = steel_contact(0.7);
  TangentialInput input;
  input.tolerance = 1e-10;
  input.creepage = scaled_creepage(contact, 0.4, -0.5, 0.3);
  const Problem p = elliptic(contact, 12, 11);
  const ContactSolution s = solve(p, input);
  for (const auto& [length, force] : {std::pair{1024.0, 0x1p-20}, {1e3, 1.0}, {39.37, 0.2248}}) {
    Problem other = p;
    for (double* value : {&other.grid.x0, &other.grid.y0, &other.grid.dx, &other.grid.dy}) *value *= length;
    for (double& g : other.bound) g *= force / (length * length);
    other.material.shear_modulus *= force / (length * length);
    TangentialInput converted = input;
    converted.creepage.spin /= length;
    converted.rolling_speed = length;
    const ContactSolution o = solve(other, converted);
    expect_forces({o.totals.fx / force, o.totals.fy / force, o.totals.mz / (force * length)}, s.forces(),
                  1e-8 * p.capacity, 1e-8 * p.capacity * contact.a);
    EXPECT_NEAR(o.totals.frictional_power / (force * length), s.totals.frictional_power,
                1e-8 * s.totals.frictional_power);
    EXPECT_NEAR(o.totals.elastic_energy / (force * length), s.totals.elastic_energy, 1e-8 * s.totals.elastic_energy);
    EXPECT_NEAR(o.totals.adhesion_area / (length * length), s.totals.adhesion_area, 1e-9 * s.totals.adhesion_area);
  }
}

/// Creepages and bound k times as large: tractions k times as large.
TEST(TangentialInvariance, IsHomogeneous) {
  const EllipticContact contact = steel_contact(0.7);
  Problem p = elliptic(contact, 12, 11);
  TangentialInput input = with_creepage(scaled_creepage(contact, 0.4, -0.5, 0.3));
  const ContactSolution s = solve(p, input);
  for (const double k : {0x1p-20, 64.0}) {
    Problem other = p;
    for (double& g : other.bound) g *= k;
    TangentialInput scaled = input;
    scaled.creepage = {k * input.creepage.longitudinal, k * input.creepage.lateral, k * input.creepage.spin};
    const ContactSolution o = solve(other, scaled);
    EXPECT_NEAR(o.totals.fx, k * s.totals.fx, 1e-12 * k * p.capacity);
    EXPECT_NEAR(o.totals.fy, k * s.totals.fy, 1e-12 * k * p.capacity);
    EXPECT_EQ(o.report.newton_steps, s.report.newton_steps);
  }
}

/// The rolling speed scales the powers and nothing else.
TEST(TangentialInvariance, SpeedMattersForPowerOnly) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 9, 9);
  TangentialInput input = with_creepage(scaled_creepage(contact, 0.5, 0.2, 0.1));
  const ContactSolution slow = solve(p, input);
  input.rolling_speed = 32;
  const ContactSolution fast = solve(p, input);
  EXPECT_EQ(fast.fields.traction.x, slow.fields.traction.x);
  EXPECT_DOUBLE_EQ(fast.totals.frictional_power, 32 * slow.totals.frictional_power);
  EXPECT_DOUBLE_EQ(fast.totals.power_by_creepage, 32 * slow.totals.power_by_creepage);
}

} // namespace
} // namespace microslip
