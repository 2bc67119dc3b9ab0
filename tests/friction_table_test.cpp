// Coefficients of friction given at slip velocities, or sampled from a function.

#include "microslip/friction/friction_table.hpp"

#include "microslip/friction/friction_law.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace microslip {
namespace {

using Number = Dual<double, 1>;

/// Coefficients that rise, fall and stay, at velocities with different distances.
FrictionTable uneven() {
  return {{0.01, 0.02, 0.3, 0.5, 2, 2.1, 7}, {0.2, 0.41, 0.43, 0.35, 0.35, 0.1, 0.12}};
}

/// Rises from rest to its peak and falls then, as measured on wheels and rails with a third body.
double stribeck(double v) {
  return 0.12 + 0.25 * (1 - std::exp(-v / 0.01)) * std::exp(-v / 0.8);
}

std::vector<double> equally_spaced(double last, int parts) {
  std::vector<double> v;
  for (int k = 0; k <= parts; ++k) v.push_back(last * k / parts);
  return v;
}

template <class Function> std::vector<double> values(const std::vector<double>& at, Function function) {
  std::vector<double> all;
  for (const double v : at) all.push_back(function(v));
  return all;
}

template <class Function> double largest_error(const FrictionTable& table, double last, Function function) {
  double error = 0;
  for (const double v : equally_spaced(last, 9973))
    error = std::max(error, std::abs(table.coefficient(v) - function(v)));
  return error;
}

TEST(FrictionTable, HasItsCoefficientsAndIsConstantBeyond) {
  const FrictionTable table = uneven();
  for (std::size_t i = 0; i < table.grid().coefficients.size(); ++i)
    EXPECT_DOUBLE_EQ(table.coefficient(table.grid().slip_velocities[i]), table.grid().coefficients[i]);
  for (const double v : {0.0, 0.005}) EXPECT_EQ(table.coefficient(v), 0.2);
  for (const double v : {7.0, 7.1, 1e300, infinity}) EXPECT_EQ(table.coefficient(v), 0.12);
  EXPECT_EQ(table.coefficient(Number::variable(8, 0)).partial[0], 0);
  EXPECT_EQ(table.largest(), 0.43);
  EXPECT_EQ(table.least(), 0.1);
}

TEST(FrictionTable, IsMonotoneBetweenItsCoefficients) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (int n = 0; n < 200; ++n) {
    std::vector<double> v = {share(random)}, mu = {share(random)};
    for (int i = 0; i < 12; ++i) {
      v.push_back(v.back() + std::pow(10, -4 * share(random)));
      mu.push_back(share(random) < 0.2 ? mu.back() : share(random));
    }
    const FrictionTable table(v, mu);
    for (std::size_t i = 0; i + 1 < v.size(); ++i) {
      const double sign = mu[i + 1] > mu[i] ? 1 : -1;
      double previous = mu[i];
      for (int k = 1; k <= 40; ++k) {
        const double now = k == 40 ? mu[i + 1] : table.coefficient(v[i] + (v[i + 1] - v[i]) * k / 40);
        EXPECT_GE(sign * (now - previous), -1e-14);
        previous = now;
      }
    }
  }
}

TEST(FrictionTable, SlopeIsContinuousInside) {
  const FrictionTable table = uneven();
  const std::vector<double>& v = table.grid().slip_velocities;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    const Number before = table.coefficient(Number::variable(v[i] * (1 - 1e-12), 0)),
                 behind = table.coefficient(Number::variable(v[i] * (1 + 1e-12), 0));
    EXPECT_NEAR(before.partial[0], behind.partial[0], 1e-7);
  }
}

TEST(FrictionTable, DerivativeIsTheSlope) {
  const FrictionTable table = uneven();
  for (const double v : {0.004, 0.013, 0.1, 0.4, 2.05, 5.0, 9.0}) {
    const double h = 1e-6;
    const Number result = table.coefficient(Number::variable(v, 0));
    EXPECT_EQ(result.value, table.coefficient(v));
    EXPECT_NEAR(result.partial[0], (table.coefficient(v + h) - table.coefficient(v - h)) / (2 * h), 1e-6);
  }
}

