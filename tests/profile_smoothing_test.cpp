#include "microslip/railway/profile/profile_smoothing.hpp"

#include "tests/support/expect_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace microslip {
namespace {

constexpr double pi = std::numbers::pi;

/// A wave of small amplitude on a straight line, at uneven spacing.
std::vector<ProfilePoint> wave(double wavelength, double amplitude) {
  std::vector<ProfilePoint> points;
  double y = 0;
  for (int k = 0; y < 0.1; ++k, y += 1e-4 * (k % 3 == 0 ? 1.3 : 0.85))
    points.push_back({y, amplitude * std::sin(2 * pi * y / wavelength)});
  return points;
}

/// What is left of the wave, in the middle of the profile, by its projection on the sine.
double transfer(double wavelength, double length) {
  const double amplitude = 1e-7;
  const auto points = wave(wavelength, amplitude);
  const auto smooth = smoothed(points, {}, length);
  double sum = 0, squares = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (points[k].y < 0.03 || points[k].y > 0.07) continue;
    const double phase = std::sin(2 * pi * points[k].y / wavelength);
    sum += smooth[k].z * phase;
    squares += amplitude * phase * phase;
  }
  return sum / squares;
}

TEST(ProfileSmoothing, PassesWavesByTheirLength) {
  for (const double wavelength : {1.5e-3, 3e-3, 4e-3, 8e-3}) {
    const double ratio = 3e-3 / wavelength;
    EXPECT_NEAR(transfer(wavelength, 3e-3), 1 / (1 + std::pow(ratio, 4)), 0.006) << wavelength;
  }
}

TEST(ProfileSmoothing, LeavesStraightLinesAndKinksWhereTheyAre) {
  std::vector<ProfilePoint> points;
  for (int k = -50; k <= 50; ++k) points.push_back({1e-3 * k, -1e-3 * std::abs(k)});
  const std::vector<std::size_t> kinks = {50};
  const auto smooth = smoothed(points, kinks, 5e-3);
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_NEAR(smooth[k].y, points[k].y, 1e-15);
    EXPECT_NEAR(smooth[k].z, points[k].z, 1e-15);
  }
  const auto rounded = smoothed(points, {}, 5e-3);
  EXPECT_LT(rounded[50].z, -2e-4);
}

TEST(ProfileSmoothing, HeavyPointsStay) {
  std::vector<ProfilePoint> points;
  for (int k = 0; k <= 20; ++k) points.push_back({double(k), k == 10 ? 1.0 : 0.0});
  std::vector<double> weights(points.size(), 1);
  EXPECT_LT(smoothed_with_weights(points, {}, 100, weights)[10].z, 0.2);
  weights[10] = 1e6;
  EXPECT_NEAR(smoothed_with_weights(points, {}, 100, weights)[10].z, 1, 1e-4);
  EXPECT_EQ(smoothed_with_weights(points, {}, 0, weights)[10].z, 1);
}

TEST(ProfileSmoothing, TendsToThePointsAndToALine) {
  const auto points = wave(5e-3, 1e-5);
  EXPECT_NEAR(smoothed(points, {}, 1e-5)[700].z, points[700].z, 1e-12);
  EXPECT_NEAR(smoothed(points, {}, 1.0)[700].z, 0, 1e-6);
  expect_error([&] { smoothed(points, {}, -1); }, "smoothing_length", "[m]: must be in (0, 1]");
}

TEST(ProfileSmoothing, EstimatesNoiseWhateverTheShape) {
  std::mt19937 random(7);
  const double sigma = 5e-6;
  std::normal_distribution<double> error(0, sigma);
  std::vector<ProfilePoint> points;
  for (int k = 0; k < 3000; ++k) {
    const double angle = -0.6 + 1.2 * k / 2999, radius = 0.3 + error(random);
    points.push_back({radius * std::sin(angle), radius * std::cos(angle)});
  }
  points[300].z += 1e-3; // an outlier
  const auto noise = estimate_noise(points);
  EXPECT_NEAR(noise.deviation, sigma, 0.1 * sigma);
  const double spacing = 0.3 * 1.2 / 2999;
  EXPECT_NEAR(noise.curvature, std::sqrt(6.0) * sigma / (spacing * spacing), 0.15 * noise.curvature);
}

TEST(ProfileSmoothing, TheLengthThatNoiseAsksForBringsItsCurvatureDown) {
  std::mt19937 random(7);
  std::normal_distribution<double> error(0, 5e-6);
  std::vector<ProfilePoint> points;
  for (int k = 0; k < 2000; ++k) points.push_back({2e-4 * k, error(random)});
  const auto noise = estimate_noise(points);
  const Profile profile(ProfileRole::rail, smoothed(points, {}, noise.smoothing_length));
  double squares = 0;
  for (int k = 0; k < 4000; ++k) {
    const double curvature = profile.at(profile.length() * (0.1 + 0.8 * k / 4000)).second.z;
    squares += curvature * curvature / 4000;
  }
  EXPECT_NEAR(std::sqrt(squares), 3, 0.5);
}

TEST(ProfileSmoothing, FindsNoNoiseInArcs) {
  std::vector<ProfilePoint> points;
  for (int k = 0; k <= 400; ++k) {
    const double angle = -1.2 + 2.4 * k / 400;
    points.push_back({0.08 * std::sin(angle), 0.08 * std::cos(angle)});
  }
  EXPECT_LT(estimate_noise(points).deviation, 1e-10);
  EXPECT_EQ(estimate_noise(points).smoothing_length, 0);
}

} // namespace
} // namespace microslip
