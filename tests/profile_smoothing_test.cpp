#include "microslip/railway/profile/profile_smoothing.hpp"
#include "microslip/railway/profile/quintic_smoothing.hpp"

#include "tests/support/expect_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
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
double transfer(double wavelength,
                const std::function<std::vector<ProfilePoint>(std::vector<ProfilePoint>)>& smooth_by) {
  const double amplitude = 1e-7;
  const auto points = wave(wavelength, amplitude);
  const auto smooth = smooth_by(points);
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
    const auto by_curvature = [](const auto& points) { return smoothed(points, {}, 3e-3); };
    EXPECT_NEAR(transfer(wavelength, by_curvature), 1 / (1 + std::pow(ratio, 4)), 0.006) << wavelength;
    const auto by_third_derivative = [](const auto& points) {
      return smoothed_with_weights(points, {}, std::pow(3e-3 / (2 * pi), 6), shares_of_length(points),
                                   SmoothingPenalty::third_derivative);
    };
    EXPECT_NEAR(transfer(wavelength, by_third_derivative), 1 / (1 + std::pow(ratio, 6)), 0.006) << wavelength;
  }
}

/// Values smoothed by the third derivative at uneven steps with uneven weights.
std::vector<double> by_third_derivative(std::vector<double> values, double lambda, std::vector<double>* at = nullptr,
                                        std::vector<double>* weights = nullptr) {
  std::vector<double> steps, inverse_weights, s = {0};
  for (std::size_t k = 0; k < values.size(); ++k) inverse_weights.push_back(k % 4 == 0 ? 0.5 : 1.7);
  for (std::size_t k = 0; k + 1 < values.size(); ++k) {
    steps.push_back(k % 3 == 0 ? 1.3 : 0.6);
    s.push_back(s.back() + steps.back());
  }
  QuinticSmoothing(steps, inverse_weights, lambda).smooth(values);
  if (at) *at = s;
  if (weights)
    for (const double inverse : inverse_weights) weights->push_back(1 / inverse);
  return values;
}

TEST(ProfileSmoothing, ByTheThirdDerivativeParabolasStay) {
  std::vector<double> s;
  by_third_derivative(std::vector<double>(50), 1, &s);
  std::vector<double> parabola;
  for (const double at : s) parabola.push_back(3 - 2 * at + 0.4 * at * at);
  for (const double lambda : {1e-6, 1.0, 1e6}) {
    const auto smooth = by_third_derivative(parabola, lambda);
    for (std::size_t k = 0; k < s.size(); ++k) EXPECT_NEAR(smooth[k], parabola[k], 1e-9 * (1 + parabola[k]));
  }
  for (const std::size_t few : {0, 1, 2, 3})
    EXPECT_EQ(by_third_derivative(std::vector<double>(few, 5), 1e6), std::vector<double>(few, 5));
}

/// At the least of sum w (x - f)^2 + lambda int f'''^2 what is left is orthogonal to parabolas; without end of lambda
/// f is the parabola that fits best, and without lambda the values.
TEST(ProfileSmoothing, ByTheThirdDerivativeTheRestIsOrthogonalToParabolas) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<double> values(60);
  for (double& value : values) value = any(random);
  EXPECT_EQ(by_third_derivative(values, 0), values);
  for (const double lambda : {0.01, 10.0, 1e5}) {
    std::vector<double> s, weights;
    const auto smooth = by_third_derivative(values, lambda, &s, &weights);
    for (const int power : {0, 1, 2}) {
      double moment = 0, size = 0;
      for (std::size_t k = 0; k < s.size(); ++k) {
        const double one = weights[k] * std::pow(s[k] / s.back(), power) * (values[k] - smooth[k]);
        moment += one;
        size += std::abs(one);
      }
      EXPECT_NEAR(moment, 0, 1e-9 * size) << lambda << " " << power;
      EXPECT_GT(size, 0.1);
    }
  }
}

TEST(ProfileSmoothing, ByTheThirdDerivativeTwiceIsSmootherThanOnce) {
  std::vector<double> values(40);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::sin(0.9 * double(k)) + 0.1 * double(k);
  const auto once = by_third_derivative(values, 3), twice = by_third_derivative(once, 3);
  const auto roughness = [](const std::vector<double>& v) {
    double sum = 0;
    for (std::size_t k = 0; k + 3 < v.size(); ++k) sum += std::pow(v[k + 3] - 3 * v[k + 2] + 3 * v[k + 1] - v[k], 2);
    return sum;
  };
  EXPECT_LT(roughness(once), 0.5 * roughness(values));
  EXPECT_LT(roughness(twice), roughness(once));
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

} // namespace
} // namespace microslip