TEST(FrictionTable, TwoCoefficientsMakeAStraightLineAndEqualOnesAConstant) {
  const FrictionTable line({0, 2}, {0.4, 0.2}), constant({0, 1, 3}, {0.3, 0.3, 0.3});
  for (const double v : {0.0, 0.5, 1.7}) {
    EXPECT_DOUBLE_EQ(line.coefficient(v), 0.4 - 0.1 * v);
    EXPECT_EQ(constant.coefficient(v), 0.3);
  }
}

TEST(FrictionTable, UnitsOfVelocityDoNotMatter) {
  const FrictionTable table = uneven();
  std::vector<double> v = table.grid().slip_velocities;
  for (double& one : v) one *= 1024;
  const FrictionTable other(v, table.grid().coefficients);
  for (const double at : {0.015, 0.4, 2.07}) EXPECT_EQ(table.coefficient(at), other.coefficient(1024 * at));
}

TEST(FrictionTable, ErrorIsOfThirdOrderWhereThereIsNoExtremum) {
  const auto falling = [](double v) { return 0.2 + 0.2 * std::exp(-v); };
  std::vector<double> errors;
  for (const int parts : {32, 64, 128}) {
    const auto v = equally_spaced(4, parts);
    errors.push_back(largest_error({v, values(v, falling)}, 4, falling));
  }
  for (std::size_t k = 1; k < errors.size(); ++k) {
    EXPECT_GT(errors[k - 1] / errors[k], 6.5);
    EXPECT_LT(errors[k - 1] / errors[k], 9.5);
  }
}

TEST(FrictionTable, SamplesAreAsAccurateAsWanted) {
  const FrictionLaw kinked = FrictionLaw::linear(0.2, {.drop = 0.2, .half_velocity = 0.7});
  const auto linear = [&](double v) { return kinked.coefficient(v); };
  for (const double accuracy : {1e-4, 1e-6}) {
    EXPECT_LT(largest_error(FrictionTable::sampled(stribeck, 6, accuracy), 6, stribeck), 1.5 * accuracy);
    EXPECT_LT(largest_error(FrictionTable::sampled(linear, 6, accuracy), 6, linear), 1.5 * accuracy);
  }
  EXPECT_LT(FrictionTable::sampled(stribeck, 6).grid().coefficients.size(), 2000);
  EXPECT_EQ(FrictionTable::sampled([](double) { return 0.3; }, 6).coefficient(1.0), 0.3);
}

TEST(FrictionTable, RefusesFunctionsThatItCannotSample) {
  const auto sample = [](auto function) { return FrictionTable::sampled(function, 5); };
  expect_words([&] { sample([](double v) { return v < 2 ? 0.4 : 0.3; }); }, "coefficient: must not jump");
  expect_error([&] { sample([](double v) { return 0.3 - v; }); }, "coefficient at slip_velocity = 0.3125 m/s",
               "must be in [0, 10]");
  expect_error([&] { sample([](double) { return nan; }); }, "coefficient at slip_velocity = 0 m/s",
               "must be in [0, 10]");
  expect_error([&] { sample([](double v) { return 0.3 + 0.1 * std::sin(1e9 * v); }); }, "accuracy", "100,000 samples");
  expect_error([&] { FrictionTable::sampled(stribeck, 0); }, "fastest", "must be in [1e-06, 1e+06]");
  expect_error([&] { FrictionTable::sampled(stribeck, 1, 0); }, "accuracy", "must be positive and finite");
  EXPECT_THROW(sample([](double) -> double { throw std::runtime_error("mine"); }), std::runtime_error);
}

TEST(FrictionTable, RefusesNumbersOutOfRangeByTheirPlace) {
  const std::vector<double> v = {0, 1, 2}, mu = {0.4, 0.3, 0.2};
  const std::string range = "[-]: must be in [0, 10]";
  for (const double bad : {-0.1, 10.1, infinity, nan})
    expect_error([&] { FrictionTable(v, {0.4, bad, 0.2}); }, "coefficients.2", range);
  for (const double bad : {-0.1, infinity, nan})
    expect_error([&] { FrictionTable({bad, 1, 2}, mu); }, "slip_velocities.1", "[m/s]: must be in [0, 1e+06]");
  for (const double bad : {1.0, 0.5})
    expect_error([&] { FrictionTable({0, 1, bad}, mu); }, "slip_velocities.3", "must be above the one before, 1");
  expect_error([&] { FrictionTable({0, 1e-200, 1}, mu); }, "slip_velocities.2", "farther from the one before");
  expect_words([&] { FrictionTable(v, {0.4, 0.3}); }, "coefficients: must be 3 numbers");
  expect_words([&] { FrictionTable({1}, {0.4}); }, "slip_velocities: must be at least 2 numbers");
}

