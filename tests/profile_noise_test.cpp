#include "microslip/railway/profile/profile_noise.hpp"

#include "io/profile_file.hpp"
#include "microslip/railway/profile/curvature_steps.hpp"
#include "microslip/railway/profile/profile_preparation.hpp"
#include "microslip/railway/profile/profile_smoothing.hpp"
#include "paths.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace microslip {
namespace {

constexpr double um = 1e-6;

/// Normal errors of deviation 1, the same for the same seed.
std::vector<double> white(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> error;
  std::vector<double> errors(count);
  for (double& e : errors) e = error(random);
  return errors;
}

std::vector<ProfilePoint> with_errors(std::vector<ProfilePoint> points, std::span<const double> errors, double sigma) {
  for (std::size_t k = 0; k < points.size(); ++k) points[k].z += sigma * errors[k];
  return points;
}

/// An arc of a circle of this radius on the points between y = -width and y = width.
std::vector<ProfilePoint> arc(double radius, double width, double spacing) {
  std::vector<ProfilePoint> points;
  for (double y = -width; y <= width; y += spacing) points.push_back({y, std::sqrt(radius * radius - y * y) - radius});
  return points;
}

/// Two arcs with a common tangent at y = 0, curvatures [1/m] on the left and on the right.
std::vector<ProfilePoint> two_arcs(double left, double right, double spacing) {
  std::vector<ProfilePoint> points;
  for (double y = -0.03; y <= 0.03; y += spacing) {
    const double curvature = y < 0 ? left : right;
    points.push_back({y, -curvature * y * y / (1 + std::sqrt(1 - curvature * curvature * y * y))});
  }
  return points;
}

double curvature_at_y(const Profile& profile, double y) {
  double low = 0, high = profile.length();
  for (int k = 0; k < 60; ++k) (profile.at((low + high) / 2).value.y < y ? low : high) = (low + high) / 2;
  const CurvePoint p = profile.at(low);
  return (p.first.y * p.second.z - p.first.z * p.second.y) / std::pow(std::hypot(p.first.y, p.first.z), 3);
}

TEST(ProfileNoise, IsEstimatedWhateverTheShape) {
  const double sigma = 5 * um, spacing = 0.3 * 1.2 / 2999;
  const auto errors = white(3000, 7);
  std::vector<ProfilePoint> points;
  for (int k = 0; k < 3000; ++k) {
    const double angle = -0.6 + 1.2 * k / 2999, radius = 0.3 + sigma * errors[static_cast<std::size_t>(k)];
    points.push_back({radius * std::sin(angle), radius * std::cos(angle)});
  }
  points[300].z += 1e-3; // an outlier
  const auto noise = estimate_noise(points);
  EXPECT_NEAR(noise.deviation, sigma, 0.15 * sigma);  // an upper quartile, of 9 % scatter
  EXPECT_LT(noise.long_waves, 1.1 * noise.deviation); // errors are independent
  EXPECT_NEAR(noise.curvature, std::sqrt(6.0) * sigma / (spacing * spacing), 0.15 * noise.curvature);
}

TEST(ProfileNoise, ThatNeighboursShareHasLongWaves) {
  // Means of n errors in succession, times sqrt(n): single points scatter as before, means of many sqrt(n) times as
  // much.
  constexpr std::size_t shared = 4;
  const auto errors = white(2010, 3);
  std::vector<double> mean(errors.size());
  for (std::size_t k = shared; k < errors.size(); ++k)
    for (std::size_t i = 0; i < shared; ++i) mean[k] += errors[k - i] / std::sqrt(static_cast<double>(shared));
  const auto noise = estimate_noise(with_errors(arc(0.3, 0.08, 0.8e-4), mean, 4 * um));
  EXPECT_LT(noise.deviation, 4 * um);
  EXPECT_NEAR(noise.long_waves, 8 * um, 2 * um);
}

TEST(ProfileNoise, OfRoundedValuesIsThatOfTheirLongWaves) {
  const double quantum = 5 * um;
  auto points = arc(0.3, 0.03, 1e-4);
  for (auto& p : points) p.z = quantum * std::round(p.z / quantum);
  const auto noise = estimate_noise(points);
  EXPECT_GT(noise.long_waves, 0.5 * quantum / std::sqrt(12.0));
  EXPECT_GT(noise.smoothing_length, 0);
}

TEST(ProfileNoise, IsNotFoundInArcs) {
  for (const double radius : {0.3, 0.08, 0.013})
    for (const double spacing : {0.05e-3, 0.25e-3, 0.5e-3}) {
      const auto noise = estimate_noise(arc(radius, 0.8 * std::min(radius, 0.04), spacing));
      EXPECT_LT(noise.deviation, 2e-8) << radius << ' ' << spacing;
      EXPECT_EQ(noise.smoothing_length, 0) << radius << ' ' << spacing;
    }
}

TEST(ProfileNoise, LeavesNominalProfilesAsTheyAre) {
  for (const char* name : {"60e1.prr", "s1002.prw"}) {
    const auto prepared = io::read_profile(std::string(MICROSLIP_SOURCE_DIR "/examples/profiles/") + name);
    EXPECT_FALSE(prepared.report.smoothing.by_noise);
    for (std::size_t k = 0; k < prepared.points.size(); ++k) {
      EXPECT_EQ(prepared.points[k].y, prepared.measured[k].y);
      EXPECT_EQ(prepared.points[k].z, prepared.measured[k].z);
    }
  }
}

TEST(CurvatureSteps, LeaveTwoParabolasAsTheyAre) {
  const std::size_t count = 60;
  std::vector<double> s, curvature(count), measured, variances(count, 1e-12);
  for (std::size_t k = 0; k < count; ++k) {
    s.push_back(2e-4 * static_cast<double>(k) + (k % 3 == 0 ? 3e-5 : 0.0));
    const double t = s.back() - 6e-3;
    measured.push_back(t > 0 ? 10 * t * t : 0);
  }
  const auto found = distances_with_few_curvature_steps(s, curvature, measured, variances);
  for (std::size_t k = 0; k < count; ++k) EXPECT_NEAR(found[k], measured[k], 1e-6) << k; // within their errors
}

TEST(CurvatureSteps, TakeParabolasAndTheCurveBesideOutOfTheData) {
  // What the curve beside already has is no step, and a parabola has none.
  const std::size_t count = 200;
  const auto errors = white(count, 5);
  std::vector<double> s, none(count), beside, measured, variances(count, 1e-12), shifted;
  for (std::size_t k = 0; k < count; ++k) {
    s.push_back(1e-4 * static_cast<double>(k));
    beside.push_back(40 * s.back());
    measured.push_back(1e-6 * errors[k]);
    const double t = s.back();
    shifted.push_back(measured.back() + 5 * t * t + 0.01 * t - 40 * t * t * t / 6);
  }
  const auto plain = distances_with_few_curvature_steps(s, none, measured, variances);
  const auto other = distances_with_few_curvature_steps(s, beside, shifted, variances);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = s[k];
    EXPECT_NEAR(other[k] - (5 * t * t + 0.01 * t - 40 * t * t * t / 6), plain[k], 1e-10) << k;
  }
}

