#include "microslip/response/force_element.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/fitted/fitted_problem.hpp"
#include "microslip/exact/fitted/transient_rolling.hpp"
#include "microslip/numerics/rational_fit.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/test_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Complex = std::complex<double>;

/// Two functions with poles that are known.
RationalFit known_functions() {
  RationalFit known;
  known.poles = {{-3, 0}, {-40, 0}, {-2, 15}, {-10, 70}};
  known.residues = {{{5, 0}, {-20, 0}, {3, 4}, {1, -30}}, {{0.5, 0}, {100, 0}, {-2, 1}, {0, 8}}};
  known.constants = {0.7, -3};
  return known;
}

TEST(RationalFit, RecoversThePolesOfAKnownFunction) {
  const RationalFit known = known_functions();
  std::vector<double> omega = {0};
  for (int k = 0; k < 60; ++k) omega.push_back(0.5 * std::pow(400.0, k / 59.0));
  std::vector<std::vector<Complex>> values(2);
  for (std::size_t f = 0; f < 2; ++f)
    for (const double at : omega) values[f].push_back(known.value(f, Complex(0, at)));
  const RationalFit fit = fit_rational(omega, values, 6);
  ASSERT_EQ(fit.poles.size(), 4u);
  for (const Complex& pole : known.poles) {
    const Complex nearest = *std::min_element(fit.poles.begin(), fit.poles.end(), [&](Complex a, Complex b) {
      return std::abs(a - pole) < std::abs(b - pole);
    });
    EXPECT_LT(std::abs(nearest - pole), 1e-8 * std::abs(pole)) << pole;
  }
  for (std::size_t f = 0; f < 2; ++f) {
    EXPECT_LT(fit.errors[f], 1e-10);
    EXPECT_NEAR(fit.constants[f], known.constants[f], 1e-8);
  }
}

/// A delay is no rational function: poles stay stable, and more of them fit it better.
TEST(RationalFit, IsStableAndBetterWithMorePoles) {
  std::vector<double> omega;
  std::vector<std::vector<Complex>> values(1);
  for (int k = 0; k < 80; ++k)
    omega.push_back(0.1 * k), values[0].push_back(std::polar(1.0, -0.1 * k) / Complex(1, 0.1 * k));
  double before = 1;
  for (const int order : {2, 4, 8}) {
    const RationalFit fit = fit_rational(omega, values, order);
    for (const Complex& pole : fit.poles) EXPECT_LT(pole.real(), 0);
    EXPECT_LT(fit.errors[0], 0.5 * before) << order;
    before = fit.errors[0];
  }
}

/// The square root of 1 + s has real poles only, however many are asked for and whatever noise there is: none gets lost
/// and none becomes a pair.
TEST(RationalFit, KeepsTheNumberOfPoles) {
  std::vector<double> omega = {0};
  for (int k = 0; k < 80; ++k) omega.push_back(0.01 * std::pow(1e5, k / 79.0));
  std::mt19937 engine(1);
  for (const double noise : {0.0, 1e-3}) {
    std::vector<std::vector<Complex>> values(1);
    for (const double at : omega) {
      const auto error = [&] { return noise * (static_cast<double>(engine()) * 0x1p-31 - 1); };
      values[0].push_back(1.0 / std::sqrt(Complex(1, at)) + Complex(error(), error()));
    }
    for (const int order : {6, 12, 21, 24, 25}) {
      int count = 0;
      for (const Complex& pole : fit_rational(omega, values, order).poles) count += pole.imag() > 0 ? 2 : 1;
      EXPECT_EQ(count, order) << noise;
    }
  }
}

TEST(RationalFit, RefusesWhatItCannotFit) {
  const std::vector<std::vector<Complex>> values = {{1, 2, 3}};
  EXPECT_THROW(fit_rational(std::array{0.0, 1.0, 2.0}, values, 5), Error);
  EXPECT_THROW(fit_rational(std::array{0.0, 2.0, 1.0}, values, 2), Error);
  EXPECT_THROW(fit_rational(std::array{0.0, 1.0}, values, 2), Error);
  EXPECT_THROW(fit_rational(std::array{0.0, 1.0, 2.0}, {{1, 2, std::nan("")}}, 2), Error);
}

const EllipticContact& contact() {
  static const EllipticContact c = steel_contact(6e-3, 12e-3, 0.5, -0.6, 0.3);
  return c;
}
constexpr int across = 24;

const ForceElementFit& fit() {
  static const ForceElementFit found = [] {
    Method method;
    method.mx = method.my = across;
    method.tolerance = 1e-9;
    std::vector<double> wavenumbers = {0};
    for (int k = 0; k < 40; ++k) wavenumbers.push_back(8 / contact().a * std::pow(0.004, 1 - k / 39.0));
    return fit_force_element(Solver(method).respond(rolling_problem(contact()), wavenumbers), contact().normal_force,
                             12);
  }();
  return found;
}

TEST(ForceElement, FitsAContact) {
  EXPECT_LT(fit().largest_error(), 0.01);
  for (const Complex& pole : fit().poles) EXPECT_LT(pole.real(), 0);
}

ElementInput changed(double xi, double normal_force = 0) {
  ElementInput input = fit().steady;
  input.creepage.longitudinal += xi;
  input.normal_force += normal_force;
  return input;
}

