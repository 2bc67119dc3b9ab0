#include "microslip/response/corrugation.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/bessel.hpp"
#include "microslip/response/remington_filter.hpp"
#include "microslip/rolling/frequency_response.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

/// A mass on a spring and a damper, x/F.
Complex oscillator(double omega) {
  constexpr double mass = 300, stiffness = 2e8, damping = 3e4;
  return 1.0 / (stiffness - mass * omega * omega + Complex(0, damping * omega));
}

Receptance table_of_oscillator() {
  std::vector<double> frequencies;
  std::vector<Complex> values;
  for (int k = 0; k <= 40000; ++k)
    frequencies.push_back(0.05 * k), values.push_back(oscillator(2 * pi * frequencies[k]));
  return {frequencies, values};
}

/// Linear coefficients: work of forces F_x = -C xi at a creepage that stays, C proportional to the load. Then F = k_H
/// r/(1 + k_H G) and the work is xi^2 dC/dF F: growth in closed form.
TEST(Corrugation, OfAnOscillatorWithLinearCoefficientsIsTheClosedForm) {
  constexpr double stiffness = 1.2e9, speed = 30, xi = 1e-3, slope = 150, coefficient = 3e-14, width = 12e-3;
  FrequencyResponse response;
  response.normal_stiffness = stiffness;
  for (const double wavelength : {0.3, 0.1, 0.05, 0.03}) {
    ForceResponse& r = response.at.emplace_back();
    r.wavenumber = 2 * pi / wavelength;
    r.load_by_roughness = stiffness;
    r.work_by_load = xi * xi * slope;
    r.work_by_roughness = xi * xi * slope * stiffness;
  }
  const auto growth = corrugation_growth(response, speed, table_of_oscillator(), {coefficient, width});
  ASSERT_EQ(growth.size(), response.at.size());
  for (std::size_t k = 0; k < growth.size(); ++k) {
    const Complex G = oscillator(speed * response.at[k].wavenumber);
    const Complex force = stiffness / (1.0 + stiffness * G);
    const Complex rate = -coefficient / width * xi * xi * slope * force;
    EXPECT_LT(std::abs(growth[k].normal_force - force), 1e-4 * std::abs(force)) << k;
    EXPECT_LT(std::abs(growth[k].rate - rate), 1e-4 * std::abs(rate)) << k;
  }
  // Below the resonance the load is largest on crests, which wear off; above, where the mass stays, too; between
  // resonance and antiresonance of contact and mass the load lags by half a wave, and crests grow.
  EXPECT_LT(growth.front().rate.real(), 0);
}

TEST(Corrugation, GrowsWhereTheLoadIsLeastOnCrests) {
  constexpr double stiffness = 1.2e9;
  FrequencyResponse response;
  response.normal_stiffness = stiffness;
  ForceResponse& r = response.at.emplace_back();
  r.wavenumber = 2 * pi / 0.1;
  r.load_by_roughness = stiffness, r.work_by_load = 1, r.work_by_roughness = stiffness;
  // A receptance of the other sign than a spring's and larger than the contact's.
  const Receptance inert({0, 1000}, {-2 / stiffness, -2 / stiffness});
  const auto growth = corrugation_growth(response, 10, inert, {1e-14, 1e-2});
  EXPECT_NEAR(growth[0].normal_force.real(), -stiffness, 1e-6 * stiffness);
  EXPECT_GT(growth[0].rate.real(), 0);
}

TEST(Corrugation, NeedsResponsesToRoughness) {
  FrequencyResponse response;
  response.at.push_back({.wavenumber = 100, .by_load = {1, 0, 0}});
  EXPECT_THROW(corrugation_growth(response, 30, table_of_oscillator(), {1e-13, 0.01}), Error);
}

TEST(Corrugation, ReceptanceIsLinearBetweenItsFrequencies) {
  const Receptance r({10, 20, 40}, {Complex(1, 2), Complex(3, 0), Complex(3, -4)});
  EXPECT_EQ(r.at(15), Complex(2, 1));
  EXPECT_EQ(r.at(30), Complex(3, -2));
  EXPECT_EQ(r.at(40), Complex(3, -4));
  EXPECT_THROW(r.at(9), Error);
  EXPECT_THROW(r.at(41), Error);
  EXPECT_THROW(Receptance({2, 1}, {1, 1}), Error);
  EXPECT_THROW(Receptance({-1, 1}, {1, 1}), Error);
  EXPECT_THROW(Receptance({1}, {}), Error);
  EXPECT_THROW(Receptance({1}, {std::nan("")}), Error);
}

/// The integral over the angle, by a sum.
TEST(RemingtonFilter, IsItsIntegral) {
  constexpr double radius = 6e-3;
  constexpr int count = 20000;
  for (const double alpha : {0.1, 1.0, 10.0})
    for (const double k : {50.0, 300.0, 1000.0}) {
      double sum = 0;
      for (int i = 0; i < count; ++i) {
        const double x = std::atan(alpha) * (i + 0.5) / count, j1 = bessel_functions(k * radius / std::cos(x)).j1;
        sum += j1 * j1 * std::atan(alpha) / count;
      }
      const double expected = std::sqrt(4 / alpha * sum) / (k * radius);
      EXPECT_NEAR(remington_filter(radius, alpha, k), expected, 1e-6) << alpha << k;
    }
}

TEST(RemingtonFilter, IsOneForEndlessWavesAndFallsWithAlpha) {
  constexpr double radius = 6e-3;
  EXPECT_NEAR(remington_filter(radius, 1, 0), 1, 1e-12);
  EXPECT_NEAR(remington_filter(radius, 0, 200), 2 * bessel_functions(1.2).j1 / 1.2, 1e-12);
  EXPECT_NEAR(remington_filter(radius, 1e-4, 200), remington_filter(radius, 0, 200), 1e-6);
  EXPECT_LT(remington_filter(radius, 2, 200), remington_filter(radius, 1, 200));
  EXPECT_THROW(remington_filter(0, 1, 200), Error);
}

} // namespace
} // namespace microslip
