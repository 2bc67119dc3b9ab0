// Samples of a sweep and what statistics make of them: distributions against their closed forms, point sets against
// what they promise, Sobol's indices of a function that has them in closed form.

#include "campaign/distribution.hpp"
#include "campaign/sample.hpp"
#include "campaign/statistics.hpp"
#include "tests/support/expect_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using campaign::Distribution, campaign::PointSet, campaign::Sample, campaign::SampleAim, campaign::SamplePoints,
    campaign::Spread;

/// Quantiles in the middle of n parts of one probability.
std::vector<double> middles(const Distribution& distribution, int n) {
  std::vector<double> all;
  for (int i = 0; i < n; ++i) all.push_back(distribution.quantile((i + 0.5) / n));
  return all;
}

TEST(Distribution, NormalScoresAreInvertedToRounding) {
  for (const double score : {-8.0, -3.0, -1e-3, 0.0, 0.5, 2.0, 5.0})
    EXPECT_NEAR(campaign::normal_quantile(campaign::normal_probability(score)), score,
                1e-15 * (1 + std::exp(score * score / 2)));
  EXPECT_NEAR(campaign::normal_quantile(0.975), 1.959963984540054, 1e-14);
}

TEST(Distribution, MeansAndDeviationsAreThoseThatAreGiven) {
  constexpr int n = 200'000;
  for (const auto kind : {Distribution::Kind::normal, Distribution::Kind::log_normal}) {
    const Distribution d{.kind = kind, .mean = 80, .standard_deviation = 8};
    const Spread spread = campaign::spread_of(middles(d, n), {});
    EXPECT_NEAR(spread.mean, 80, 1e-3);
    EXPECT_NEAR(spread.standard_deviation, 8, 2e-3);
  }
  const Distribution triangle{.kind = Distribution::Kind::triangular, .from = 1, .to = 4, .mode = 2};
  const Spread spread = campaign::spread_of(middles(triangle, n), {});
  EXPECT_NEAR(spread.mean, (1 + 4 + 2) / 3.0, 1e-8);
  EXPECT_NEAR(std::pow(spread.standard_deviation, 2), (1 + 16 + 4 - 4 - 2 - 8) / 18.0, 1e-4);
}

TEST(Distribution, ANormalOneIsCutOffAtItsEnds) {
  const Distribution cut{.kind = Distribution::Kind::normal, .from = -1, .to = 1, .mean = 0, .standard_deviation = 1};
  EXPECT_NEAR(cut.quantile(0), -1, 1e-12);
  EXPECT_NEAR(cut.quantile(1), 1, 1e-12);
  EXPECT_NEAR(cut.quantile(0.5), 0, 1e-12);
  // of the cut density: half of what lies above 0 lies below the median of |z| < 1
  EXPECT_NEAR(cut.quantile(0.75), campaign::normal_quantile(0.5 + 0.25 * std::erf(1 / std::numbers::sqrt2)), 1e-12);
  for (const double part : {0.0, 1.0})
    EXPECT_TRUE(std::isfinite(
        Distribution{.kind = Distribution::Kind::normal, .mean = 0, .standard_deviation = 1}.quantile(part)));
}

TEST(Distribution, WhatNoneHasIsRefused) {
  const auto refused = [](const Distribution& d) { return error_of([&] { d.check(); }); };
  using enum Distribution::Kind;
  EXPECT_EQ(refused({.kind = normal, .mean = 1, .standard_deviation = 0}),
            "standard_deviation = 0 []: must be positive");
  EXPECT_EQ(refused({.kind = log_normal, .mean = -1, .standard_deviation = 1}),
            "mean = -1 []: must be positive in a log_normal distribution");
  EXPECT_EQ(refused({.kind = triangular, .from = 1, .to = 2, .mode = 3}), "mode = 3 []: must be between from and to");
  EXPECT_EQ(refused({.kind = normal, .from = 90, .to = 91, .mean = 0, .standard_deviation = 1}),
            "from and to leave less than 1e-6 of the distribution between them");
}

