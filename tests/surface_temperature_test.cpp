// Surface temperatures of rolling bodies.

#include "microslip/thermal/surface_temperature.hpp"

#include "microslip/error.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/test_cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double pi = std::numbers::pi;
constexpr ThermalBody thermal_steel = {20, 50, 7850, 450}, brass = {80, 120, 8500, 380};
constexpr double speed = 30;

ElementGrid row_of(int elements, double dx) {
  return {elements, 1, dx / 2, 0, dx, 1e-3};
}

std::vector<double> constant(int first, int last, int elements, double value) {
  std::vector<double> field(elements, 0);
  std::fill(field.begin() + first, field.begin() + last, value);
  return field;
}

double mean_temperature(const ThermalBody& body1, const ThermalBody& body2) {
  const double b1 = body1.effusivity(), b2 = body2.effusivity();
  return (b1 * body1.bulk_temperature + b2 * body2.bulk_temperature) / (b1 + b2);
}

/// In contact 2 q sqrt(t/pi)/(beta1 + beta2) above the mean of the bulk temperatures; behind it the heat of before goes
/// on spreading, and each body tends to its bulk temperature as 1 - (2/pi) asin sqrt(tc/t).
TEST(SurfaceTemperature, ConstantHeatInAStrip) {
  const int n = 60, first = 10, last = 35;
  const double dx = 1e-4, q = 2e8, length = (last - first) * dx;
  const auto t = surface_temperature(row_of(n, dx), RollingDirection::backward, speed, {thermal_steel, brass},
                                     constant(first, last, n, 1e9), constant(first, last, n, q));
  const double b1 = thermal_steel.effusivity(), b2 = brass.effusivity(), mean = mean_temperature(thermal_steel, brass);
  const double per_heat = 2 * q / ((b1 + b2) * std::sqrt(pi * speed));
  for (int i = 0; i < n; ++i) {
    const double way = (i + 0.5 - first) * dx;
    double expected1 = thermal_steel.bulk_temperature, expected2 = brass.bulk_temperature;
    if (way > 0 && i < last) expected1 = expected2 = mean + per_heat * std::sqrt(way);
    if (i >= last) {
      const double rise = per_heat * (std::sqrt(way) - std::sqrt(way - length));
      const double share = 2 / pi * std::asin(std::sqrt(length / way));
      expected1 += (mean - thermal_steel.bulk_temperature) * share + rise;
      expected2 += (mean - brass.bulk_temperature) * share + rise;
    }
    EXPECT_NEAR(t.body1[i], expected1, 1e-9 * q / 1e6) << i;
    EXPECT_NEAR(t.body2[i], expected2, 1e-9 * q / 1e6) << i;
  }
  EXPECT_EQ(t.highest, t.body1[last - 1]);
}

/// Hertz's pressure sliding as a whole: the highest temperature is 2.188307 q0 sqrt(a)/((beta1 + beta2) sqrt(pi V))
/// above the bulk, 0.652 a behind the middle (the integral by a fine quadrature).
TEST(SurfaceTemperature, HeatLikeHertzsPressure) {
  const double a = 5.88e-3, q0 = 2.3e8;
  const double peak = 2.188307 * q0 * std::sqrt(a) / (2 * thermal_steel.effusivity() * std::sqrt(pi * speed));
  double last_error = 1;
  for (const int across : {20, 80, 320}) {
    const ElementGrid grid = {across, 1, -a + a / across, 0, 2 * a / across, 1e-3};
    std::vector<double> heat;
    for (int i = 0; i < across; ++i) heat.push_back(q0 * std::sqrt(1 - std::pow(grid.x(i) / a, 2)));
    const auto t =
        surface_temperature(grid, RollingDirection::forward, speed, {thermal_steel, thermal_steel}, heat, heat);
    const double error = std::abs(t.highest - 20 - peak) / peak;
    EXPECT_LT(error, 0.3 / across);
    EXPECT_LT(error, last_error);
    last_error = error;
    const auto at = std::max_element(t.body1.begin(), t.body1.end()) - t.body1.begin();
    EXPECT_NEAR(grid.x(static_cast<int>(at)) / a, -0.652, 1.5 / across + 0.01);
  }
}