TEST(CurvatureSteps, MakeErrorsSmaller) {
  // Of a straight line with errors a least-squares parabola would have sigma sqrt(3/n) or so.
  const std::size_t count = 400;
  const double sigma = 5 * um;
  auto measured = white(count, 11);
  std::vector<double> s, curvature(count), variances(count, sigma * sigma);
  for (std::size_t k = 0; k < count; ++k) s.push_back(1e-4 * static_cast<double>(k)), measured[k] *= sigma;
  double squares = 0;
  for (const double n : distances_with_few_curvature_steps(s, curvature, measured, variances)) squares += n * n / count;
  EXPECT_LT(std::sqrt(squares), 0.2 * sigma);
}

TEST(CurvatureSteps, HoldPointsWithoutErrors) {
  const std::size_t count = 50;
  auto measured = white(count, 12);
  std::vector<double> s, curvature(count), variances(count, 1e-12);
  for (std::size_t k = 0; k < count; ++k) s.push_back(1e-4 * static_cast<double>(k)), measured[k] *= 1e-6;
  variances.front() = variances.back() = 0;
  const auto found = distances_with_few_curvature_steps(s, curvature, measured, variances);
  EXPECT_EQ(found.front(), measured.front());
  EXPECT_EQ(found.back(), measured.back());
}

