#include "microslip/simplified/flexibility.hpp"

#include "microslip/numerics/dual.hpp"
#include "tests/test_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Numbers = std::array<double, 3>;

Numbers flexibilities_of(const EllipticContact& contact, FlexibilityModel model, const SlopeReduction& reduction = {}) {
  const Flexibilities l = flexibilities(model, reduction, contact);
  return {l.longitudinal, l.lateral, l.spin};
}

CreepageCoefficients coefficients_of(const EllipticContact& contact) {
  return creepage_coefficients(contact.a / contact.b, contact.poisson_ratio);
}

void expect_near(const Numbers& value, const Numbers& expected, double relative) {
  for (int n = 0; n < 3; ++n) EXPECT_NEAR(value[n], expected[n], relative * expected[n]) << "flexibility number " << n;
}

EllipticContact some_contact(const Creepage& over_saturating) {
  EllipticContact contact = test_cases()[0];
  const Creepage unit = saturating_creepage(contact);
  contact.creepage = {unit.longitudinal * over_saturating.longitudinal, unit.lateral * over_saturating.lateral,
                      unit.spin * over_saturating.spin};
  return contact;
}

/// (F17).
TEST(Flexibility, ThreeFollowTheCreepageCoefficients) {
  RandomContacts random(1);
  for (int k = 0; k < 100; ++k) {
    const EllipticContact contact = random.next();
    const double a = contact.a, b = contact.b, g = contact.shear_modulus;
    const auto c = coefficients_of(contact);
    expect_near(
        flexibilities_of(contact, FlexibilityModel::three),
        {8 * a / (3 * c.c11 * g), 8 * a / (3 * c.c22 * g), std::numbers::pi * a * std::sqrt(a / b) / (4 * c.c23 * g)},
        1e-15);
  }
}

/// (F19).
TEST(Flexibility, OneIsTheWeightedMean) {
  RandomContacts random(2);
  for (int k = 0; k < 100; ++k) {
    const EllipticContact contact = random.next();
    const Numbers l = flexibilities_of(contact, FlexibilityModel::three);
    const double xi = std::abs(contact.creepage.longitudinal), eta = std::abs(contact.creepage.lateral),
                 spin = std::abs(contact.creepage.spin) * std::sqrt(contact.a * contact.b);
    const double mean = (xi * l[0] + eta * l[1] + spin * l[2]) / std::sqrt(xi * xi + eta * eta + spin * spin);
    expect_near(flexibilities_of(contact, FlexibilityModel::one), {mean, mean, mean}, 1e-14);
  }
}

TEST(Flexibility, OfASingleCreepageIsItsOwn) {
  for (const double size : {1e-9, 0.3, 20.0}) {
    const EllipticContact along = some_contact({size, 0, 0}), across = some_contact({0, -size, 0}),
                          turning = some_contact({0, 0, size});
    const Numbers three = flexibilities_of(along, FlexibilityModel::three);
    expect_near(flexibilities_of(along, FlexibilityModel::one), {three[0], three[0], three[0]}, 1e-15);
    expect_near(flexibilities_of(across, FlexibilityModel::one), {three[1], three[1], three[1]}, 1e-15);
    expect_near(flexibilities_of(turning, FlexibilityModel::one), {three[2], three[2], three[2]}, 1e-15);
    EXPECT_NEAR(flexibilities_of(along, FlexibilityModel::blended)[0], three[0], 1e-15 * three[0]);
    EXPECT_NEAR(flexibilities_of(across, FlexibilityModel::blended)[1], three[1], 1e-15 * three[1]);
    expect_near(flexibilities_of(turning, FlexibilityModel::blended), three, 1e-15);
  }
}

/// The formula of Vollebregt & Voltr as the literature has it, with w the share of the common flexibility.
Numbers blended(const EllipticContact& contact) {
  const Numbers l = flexibilities_of(contact, FlexibilityModel::three);
  const auto c = coefficients_of(contact);
  const double f3 = 8 * contact.a / 3, f4 = std::numbers::pi * contact.a * contact.a / 4;
  const double xi = contact.creepage.longitudinal, eta = contact.creepage.lateral,
               spin = contact.creepage.spin * f4 / f3;
  const double common = (xi * xi + eta * eta + spin * spin) / (xi * xi / l[0] + eta * eta / l[1] + spin * spin / l[2]);
  const double unit = friction_force(contact) / (contact.a * contact.b * contact.shear_modulus);
  const double w = std::min(1.0, std::hypot(xi, eta) / std::hypot(unit / c.c11, unit / c.c22) / 3);
  Numbers result{};
  for (int n = 0; n < 3; ++n) result[n] = (1 - w) * l[n] + w * common;
  return result;
}

TEST(Flexibility, BlendedIsThePublishedFormula) {
  RandomContacts random(3);
  for (int k = 0; k < 200; ++k) {
    const EllipticContact contact = random.next();
    expect_near(flexibilities_of(contact, FlexibilityModel::blended), blended(contact), 1e-14);
  }
}

TEST(Flexibility, BlendedGoesFromThreeToOne) {
  const EllipticContact slow = some_contact({1e-9, 2e-9, 1}), fast = some_contact({4, -3, 1});
  expect_near(flexibilities_of(slow, FlexibilityModel::blended), flexibilities_of(slow, FlexibilityModel::three), 1e-8);
  const Numbers l = flexibilities_of(fast, FlexibilityModel::blended);
  expect_near(l, {l[0], l[0], l[0]}, 1e-15);
}

