#include "track.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace {

using SimTK::Vec3;

TrackLine curved_track() {
  return TrackLine(TrackLine::curve(300, 0.1, 50, 60, 100), std::make_shared<Irregularity>(3));
}

TEST(TrackLine, ACircleIsACircle) {
  const TrackLine track({{0, 1.0 / 300, 0}, {700, 1.0 / 300, 0}});
  for (const double s : {1.0, 123.4, 699.0}) {
    const Vec3 p = track.centre(s).pose.p();
    EXPECT_NEAR(p[0], 300 * std::sin(s / 300), 1e-11);
    EXPECT_NEAR(p[1], 300 * (1 - std::cos(s / 300)), 1e-11);
  }
}

/// The end of a clothoid of curvature s/A^2 by Fresnel's integrals, from their series.
TEST(TrackLine, ATransitionIsAClothoid) {
  const double length = 60, radius = 300;
  const TrackLine track(TrackLine::curve(radius, 0, 0.5, length, 10));
  double x = 0, y = 0;
  const double turn = length / (2 * radius);
  double term = 1;
  for (int n = 0; n < 12; ++n) {
    (n % 2 == 0 ? x : y) += (n % 4 < 2 ? 1 : -1) * term * length / (2 * n + 1);
    term *= turn / (n + 1);
  }
  const Vec3 p = track.centre(length + 0.5).pose.p();
  EXPECT_NEAR(p[0], x + 0.5, 1e-10);
  EXPECT_NEAR(p[1], y, 1e-10);
}

TEST(TrackLine, ThePointNearestToAPointOfTheFrameIsItsOrigin) {
  const TrackLine track = curved_track();
  for (const double s : {20.0, 80.0, 150.0, 230.0}) {
    const auto frame = track.centre(s);
    EXPECT_NEAR(track.nearest(frame.pose * Vec3(0, 0.7, 0), s + 3), s, 1e-9);
  }
}

/// Pose of the frame by differences beside what it says of its turning.
TEST(TrackLine, ARailsFrameTurnsAsItSays) {
  const TrackLine track = curved_track();
  constexpr double step = 1e-4;
  for (const bool left : {true, false})
    for (const double s : {75.0, 97.3, 160.0}) {
      const auto before = track.rail(s - step, left), here = track.rail(s, left), after = track.rail(s + step, left);
      const SimTK::Mat33 change = (~before.pose.R() * after.pose.R()).asMat33();
      const Vec3 turned(change(2, 1) - change(1, 2), change(0, 2) - change(2, 0), change(1, 0) - change(0, 1));
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(turned[k] / (4 * step), here.turning[k], 2e-5) << s << " " << k;
    }
}

TEST(Irregularity, HasTheVarianceOfItsSpectrum) {
  const Irregularity irregularity(5);
  const auto variance = [](double amplitude) {
    double sum = 0;
    const double step = 2 * SimTK::Pi / 2000;
    for (int k = 20; k <= 666; ++k) {
      const double w = k * step;
      sum += amplitude * 0.8246 * 0.8246 / ((w * w + 0.0206 * 0.0206) * (w * w + 0.8246 * 0.8246)) * step;
    }
    return sum;
  };
  double lateral = 0, level = 0;
  constexpr int count = 20000;
  for (int k = 0; k < count; ++k) {
    const double s = 2000 + 0.1 * k;
    const auto left = irregularity.left(s), right = irregularity.right(s);
    lateral += left.lateral.value * left.lateral.value / count;
    level += std::pow((left.vertical.value + right.vertical.value) / 2, 2) / count;
  }
  EXPECT_NEAR(lateral / variance(2.119e-7), 1, 1e-6);
  EXPECT_NEAR(level / variance(4.032e-7), 1, 1e-6);
}

TEST(Irregularity, ItsDerivativesAreThoseOfItsValues) {
  const Irregularity irregularity(5);
  constexpr double step = 1e-3;
  for (const double s : {35.0, 47.2, 813.4}) {
    const auto before = irregularity.left(s - step), here = irregularity.left(s), after = irregularity.left(s + step);
    EXPECT_NEAR((after.vertical.value - before.vertical.value) / (2 * step), here.vertical.slope, 1e-8);
    EXPECT_NEAR((after.lateral.slope - before.lateral.slope) / (2 * step), here.lateral.bend, 1e-6);
  }
}

} // namespace
