#include "microslip/railway/profile/profile_preparation.hpp"

#include "microslip/railway/profile/profile_dimensions.hpp"
#include "tests/support/expect_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace microslip {
namespace {

/// A rail's head: an arc of 40 mm radius on the upper half of a circle.
std::vector<ProfilePoint> head(int n = 200) {
  std::vector<ProfilePoint> points;
  for (int k = 0; k <= n; ++k) {
    const double angle = -1.3 + 2.6 * k / n;
    points.push_back({0.04 * std::sin(angle), 0.04 * std::cos(angle) - 0.04});
  }
  return points;
}

/// A tread of 1:40 from y = -30 mm to 60 mm, and a flange of 28 mm as half an ellipse with its tip at y = -50 mm.
std::vector<ProfilePoint> wheel() {
  std::vector<ProfilePoint> points;
  for (int k = 0; k <= 200; ++k) {
    const double angle = std::numbers::pi * k / 200;
    points.push_back({-0.05 - 0.02 * std::cos(angle), -7.5e-4 - 0.028 * std::sin(angle)});
  }
  for (int k = 1; k <= 180; ++k) points.push_back({-0.03 + 5e-4 * k, (-0.03 + 5e-4 * k) / 40});
  return points;
}

std::string message_of(const std::vector<ProfilePoint>& points, const ProfileTreatment& treatment = {}) {
  return error_of([&] { prepare_profile(ProfileRole::rail, points, treatment); });
}

bool is_named(const std::vector<std::string>& texts, const std::string& part) {
  return std::any_of(texts.begin(), texts.end(), [&](const auto& t) { return t.find(part) != t.npos; });
}

TEST(ProfilePreparation, LeavesACleanProfileAlone) {
  const auto rail = prepare_profile(ProfileRole::rail, head());
  EXPECT_TRUE(rail.report.steps.empty());
  EXPECT_TRUE(rail.report.warnings.empty());
  EXPECT_TRUE(rail.report.kinks.empty());
  EXPECT_EQ(rail.report.points_read, 201u);
  EXPECT_EQ(rail.report.points, 201u);
  EXPECT_TRUE(prepare_profile(ProfileRole::wheel, wheel()).report.warnings.empty());
}

TEST(ProfilePreparation, TurnsAndSortsPointsAndDropsDuplicates) {
  const auto clean = prepare_profile(ProfileRole::rail, head()).profile;
  const auto expect_same = [&](std::vector<ProfilePoint> points, const std::string& step) {
    const auto prepared = prepare_profile(ProfileRole::rail, std::move(points));
    EXPECT_TRUE(is_named(prepared.report.steps, step)) << step;
    ASSERT_EQ(prepared.profile.pieces().size(), clean.pieces().size()) << step;
    for (std::size_t k = 0; k < clean.pieces().size(); ++k)
      EXPECT_NEAR(prepared.profile.pieces()[k].start, clean.pieces()[k].start, 1e-12) << step;
  };
  auto points = head();
  std::reverse(points.begin(), points.end());
  expect_same(points, "turned round");
  std::shuffle(points.begin(), points.end(), std::mt19937(3));
  expect_same(points, "sorted by y");
  points = head();
  for (const std::size_t k : {150, 150, 7}) points.insert(points.begin() + static_cast<std::ptrdiff_t>(k), points[k]);
  expect_same(points, "dropped 3 points");
}

TEST(ProfilePreparation, StraightensZigZags) {
  auto points = head();
  std::swap(points[80], points[81]); // a step back
  const auto prepared = prepare_profile(ProfileRole::rail, points);
  EXPECT_TRUE(is_named(prepared.report.steps, "straightened 1 zig-zag"));
  EXPECT_EQ(prepared.report.points, points.size() - 1);
}

TEST(ProfilePreparation, KeepsAnOverhangWhenEndsAreTrimmed) {
  auto points = head();
  points.insert(points.begin(), {{-0.030, -0.05}, {-0.034, -0.04}}); // the web, below the head
  const auto prepared = prepare_profile(ProfileRole::rail, points, {.y_min = -0.035, .y_max = 0.02});
  EXPECT_TRUE(is_named(prepared.report.steps, "at the ends"));
  EXPECT_EQ(prepared.profile.at(0).value.y, -0.030);
  EXPECT_LE(prepared.profile.at(prepared.profile.length()).value.y, 0.02);
  EXPECT_LT(gauge_point(prepared.profile, 0.03).point.y, -0.035); // the head's widest point is still there
  EXPECT_NE(message_of(points, {.y_min = 0.1}).find("no point has y within"), std::string::npos);
}

TEST(ProfilePreparation, NamesWhatLooksWrong) {
  const auto warnings = [](ProfileRole role, std::vector<ProfilePoint> points) {
    return prepare_profile(role, std::move(points)).report.warnings;
  };
  const auto changed = [](std::vector<ProfilePoint> points, double y, double z) {
    for (auto& p : points) p = {y * p.y, z * p.z};
    return points;
  };
  EXPECT_TRUE(is_named(warnings(ProfileRole::rail, changed(head(), 1, -1)), "is z mirrored"));
  EXPECT_TRUE(is_named(warnings(ProfileRole::wheel, changed(wheel(), 1, -1)), "is z mirrored"));
  EXPECT_TRUE(is_named(warnings(ProfileRole::wheel, changed(wheel(), -1, 1)), "is y mirrored"));
  EXPECT_TRUE(is_named(warnings(ProfileRole::wheel, head()), "is this a rail"));
  EXPECT_TRUE(is_named(warnings(ProfileRole::rail, wheel()), "is this a wheel"));
  EXPECT_TRUE(is_named(warnings(ProfileRole::rail, changed(head(), 0.2, 0.2)), "wide"));
  auto points = head();
  points.erase(points.begin() + 60, points.begin() + 90);
  EXPECT_TRUE(is_named(warnings(ProfileRole::rail, points), "a gap of 1"));
  points = head();
  points.resize(120); // the field side is missing
  for (auto& p : points) p.y = -p.y;
  EXPECT_TRUE(is_named(warnings(ProfileRole::rail, points), "the field side reaches further down"));
  std::mt19937 random(1);
  std::normal_distribution<double> error(0, 5e-6);
  points = head(400);
  for (auto& p : points) p.z += error(random);
  const auto rough = prepare_profile(ProfileRole::rail, points, {.smoothing_length = 0});
  EXPECT_TRUE(is_named(rough.report.warnings, "peak pressures mean nothing"));
  EXPECT_TRUE(warnings(ProfileRole::rail, points).empty());
}

TEST(ProfilePreparation, RefusesWhatIsNoProfile) {
  EXPECT_EQ(message_of({{0, 0}}), "profile: 1 point: a profile needs at least 4");
  EXPECT_NE(message_of(std::vector<ProfilePoint>(10)).find("1 point left"), std::string::npos);
  auto points = head();
  points[3].z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of(points).find("z of point 4 = nan [m]: must be finite"), std::string::npos);
  points[3] = {std::numeric_limits<double>::infinity(), 0};
  EXPECT_NE(message_of(points).find("y of point 4 = inf"), std::string::npos);
  points = head();
  for (auto& p : points) p = {1e3 * p.y, 1e3 * p.z};
  EXPECT_NE(message_of(points).find("is the unit of length right?"), std::string::npos);
  for (auto& p : points) p = {1e-6 * p.y, 1e-6 * p.z};
  EXPECT_NE(message_of(points).find("is the unit of length right?"), std::string::npos);
  points = head(40);
  points.insert(points.begin() + 20, {{0.01, 0.001}, {0.01, -0.02}, {-0.01, -0.02}, {-0.01, 0.001}});
  EXPECT_NE(message_of(points).find("crosses itself"), std::string::npos);
  EXPECT_NE(message_of(std::vector<ProfilePoint>(20001)).find("20001 points"), std::string::npos);
}