TEST(SamplePoints, ALatinHypercubeHasOneValueInEachPart) {
  const std::vector<std::string> names = {"a", "b"};
  for (const std::size_t n : {1u, 2u, 3u, 17u, 1000u}) {
    const SamplePoints points(PointSet::latin_hypercube, n, 7, names);
    for (std::size_t k = 0; k < 2; ++k) {
      std::set<std::size_t> parts;
      for (std::size_t i = 0; i < n; ++i)
        parts.insert(static_cast<std::size_t>(points.at(i, k) * static_cast<double>(n)));
      EXPECT_EQ(parts.size(), n);
      EXPECT_LT(*parts.rbegin(), n);
    }
  }
}

/// Of every 2^m points from a multiple of 2^m on each coordinate has one in each of 2^m parts, whatever the shift.
TEST(SamplePoints, SobolsSequenceIsBalancedInEveryCoordinate) {
  std::vector<std::string> names;
  for (int k = 0; k < 40; ++k) names.push_back("key" + std::to_string(k));
  const SamplePoints points(PointSet::sobol, 4096, 3, names);
  for (const std::size_t m : {4u, 8u})
    for (std::size_t k = 0; k < names.size(); ++k) {
      const std::size_t count = std::size_t{1} << m;
      std::set<std::size_t> parts;
      for (std::size_t i = 3 * count; i < 4 * count; ++i)
        parts.insert(static_cast<std::size_t>(points.at(i, k) * static_cast<double>(count)));
      EXPECT_EQ(parts.size(), count) << k;
    }
}

/// The mean of a smooth function by n points of the sequence errs like 1/n, by random ones like 1/sqrt(n).
TEST(SamplePoints, SobolsSequenceIntegratesBetterThanRandomPoints) {
  const std::vector<std::string> names = {"a", "b", "c", "d"};
  const auto error = [&](PointSet set, std::uint64_t seed) {
    constexpr std::size_t n = 4096;
    const SamplePoints points(set, n, seed, names);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double product = 1;
      for (std::size_t k = 0; k < names.size(); ++k) product *= 1 + 0.5 * (points.at(i, k) - 0.5);
      sum += product;
    }
    return std::abs(sum / n - 1);
  };
  double random = 0, sobol = 0, hypercube = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    random += error(PointSet::random, seed);
    sobol += error(PointSet::sobol, seed);
    hypercube += error(PointSet::latin_hypercube, seed);
  }
  EXPECT_LT(sobol, 0.05 * random);
  EXPECT_LT(hypercube, 0.2 * random);
}

TEST(Sample, CorrelationsAreThoseOfNormalScores) {
  const Sample sample(SampleAim::quantiles, PointSet::sobol, 8192, 1, {"a", "b", "c"}, {{0, 2, 0.6}, {2, 1, -0.3}});
  std::array<std::array<double, 3>, 3> sums{};
  for (std::size_t i = 0; i < sample.cases(); ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        sums[j][k] += campaign::normal_quantile(sample.part(i, j)) * campaign::normal_quantile(sample.part(i, k)) /
                      static_cast<double>(sample.cases());
  EXPECT_NEAR(sums[0][2], 0.6, 0.01);
  EXPECT_NEAR(sums[1][2], -0.3, 0.01);
  EXPECT_NEAR(sums[0][1], 0, 0.01);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(sums[k][k], 1, 0.01);
  expect_words(
      [] {
        Sample(SampleAim::quantiles, PointSet::random, 9, 1, {"a", "b", "c"}, {{0, 1, .9}, {1, 2, .9}, {0, 2, -.9}});
      },
      "not positive definite");
}

/// Ishigami's function, sin x + 7 sin^2 y + 0.1 z^4 sin x of three uniform angles, has its indices in closed form.
TEST(Statistics, SobolIndicesOfIshigamisFunctionAreThoseInClosedForm) {
  constexpr double a = 7, b = 0.1, pi = std::numbers::pi;
  const double pi4 = std::pow(pi, 4), pi8 = pi4 * pi4;
  const double v1 = 0.5 * std::pow(1 + b * pi4 / 5, 2), v2 = a * a / 8, v13 = b * b * pi8 * (1 / 18.0 - 1 / 50.0),
               v = v1 + v2 + v13;
  const Sample sample(SampleAim::sobol_indices, PointSet::sobol, 1 << 14, 1, {"x", "y", "z"}, {});
  std::vector<double> values;
  for (std::size_t i = 0; i < sample.cases(); ++i) {
    const auto angle = [&](std::size_t k) { return pi * (2 * sample.part(i, k) - 1); };
    values.push_back(std::sin(angle(0)) * (1 + b * std::pow(angle(2), 4)) + a * std::pow(std::sin(angle(1)), 2));
  }
  const std::vector<campaign::SobolIndex> indices = campaign::sobol_indices(values, 3);
  const std::array<double, 3> first{v1 / v, v2 / v, 0}, total{(v1 + v13) / v, v2 / v, v13 / v};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(indices[k].first, first[k], 0.005);
    EXPECT_NEAR(indices[k].total, total[k], 0.005);
    EXPECT_NEAR(indices[k].first, first[k], 4 * indices[k].first_error);
    EXPECT_LT(indices[k].first_error, 0.03);
  }
}