TEST(SurfaceTemperature, BodiesAndDirectionsMayBeSwapped) {
  const int n = 40, rows = 2;
  const ElementGrid grid = {n, rows, 0, 0, 1e-4, 1e-3};
  std::vector<double> pressure(grid.count(), 0), heat(grid.count(), 0);
  for (const int i : {5, 6, 7, 8, 15, 16, 17, 55, 56, 57, 70}) {
    pressure[i] = 1e8;
    heat[i] = 1e7 * i;
  }
  const auto t = surface_temperature(grid, RollingDirection::forward, speed, {thermal_steel, brass}, pressure, heat);
  const auto swapped =
      surface_temperature(grid, RollingDirection::forward, speed, {brass, thermal_steel}, pressure, heat);
  const auto mirror = [&](std::vector<double> field) {
    for (auto row = field.begin(); row != field.end(); row += n) std::reverse(row, row + n);
    return field;
  };
  const auto back = surface_temperature(grid, RollingDirection::backward, speed, {thermal_steel, brass},
                                        mirror(pressure), mirror(heat));
  for (int k = 0; k < n * rows; ++k) {
    EXPECT_NEAR(swapped.body2[k], t.body1[k], 1e-9);
    EXPECT_NEAR(swapped.body1[k], t.body2[k], 1e-9);
    EXPECT_NEAR(mirror(back.body1)[k], t.body1[k], 1e-9);
    EXPECT_NEAR(pressure[k] > 0 ? t.body1[k] - t.body2[k] : 0, 0, 1e-9);
  }
}

/// Two rods in time, by explicit finite differences in depth: temperatures of their ends.
struct Rods {
  static constexpr int nodes = 500;
  static constexpr double dz = 0.02, dt = 4e-5;
  double conductivity1, conductivity2; // rho c = 1 in both
  std::vector<double> u1 = std::vector<double>(nodes, 0.0), u2 = std::vector<double>(nodes, 1.0);

  void step(bool touches, double heat) {
    const auto flux = [](const std::vector<double>& u, double conductivity, int k) {
      return conductivity * (u[k + 1] - u[k]) / dz;
    };
    double change1 = flux(u1, conductivity1, 0), change2 = flux(u2, conductivity2, 0);
    if (touches) change1 = change2 = (change1 + change2 + heat) / 2;
    std::vector<double> v1 = u1, v2 = u2;
    for (int k = 1; k + 1 < nodes; ++k) {
      v1[k] += dt / dz * (flux(u1, conductivity1, k) - flux(u1, conductivity1, k - 1));
      v2[k] += dt / dz * (flux(u2, conductivity2, k) - flux(u2, conductivity2, k - 1));
    }
    v1[0] += 2 * dt / dz * change1;
    v2[0] += 2 * dt / dz * change2;
    if (touches) v1[0] = v2[0] = ((u1[0] + u2[0]) / 2 + 2 * dt / dz * change1);
    u1 = v1;
    u2 = v2;
  }
};

TEST(SurfaceTemperature, TwoContactsInARowAgreeWithHeatConductionInDepth) {
  constexpr int elements = 100;
  constexpr double length = 1.0; // at V = 1: also the time
  const ThermalBody cold = {0, 1, 1, 1}, warm = {1, 4, 1, 1};
  const auto touches = [](double time) { return time < 0.3 || (time > 0.5 && time < 0.7); };
  const ElementGrid grid = row_of(elements, length / elements);
  std::vector<double> pressure, heat;
  for (int i = 0; i < elements; ++i) {
    pressure.push_back(touches(grid.x(i)) ? 1 : 0);
    heat.push_back(2 * pressure.back());
  }
  const auto t = surface_temperature(grid, RollingDirection::backward, 1, {cold, warm}, pressure, heat);
  Rods rods{1, 4};
  int steps = 0;
  for (int i = 0; i < elements; ++i) {
    for (; steps * Rods::dt < grid.x(i); ++steps) rods.step(touches(steps * Rods::dt), 2);
    if (i < 3) continue; // the depth's grid is too coarse there
    EXPECT_NEAR(t.body1[i], rods.u1[0], 0.02) << i;
    EXPECT_NEAR(t.body2[i], rods.u2[0], 0.02) << i;
  }
}

TEST(SurfaceTemperature, NamesWhatIsOutOfRange) {
  const std::vector<double> field(10, 1);
  const auto solve = [&](const ThermalBody& body, double at_speed) {
    return surface_temperature(row_of(10, 1e-4), RollingDirection::forward, at_speed, {thermal_steel, body}, field,
                               field);
  };
  expect_error([&] { solve({20, 0, 7850, 450}, 1); }, "body2.conductivity", "[W/(m K)]");
  expect_error([&] { solve({20, 50, -1, 450}, 1); }, "body2.density", "[kg/m^3]");
  expect_error([&] { solve({20, 50, 7850, 0}, 1); }, "body2.heat_capacity", "[J/(kg K)]");
  expect_error([&] { solve({INFINITY, 50, 7850, 450}, 1); }, "body2.bulk_temperature", "[deg C]");
  expect_error([&] { solve(thermal_steel, 0); }, "rolling_speed", "[m/s]");
  EXPECT_THROW(
      surface_temperature(row_of(9, 1e-4), RollingDirection::forward, 1, {thermal_steel, thermal_steel}, field, field),
      Error);
}

} // namespace
} // namespace microslip