TEST(ForceElement, ToASineIsTheFitsResponse) {
  for (const double k : {20.0, 200.0, 800.0}) {
    ForceElement element(fit());
    constexpr int steps = 400, passes = 30;
    const double step = 2 * std::numbers::pi / (k * steps);
    Complex fx = 0, fy = 0;
    for (int i = 1; i <= passes * steps; ++i) {
      const double angle = 2 * std::numbers::pi * i / steps;
      const ElementForces f = element.step(step, changed(1e-4 * std::cos(angle)));
      if (i <= (passes - 1) * steps) continue;
      fx += (f.fx - fit().forces.fx) * std::polar(2e4 / steps, -angle);
      fy += (f.fy - fit().forces.fy) * std::polar(2e4 / steps, -angle);
    }
    const Complex x = fit().response(0, 0, k), y = fit().response(1, 0, k);
    EXPECT_LT(std::abs(fx - x), 1e-4 * std::abs(x)) << k;
    EXPECT_LT(std::abs(fy - y), 1e-4 * std::abs(x)) << k;
  }
}

/// Inputs that are linear: one step is as good as many.
TEST(ForceElement, StepsAreExactForLinearInputs) {
  ForceElement one(fit()), many(fit());
  const ElementForces by_one = one.step(0.02, changed(1e-4, 500));
  ElementForces by_many;
  for (int i = 1; i <= 1000; ++i) by_many = many.step(2e-5, changed(1e-7 * i, 0.5 * i));
  EXPECT_NEAR(by_one.fx, by_many.fx, 1e-8 * std::abs(by_one.fx));
  EXPECT_NEAR(by_one.mz, by_many.mz, 1e-8 * std::abs(by_one.mz));
}

TEST(ForceElement, GoesBackAndRests) {
  ForceElement element(fit());
  EXPECT_DOUBLE_EQ(element.forces(fit().steady).fx, fit().forces.fx);
  element.step(1e-3, changed(1e-4));
  const std::vector<double> kept = element.state();
  const ForceElement copy = element;
  const double once = element.step(1e-3, changed(2e-4)).fx;
  element.set_state(kept);
  EXPECT_EQ(element.step(1e-3, changed(2e-4)).fx, once);
  EXPECT_EQ(ForceElement(copy).step(1e-3, changed(2e-4)).fx, once);
  EXPECT_THROW(element.set_state(std::vector<double>(3)), Error);
  // Inputs that were always the same, and those that have been for long.
  element.reset(changed(1e-4));
  const double settled = element.forces(changed(1e-4)).fx;
  element.reset();
  for (int i = 0; i < 200; ++i) element.step_held(0.05, changed(1e-4));
  EXPECT_NEAR(element.forces(changed(1e-4)).fx, settled, 1e-9 * std::abs(settled));
  EXPECT_NEAR(settled - fit().forces.fx, 1e-4 * fit().response(0, 0, 0).real(), 1e-9 * std::abs(settled));
}

TEST(ForceElement, IsReadBackFromItsText) {
  const std::string text = text_of(fit());
  const ForceElementFit back = force_element_from(text);
  EXPECT_EQ(back.poles, fit().poles);
  EXPECT_EQ(back.residues, fit().residues);
  EXPECT_EQ(back.constants, fit().constants);
  EXPECT_EQ(text_of(back), text);
  EXPECT_THROW(force_element_from("something else"), Error);
  EXPECT_THROW(force_element_from(text.substr(0, text.size() / 2)), Error);
  std::string unstable = text;
  unstable.replace(unstable.find("pole -"), 6, "pole ");
  EXPECT_THROW(force_element_from(unstable), Error);
  EXPECT_THROW(force_element_from(text + "pole -1 0\n"), Error);
  std::string fewer = text, part = text;
  fewer.replace(fewer.find("\npoles ") + 7, 1, "1");
  EXPECT_THROW(force_element_from(fewer), Error);
  part.insert(part.find('\n', part.find("\npoles ") + 1), ".5");
  EXPECT_THROW(force_element_from(part), Error);
  EXPECT_EQ(force_element_from(text + "\n").poles, fit().poles);
}

/// Transient rolling by the exact theory with a creepage that oscillates by 1e-3 of itself.
TEST(ForceElement, FollowsTransientRolling) {
  const EllipticContact& c = contact();
  const FittedContact fitted = fit_ellipse(c.a, c.b, across, across, ContactMotion::transient);
  const std::vector<double> bound = friction_bound(fitted, c.friction.static_coefficient() * c.normal_force);
  for (const int steps : {across / 2, across, 2 * across}) { // waves of half a contact's length to two
    TransientRolling rolling({c.shear_modulus, c.poisson_ratio, 0}, fitted);
    ForceElement element(fit());
    const double h = fitted.grid.dx, amplitude = 1e-3 * c.creepage.longitudinal;
    Complex exact = 0, linear = 0;
    const int settling = 8 * across;
    for (int i = 0; i < settling + steps; ++i) {
      // The creepage goes up and down in straight lines from step to step; steps of transient rolling have its mean.
      const auto at = [&](int step) { return amplitude * std::cos(2 * std::numbers::pi * step / steps); };
      SecondOrderInput input;
      input.tolerance = 1e-11;
      input.creepage = c.creepage;
      input.creepage.longitudinal += (at(i) + at(i + 1)) / 2;
      const SecondOrderSolution s = rolling.step(bound, input);
      double fx = 0;
      for (std::size_t e = 0; e < bound.size(); ++e)
        fx += fitted.elements[e].width() * fitted.grid.dy * s.friction.traction.x[e];
      const double by_element = element.step(h, changed(at(i + 1))).fx;
      if (i < settling) continue;
      const Complex weight = 2 / (steps * amplitude) * std::polar(1.0, -2 * std::numbers::pi * (i + 1) / steps);
      exact += fx * weight, linear += by_element * weight;
    }
    EXPECT_LT(std::abs(linear - exact), 0.02 * std::abs(exact)) << steps << linear << exact;
  }
}

} // namespace
} // namespace microslip