TEST(ProfilePreparation, TellsAxesByTheShape) {
  const auto sense = [](ProfileRole role, const std::vector<ProfilePoint>& points, double y, double z) {
    auto changed = points;
    for (auto& p : changed) p = {y * p.y, z * p.z};
    return sense_of_shape(role, changed);
  };
  for (const int z : {1, -1}) {
    EXPECT_EQ(sense(ProfileRole::rail, head(), 1, z).z, z);
    EXPECT_EQ(sense(ProfileRole::rail, head(), 1, z).y, 0);
    for (const int y : {1, -1}) {
      EXPECT_EQ(sense(ProfileRole::wheel, wheel(), y, z).z, z);
      EXPECT_EQ(sense(ProfileRole::wheel, wheel(), y, z).y, y);
    }
  }
  const std::vector<ProfilePoint> flat = {{-0.05, 0}, {-0.02, 0}, {0.02, 0}, {0.05, 0}};
  EXPECT_EQ(sense_of_shape(ProfileRole::rail, flat).z, 0);
  EXPECT_EQ(sense_of_shape(ProfileRole::wheel, flat).z, 0);
}

TEST(ProfileKinks, AreCornersAndNotArcs) {
  // Two straight flanks that meet at 90 degrees, and an arc of 1 mm radius sampled so that it turns 20 degrees a step.
  std::vector<ProfilePoint> points;
  for (int k = -40; k <= 40; ++k) points.push_back({5e-4 * k, -5e-4 * std::abs(k)});
  const auto corner = find_kinks(points);
  ASSERT_EQ(corner.size(), 1u);
  EXPECT_EQ(corner[0], 40u);
  EXPECT_NEAR(turn_at(points, 40), -std::numbers::pi / 2, 1e-12);
  std::vector<ProfilePoint> arc;
  for (int k = 0; k <= 5; ++k) {
    const double angle = 0.7 * k;
    arc.push_back({-1e-3 * std::cos(angle), 1e-3 * std::sin(angle)});
  }
  EXPECT_TRUE(find_kinks(arc).empty());
  EXPECT_EQ(find_kinks(arc, {.angle = 0.1, .around = 3, .width = 1e-6}).size(), 4u);
}