TEST(Flexibility, DoesNotDependOnSignsNorOnACommonScaleOfCreepagesAndLoad) {
  RandomContacts random(4);
  for (int k = 0; k < 100; ++k)
    for (const auto model : all_flexibility_models) {
      EllipticContact contact = random.next();
      const Numbers l = flexibilities_of(contact, model);
      Creepage& c = contact.creepage;
      c = {-c.longitudinal, c.lateral, -c.spin};
      expect_near(flexibilities_of(contact, model), l, 1e-15);
      c = {c.longitudinal * 1.7, c.lateral * 1.7, c.spin * 1.7};
      contact.normal_force *= 1.7;
      expect_near(flexibilities_of(contact, model), l, 1e-14);
    }
}

TEST(Flexibility, WithoutCreepageIsFiniteForEveryModel) {
  const EllipticContact still = some_contact({0, 0, 0});
  for (const auto model : all_flexibility_models)
    for (const double l : flexibilities_of(still, model)) {
      EXPECT_GT(l, 0);
      EXPECT_TRUE(std::isfinite(l));
    }
}

TEST(SlopeReduction, DividesByItsInitialFactor) {
  RandomContacts random(5);
  for (const auto model : all_flexibility_models) {
    const EllipticContact contact = random.next();
    Numbers l = flexibilities_of(contact, model);
    for (double& value : l) value /= 0.4;
    expect_near(flexibilities_of(contact, model, {.initial = 0.4}), l, 1e-15);
    expect_near(flexibilities_of(contact, model, {.initial = 0.4, .decay = 7}), l, 1e-15);
  }
}

/// k = k0 (alpha + (1 - alpha)/(1 + beta eps)), as Spiryagin, Polach & Cole give it.
TEST(SlopeReduction, FallsWithTheCreepageAsPublished) {
  RandomContacts random(6);
  const SlopeReduction reduction{.initial = 0.55, .at_infinity = 0.4, .decay = 0.6};
  for (int n = 0; n < 100; ++n) {
    const EllipticContact contact = random.next();
    const double turned = contact.creepage.lateral + contact.creepage.spin * contact.a;
    const double lateral = std::max(std::abs(turned), std::abs(contact.creepage.lateral));
    const double epsilon = contact.shear_modulus * ellipse_area(contact) * 0.55 * coefficients_of(contact).c11 *
                           std::hypot(contact.creepage.longitudinal, lateral) / (4 * friction_force(contact));
    const double k = 0.55 * (0.4 + 0.6 / (1 + 0.6 * epsilon));
    Numbers l = flexibilities_of(contact, FlexibilityModel::three);
    for (double& value : l) value /= k;
    expect_near(flexibilities_of(contact, FlexibilityModel::three, reduction), l, 1e-14);
  }
}

TEST(SlopeReduction, StartsAtTheInitialFactorAndEndsAtTheOneAtInfinity) {
  const SlopeReduction reduction{.initial = 0.5, .at_infinity = 0.3, .decay = 2};
  const Numbers l = flexibilities_of(some_contact({0, 0, 0}), FlexibilityModel::three);
  const Numbers still = flexibilities_of(some_contact({0, 0, 0}), FlexibilityModel::three, reduction);
  const Numbers slow = flexibilities_of(some_contact({1e-9, 1e-9, 0}), FlexibilityModel::three, reduction);
  const Numbers fast = flexibilities_of(some_contact({1e9, 1e9, 0}), FlexibilityModel::three, reduction);
  expect_near(still, {l[0] / 0.5, l[1] / 0.5, l[2] / 0.5}, 1e-15);
  expect_near(slow, still, 1e-8);
  expect_near(fast, {l[0] / 0.15, l[1] / 0.15, l[2] / 0.15}, 1e-8);
}

/// Dual numbers against central differences, for all models and with slope reduction.
TEST(Flexibility, CarriesItsDerivatives) {
  using Number = Dual<double, 4>;
  RandomContacts random(7);
  const SlopeReduction reduction{.initial = 0.55, .at_infinity = 0.4, .decay = 0.6};
  for (int n = 0; n < 50; ++n)
    for (const auto model : all_flexibility_models) {
      const EllipticContact contact = random.next();
      SCOPED_TRACE(describe(contact));
      const auto& c = contact.creepage;
      const std::array<double, 4> input = {c.longitudinal, c.lateral, c.spin, contact.normal_force};
      const auto at = [&](const std::array<double, 4>& x) {
        return flexibilities(model, reduction, contact, Drive<double>{x[0], x[1], x[2], x[3]});
      };
      const auto dual = flexibilities(model, reduction, contact,
                                      Drive<Number>{Number::variable(input[0], 0), Number::variable(input[1], 1),
                                                    Number::variable(input[2], 2), Number::variable(input[3], 3)});
      EXPECT_EQ(dual.longitudinal.value, at(input).longitudinal);
      for (int k = 0; k < 4; ++k) {
        auto less = input, more = input;
        less[k] *= 1 - 1e-6;
        more[k] *= 1 + 1e-6;
        const auto low = at(less), high = at(more);
        const double step = more[k] - less[k];
        const double unit = dual.longitudinal.value / std::abs(input[k]);
        EXPECT_NEAR(dual.longitudinal.partial[k], (high.longitudinal - low.longitudinal) / step, 1e-8 * unit);
        EXPECT_NEAR(dual.lateral.partial[k], (high.lateral - low.lateral) / step, 1e-8 * unit);
        EXPECT_NEAR(dual.spin.partial[k], (high.spin - low.spin) / step, 1e-8 * unit);
      }
    }
}

} // namespace
} // namespace microslip
