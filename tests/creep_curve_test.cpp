// The creep curve of a case: its ends, and points where it bends.

#include "cases/creep_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

namespace microslip {
namespace {

EllipticContact contact() {
  EllipticContact one;
  one.a = 6e-3, one.b = 4e-3, one.shear_modulus = 82e9, one.poisson_ratio = 0.28, one.normal_force = 80e3;
  one.friction = FrictionLaw::coulomb(0.3);
  one.creepage.longitudinal = 1e-3;
  return one;
}

/// A force that grows to a limit and stays: it bends in one place.
ContactForces saturating(const EllipticContact& moved) {
  constexpr double limit = 24e3, full = 2e-3;
  ContactForces forces;
  const double rest = std::max(0.0, 1 - std::abs(moved.creepage.longitudinal) / full);
  forces.fx = -std::copysign(limit * (1 - rest * rest * rest), moved.creepage.longitudinal);
  return forces;
}

/// The largest distance of straight lines between points from the curve.
double largest_distance(const cases::CreepCurve& curve) {
  double largest = 0;
  EllipticContact moved = contact();
  for (std::size_t i = 0; i + 1 < curve.value.size(); ++i)
    for (const double part : {0.25, 0.5, 0.75}) {
      moved.creepage.longitudinal = (1 - part) * curve.value[i] + part * curve.value[i + 1];
      const double line = (1 - part) * curve.forces[i].fx + part * curve.forces[i + 1].fx;
      largest = std::max(largest, std::abs(saturating(moved).fx - line));
    }
  return largest;
}

TEST(CreepCurve, GoesFromNothingOverTheCaseToSliding) {
  const cases::CreepCurve curve = cases::creep_curve(contact(), 25, saturating);
  EXPECT_EQ(curve.variable, "creepage_longitudinal");
  ASSERT_EQ(curve.value.size(), 25U);
  EXPECT_EQ(curve.value.front(), 0);
  EXPECT_GE(curve.value.back(), 3e-3 * (1 - 1e-12));
  EXPECT_TRUE(std::is_sorted(curve.value.begin(), curve.value.end()));
}

TEST(CreepCurve, PointsLieWhereItBends) {
  const cases::CreepCurve curve = cases::creep_curve(contact(), 25, saturating);
  cases::CreepCurve even = curve;
  for (std::size_t i = 0; i < even.value.size(); ++i) {
    even.value[i] = curve.value.back() * static_cast<double>(i) / static_cast<double>(even.value.size() - 1);
    EllipticContact moved = contact();
    moved.creepage.longitudinal = even.value[i];
    even.forces[i] = saturating(moved);
  }
  EXPECT_LT(largest_distance(curve), 0.4 * largest_distance(even));
}

TEST(CreepCurve, StraightLinesHaveEvenPoints) {
  const auto straight = [](const EllipticContact& moved) {
    ContactForces forces;
    forces.fx = -1e6 * moved.creepage.longitudinal;
    return forces;
  };
  for (const auto span : {cases::CurveSpan::from_zero, cases::CurveSpan::both_signs}) {
    const cases::CreepCurve curve = cases::creep_curve(contact(), 25, straight, span);
    for (std::size_t i = 0; i + 1 < curve.value.size(); ++i)
      EXPECT_NEAR(curve.value[i + 1] - curve.value[i], (curve.value.back() - curve.value.front()) / 24, 1e-12);
  }
}

} // namespace
} // namespace microslip