/// mu at two pressures and three temperatures.
FrictionGrid some_grid() {
  return {{0, 0.1, 2},
          {1e8, 1e9},
          {0, 100, 300},
          {0.40, 0.35, 0.20, 0.36, 0.33, 0.19, 0.35, 0.30, 0.18, 0.33, 0.28, 0.17, 0.25, 0.22, 0.12, 0.21, 0.20, 0.11}};
}

TEST(FrictionTable, HasTheCoefficientsOfAGridAndIsLinearBetweenPressuresAndTemperatures) {
  const FrictionGrid grid = some_grid();
  const FrictionTable table(grid);
  std::size_t node = 0;
  for (const double t : grid.temperatures)
    for (const double p : grid.pressures)
      for (const double v : grid.slip_velocities)
        EXPECT_DOUBLE_EQ(table.coefficient(v, p, t), grid.coefficients[node++]);
  for (const double v : {0.0, 0.04, 1.0, 5.0}) {
    const double corners[] = {table.coefficient(v, 1e8, 100.0), table.coefficient(v, 1e9, 100.0),
                              table.coefficient(v, 1e8, 300.0), table.coefficient(v, 1e9, 300.0)};
    EXPECT_NEAR(table.coefficient(v, 3.25e8, 150.0),
                0.75 * (0.75 * corners[0] + 0.25 * corners[1]) + 0.25 * (0.75 * corners[2] + 0.25 * corners[3]), 1e-15);
    EXPECT_EQ(table.coefficient(v, 1e7, 400.0), corners[2]);
    EXPECT_EQ(table.coefficient(v, 5e9, 300.0), corners[3]);
    EXPECT_EQ(table.coefficient(v), table.coefficient(v, 0.0, -50.0));
    EXPECT_NEAR(table.at(3.25e8, 150).coefficient(0.1), table.coefficient(0.1, 3.25e8, 150.0), 1e-15);
  }
  EXPECT_DOUBLE_EQ(table.largest(5.5e8), 0.38);
}

TEST(FrictionTable, DerivativesToPressureAndTemperatureAreTheSlopes) {
  using Three = Dual<double, 3>;
  const FrictionTable table(some_grid());
  const double v = 0.3, p = 4e8, t = 170;
  const Three found = table.coefficient(Three::variable(v, 0), Three::variable(p, 1), Three::variable(t, 2));
  EXPECT_EQ(found.value, table.coefficient(v, p, t));
  EXPECT_NEAR(found.partial[0], (table.coefficient(v + 1e-6, p, t) - table.coefficient(v - 1e-6, p, t)) / 2e-6, 1e-8);
  EXPECT_NEAR(found.partial[1], (table.coefficient(v, p + 1e3, t) - table.coefficient(v, p - 1e3, t)) / 2e3, 1e-16);
  EXPECT_NEAR(found.partial[2], (table.coefficient(v, p, t + 1) - table.coefficient(v, p, t - 1)) / 2, 1e-14);
}

TEST(FrictionTable, RefusesGridsByThePlaceOfTheirNumbers) {
  FrictionGrid grid = some_grid();
  grid.coefficients.pop_back();
  expect_words([&] { FrictionTable{grid}; },
               "coefficients: must be 18 numbers, one for each of the grid's nodes, not 17");
  grid = some_grid();
  grid.pressures[1] = 1e8;
  expect_error([&] { FrictionTable{grid}; }, "pressures.2", "must be above the one before, 1e+08");
  grid = some_grid();
  grid.temperatures[0] = nan;
  expect_error([&] { FrictionTable{grid}; }, "temperatures.1", "[deg C]: must be in [-274, 1e+06]");
}

} // namespace
} // namespace microslip
