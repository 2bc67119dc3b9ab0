#include "microslip/railway/profile/profile.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace microslip {
namespace {

std::vector<ProfilePoint> arc(int n, double radius) {
  std::vector<ProfilePoint> points;
  for (int k = 0; k <= n; ++k) {
    const double angle = -1.2 + 2.4 * k / n;
    points.push_back({radius * std::sin(angle), radius * std::cos(angle)});
  }
  return points;
}

/// The largest distance of the middle third of the spline from the circle that its points lie on.
double circle_error(int n, double radius) {
  const Profile profile(ProfileRole::rail, arc(n, radius));
  double worst = 0;
  for (int k = 0; k <= 1000; ++k) {
    const ProfilePoint p = profile.at(profile.length() * (1 + k / 1000.0) / 3).value;
    worst = std::max(worst, std::abs(std::hypot(p.y, p.z) - radius));
  }
  return worst;
}

TEST(Profile, FollowsACircleWithFourthOrder) {
  EXPECT_NEAR(std::log2(circle_error(32, 0.3) / circle_error(64, 0.3)), 4, 0.2);
}

TEST(Profile, PassesThroughItsPointsWithContinuousDerivatives) {
  const auto points = arc(20, 0.013);
  const Profile profile(ProfileRole::wheel, points);
  ASSERT_EQ(profile.pieces().size(), 20u);
  for (std::size_t k = 0; k + 1 < profile.pieces().size(); ++k) {
    const ProfilePiece &piece = profile.pieces()[k], &next = profile.pieces()[k + 1];
    const CurvePoint before = piece.at(next.start), after = next.at(next.start);
    EXPECT_NEAR(after.value.y, points[k + 1].y, 1e-17);
    EXPECT_NEAR(before.value.z, after.value.z, 1e-16);
    EXPECT_NEAR(before.first.y, after.first.y, 1e-13);
    EXPECT_NEAR(before.second.z, after.second.z, 1e-10);
  }
  EXPECT_NEAR(profile.at(0).second.y, 0, 1e-12);
  EXPECT_NEAR(profile.at(profile.length()).second.z, 0, 1e-10);
}

TEST(Profile, IsStraightOnBothSidesOfAKinkAndBeyondItsEnds) {
  const std::vector<ProfilePoint> points = {{-0.03, 0.02}, {-0.02, 0.01}, {-0.01, 0}, {0, 0}, {0.02, 0}};
  const Profile profile(ProfileRole::rail, points, std::vector<std::size_t>{2});
  ASSERT_EQ(profile.kinks().size(), 1u);
  const double kink = profile.pieces()[profile.kinks()[0]].start;
  EXPECT_NEAR(profile.at(kink - 1e-3).value.z, 1e-3 / std::sqrt(2), 1e-15);
  EXPECT_NEAR(profile.at(kink + 1e-3).value.z, 0, 1e-15);
  EXPECT_NEAR(profile.at(-std::sqrt(2)).value.y, -1.03, 1e-12);
  EXPECT_NEAR(profile.at(profile.length() + 1).value.y, 1.02, 1e-12);
}

std::string message_of(const std::vector<ProfilePoint>& points, const std::vector<std::size_t>& kinks = {}) {
  return error_of([&] { Profile(ProfileRole::rail, points, kinks); });
}

TEST(Profile, RefusesPointsThatMakeNoCurve) {
  EXPECT_EQ(message_of({{0, 0}}), "profile: 1 points: must be at least 2");
  EXPECT_EQ(message_of({{0, 0}, {0, 0}, {1, 0}}), "profile: points 1 and 2 are equal");
  EXPECT_EQ(message_of({{0, 0}, {1, nan}}).find("profile: z of point 2 = nan [m]"), 0u);
  EXPECT_EQ(message_of(arc(3, 1), {3}), "profile: kinks must be inner points in ascending order");
  EXPECT_EQ(message_of(arc(3, 1)), "no error");
}

} // namespace
} // namespace microslip