TEST(CurvatureSteps, TellErrorsFromSteps) {
  // A line with a few steps and errors twice as large as their variances say; V of a hundred times as much is enough.
  const std::size_t count = 300;
  auto measured = white(count, 13);
  std::vector<double> s, curvature(count), variances(count, 1e-12), larger(count, 1e-10);
  for (std::size_t k = 0; k < count; ++k) {
    s.push_back(1e-3 * static_cast<double>(k));
    const double t = std::max(0.0, s.back() - 0.1), u = std::max(0.0, s.back() - 0.2);
    measured[k] = 2e-6 * measured[k] + 3 * t * t - 5 * u * u;
  }
  EXPECT_NEAR(noise_factor_beside_few_curvature_steps(s, curvature, measured, variances), 4, 1);
  EXPECT_NEAR(noise_factor_beside_few_curvature_steps(s, curvature, measured, larger), 0.04, 0.04);
}

TEST(ProfileNoise, SharedByNeighboursIsSmoothedAsWell) {
  // Errors with a correlation of exp(-distance/0.4 mm).
  const auto clean = two_arcs(3.3, 12.5, 1e-4);
  auto errors = white(clean.size(), 8);
  const double share = std::exp(-1e-4 / 0.4e-3);
  for (std::size_t k = 1; k < errors.size(); ++k)
    errors[k] = share * errors[k - 1] + std::sqrt(1 - share * share) * errors[k];
  const auto points = with_errors(clean, errors, 4 * um);
  const auto found = denoised(points, {}, estimate_noise(points));
  ASSERT_TRUE(found);
  EXPECT_GT(found->long_waves, 1.5 * 4 * um); // sqrt(0.8 mm/0.1 mm) times 4 um are the long waves
  EXPECT_LT(found->long_waves, 4 * 4 * um);
  double largest = 0;
  for (const std::size_t k : found->checked) {
    const auto z = [&](std::size_t i) { return found->points[i].z - clean[i].z; };
    largest = std::max(largest, std::abs(z(k + 30) - 2 * z(k) + z(k - 30)) / (3e-3 * 3e-3));
  }
  EXPECT_LT(largest, 5); // [1/m]
}

TEST(ProfileNoise, SmoothingKeepsJumpsOfCurvature) {
  const double left = 3.3, right = 12.5;
  const auto clean = two_arcs(left, right, 2.5e-4);
  const auto squares = [&](const std::vector<ProfilePoint>& points) {
    const Profile profile(ProfileRole::rail, points);
    double sum = 0;
    for (double y = -0.025; y < 0.025; y += 1e-4)
      sum += std::pow(-curvature_at_y(profile, y) - (y < 0 ? left : right), 2);
    return sum;
  };
  double few_steps = 0, one_wavelength = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    const auto points = with_errors(clean, white(clean.size(), seed), 4 * um);
    const auto noise = estimate_noise(points);
    few_steps += squares(denoised(points, {}, noise)->points);
    one_wavelength += squares(smoothed(points, {}, noise.smoothing_length));
  }
  EXPECT_LT(few_steps, 0.75 * one_wavelength);
}

TEST(ProfileNoise, SmoothingKnowsWhatUncertaintyItLeaves) {
  const double left = 3.3, right = 12.5;
  const auto clean = two_arcs(left, right, 2.5e-4);
  double stated = 0, found = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    const auto points = with_errors(clean, white(clean.size(), seed), 10 * um);
    const auto smooth = denoised(points, {}, estimate_noise(points));
    ASSERT_TRUE(smooth);
    for (const double deviation : smooth->curvature_deviation) stated += deviation * deviation;
    for (const std::size_t k : smooth->checked) { // the parabola through points 3 mm apart
      const auto z = [&](std::size_t i) { return smooth->points[i].z - clean[i].z; };
      const double curvature = (z(k + 12) - 2 * z(k) + z(k - 12)) / (3e-3 * 3e-3);
      found += curvature * curvature;
    }
  }
  EXPECT_LT(found, 2.5 * stated);
  EXPECT_GT(found, stated / 2.5);
}