/// Points count that are nearer than the width, whatever the polygon's length up to them.
TEST(ProfileKinks, AreFarFromOtherTurns) {
  const auto along = [](const ProfilePoint& from, double length, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return ProfilePoint{from.y + length * std::cos(angle), from.z + length * std::sin(angle)};
  };
  std::vector<ProfilePoint> points = {{0, 0}, {5e-3, 0}}; // then a kink, and 2.001 mm of polygon up to the next turn
  points.push_back(along(points.back(), 1e-3, 40));
  points.push_back(along(points.back(), 1.001e-3, 45.5));
  points.push_back(along(points.back(), 5e-3, 55.5));
  EXPECT_TRUE(find_kinks(points).empty());
  EXPECT_EQ(find_kinks(points, {.width = 1.998e-3}).size(), 1u);
}

TEST(ProfilePreparation, CutsTheSplineAtKinks) {
  std::vector<ProfilePoint> points;
  for (int k = -40; k <= 40; ++k) points.push_back({1e-3 * k, -1e-3 * std::abs(k)});
  const auto prepared = prepare_profile(ProfileRole::rail, points);
  ASSERT_EQ(prepared.report.kinks.size(), 1u);
  EXPECT_NEAR(prepared.report.kinks[0].s, prepared.profile.length() / 2, 1e-12);
  EXPECT_NEAR(prepared.report.kinks[0].angle, -std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(prepared.profile.at(prepared.profile.length() * 0.49).second.z, 0, 1e-9);
}

} // namespace
} // namespace microslip