/// Standard errors of indices from independent points are the scatter of repetitions.
TEST(Statistics, ErrorsOfSobolIndicesAreTheirScatter) {
  constexpr int repetitions = 200;
  std::vector<double> found, errors;
  for (int seed = 0; seed < repetitions; ++seed) {
    const Sample sample(SampleAim::sobol_indices, PointSet::random, 500, static_cast<std::uint64_t>(seed), {"x", "y"},
                        {});
    std::vector<double> values;
    for (std::size_t i = 0; i < sample.cases(); ++i)
      values.push_back(sample.part(i, 0) + sample.part(i, 0) * sample.part(i, 1));
    const auto index = campaign::sobol_indices(values, 2).front();
    found.push_back(index.first);
    errors.push_back(index.first_error);
  }
  const Spread scatter = campaign::spread_of(found, {}), mean = campaign::spread_of(errors, {});
  EXPECT_NEAR(mean.mean / scatter.standard_deviation, 1, 0.2);
}

TEST(Statistics, IntervalsHaveTheQuantileNineteenTimesOfTwenty) {
  const std::array<double, 3> probabilities{0.05, 0.5, 0.95};
  std::array<int, 3> inside{};
  constexpr int repetitions = 2000;
  for (int seed = 0; seed < repetitions; ++seed) {
    const Sample sample(SampleAim::quantiles, PointSet::random, 200, static_cast<std::uint64_t>(seed), {"x"}, {});
    std::vector<double> values;
    for (std::size_t i = 0; i < sample.cases(); ++i) values.push_back(sample.part(i, 0));
    const Spread spread = campaign::spread_of(values, probabilities);
    for (std::size_t k = 0; k < 3; ++k)
      inside[k] += spread.quantiles[k].low <= probabilities[k] && probabilities[k] <= spread.quantiles[k].high;
  }
  for (const int count : inside) {
    EXPECT_GT(count, 0.94 * repetitions);
    EXPECT_LT(count, 0.98 * repetitions);
  }
}

TEST(Statistics, NumbersThatCasesLackAreLeftOut) {
  const double nan = std::nan("");
  const std::array<double, 4> values{3, nan, 1, 2};
  const std::array<double, 1> half{0.5};
  const Spread spread = campaign::spread_of(values, half);
  EXPECT_EQ(spread.count, 3u);
  EXPECT_EQ(spread.mean, 2);
  EXPECT_EQ(spread.quantiles.front().value, 2);
  EXPECT_EQ(spread.least, 1);
  EXPECT_EQ(spread.largest, 3);
  EXPECT_TRUE(std::isnan(campaign::spread_of({}, half).mean));
}

} // namespace
} // namespace microslip