TEST(ProfileNoise, SmoothingIsTheSameTurnedAndMoved) {
  const auto points = with_errors(two_arcs(3.3, 12.5, 2.5e-4), white(300, 4), 4 * um);
  const double c = std::cos(0.4), s = std::sin(0.4);
  const auto turned = [&](std::vector<ProfilePoint> all) {
    for (auto& p : all) p = {c * p.y - s * p.z + 0.7, s * p.y + c * p.z - 0.1};
    return all;
  };
  const auto wanted = turned(denoised(points, {}, estimate_noise(points))->points);
  const auto other = turned(points);
  const auto found = denoised(other, {}, estimate_noise(other))->points;
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_NEAR(found[k].y, wanted[k].y, 1e-9);
    EXPECT_NEAR(found[k].z, wanted[k].z, 1e-9);
  }
}

TEST(ProfileNoise, SmoothingHoldsKinks) {
  std::vector<ProfilePoint> points;
  for (int k = -200; k <= 200; ++k) points.push_back({2e-4 * k, -2e-4 * std::abs(k)});
  points = with_errors(points, white(points.size(), 6), 0.5 * um);
  const std::vector<std::size_t> kinks = {200};
  const auto found = denoised(points, kinks, estimate_noise(points));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->points[200].y, points[200].y);
  EXPECT_EQ(found->points[200].z, points[200].z);
}

TEST(ProfileNoise, OfTwoPressuresIsByTheirCurvatures) {
  // B of 1/0.6 m and A of 1/0.92 m: a part of the curvature changes the pressure by 2/9 (2 - B/(A + B)) of it.
  DenoisedPoints points{arc(0.3, 0.02, 1e-3), 0, {20}, {0.1}};
  const double a = 1 / 0.92, b = 1 / 0.6;
  EXPECT_NEAR(pressure_deviation(points), 2.0 / 9 * (2 - b / (a + b)) * 0.05 / b, 1e-12);
  points.checked.clear(), points.curvature_deviation.clear();
  EXPECT_EQ(pressure_deviation(points), 0);
}

TEST(ProfilePreparation, SmoothsByNoiseUnlessToldOtherwise) {
  const auto points = with_errors(two_arcs(3.3, 12.5, 2.5e-4), white(300, 4), 4 * um);
  const auto prepared = [&](const ProfileTreatment& treatment) {
    return prepare_profile(ProfileRole::rail, points, treatment);
  };
  const auto by_noise = prepared({}).report, not_at_all = prepared({.smoothing_length = 0}).report;
  EXPECT_TRUE(by_noise.smoothing.by_noise);
  EXPECT_EQ(by_noise.smoothing.length, 0);
  EXPECT_NEAR(by_noise.smoothing.mean_move, 4 * um, 1 * um);
  EXPECT_GT(by_noise.smoothing.pressure_left, 0);
  ASSERT_EQ(by_noise.steps.size(), 1U);
  EXPECT_TRUE(by_noise.steps[0].starts_with("smoothed by their noise of ")) << by_noise.steps[0];
  EXPECT_FALSE(not_at_all.smoothing.by_noise);
  EXPECT_TRUE(not_at_all.steps.empty());
  ASSERT_FALSE(not_at_all.warnings.empty());
  EXPECT_NE(not_at_all.warnings.back().find("leave smoothing_length out"), std::string::npos);
  const auto nominal = io::read_profile(MICROSLIP_SOURCE_DIR "/examples/profiles/60e1.prr").points;
  const auto much = prepare_profile(ProfileRole::rail, with_errors(nominal, white(nominal.size(), 5), 40 * um)).report;
  ASSERT_FALSE(much.warnings.empty());
  EXPECT_NE(much.warnings.back().find("peak pressures on the running surface are uncertain by +-"), std::string::npos);
  const auto by_length = prepared({.smoothing_length = 5e-3});
  EXPECT_EQ(by_length.report.smoothing.length, 5e-3);
  const auto wanted = smoothed(points, {}, 5e-3);
  for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_EQ(by_length.points[k].z, wanted[k].z);
}

TEST(ProfilePreparation, SmoothedPointsAreNotSmoothedAgain) {
  const auto points = with_errors(two_arcs(3.3, 12.5, 2.5e-4), white(300, 4), 4 * um);
  const auto once = prepare_profile(ProfileRole::rail, points);
  const auto twice = prepare_profile(ProfileRole::rail, once.points);
  EXPECT_FALSE(twice.report.smoothing.by_noise);
}

} // namespace
} // namespace microslip
