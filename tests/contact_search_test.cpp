#include "microslip/railway/geometry/contact_search.hpp"

#include "microslip/railway/geometry/wheel_locus.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

#include <gtest/gtest.h>

#include <random>

namespace microslip {
namespace {

using Point = Vec3<double>;

/// A wheel and a rail in separate frames: the wheel's origin, roll and yaw, the rail's origin and cant.
WheelPlacement<double> placed(double radius, Point wheel, double roll, double yaw, Point rail = {}, double cant = 0) {
  WheelPlacement<double> p;
  p.radius = radius;
  p.wheel.frame = {wheel, rotation_about_x(roll) * rotation_about_z(yaw)};
  p.rail.frame = {rail, rotation_about_x(cant)};
  return p;
}

TEST(ContactSearch, SphereOnCylinder) {
  const double sphere = 0.3, head = 0.1;
  ContactSearch search(round_head(head), spherical_wheel(sphere));
  for (const double yaw : {0.0, 0.02, -0.3})
    for (const double roll : {0.0, -0.05})
      for (const double y : {-0.008, 0.0, 0.012})
        for (const double cant : {0.0, 0.025}) {
          const Point centre{0.01, y, 0.4};
          const auto points = search.find(placed(sphere, centre, roll, yaw, {0, 0.002, 0.1}, cant), 1e-3);
          ASSERT_EQ(points.size(), 1U);
          const ContactPoint& point = points[0];
          // the centres of both circles decide
          const double cy = 0.002 + head * std::sin(cant), cz = 0.1 - head * std::cos(cant);
          const double delta = std::asin((cy - y) / (sphere + head));
          EXPECT_NEAR(point.inclination, delta, 1e-9);
          EXPECT_NEAR(point.gap, centre.z - cz - (sphere + head) * std::cos(delta), 1e-11);
          EXPECT_NEAR(point.place.x, centre.x, 1e-9);
          EXPECT_NEAR(point.place.y, y + sphere * std::sin(delta), 1e-9);
          EXPECT_NEAR(point.place.z, centre.z - sphere * std::cos(delta), 1e-11);
          EXPECT_NEAR(point.curvature, 1 / sphere + 1 / head, 1e-5);
          EXPECT_TRUE(point.minimum);
        }
}

TEST(ContactSearch, ConeOnCircularRailUnderYaw) {
  const double head = 0.08, radius = 0.46, inclination = 0.3;
  const Profile cone(ProfileRole::wheel,
                     std::vector<ProfilePoint>{{-0.06, -0.06 * inclination}, {0.06, 0.06 * inclination}});
  ContactSearch search(round_head(head, 0.06), cone);
  for (const double yaw : {0.0, 0.01, -0.05})
    for (const double roll : {0.0, 0.02}) {
      const auto placement = placed(radius, {0, 0.004, 0.5}, roll, yaw);
      const auto points = search.find(placement, 1e-3);
      ASSERT_EQ(points.size(), 1U);
      // tau from the normal's component along the track, with the elements of the rotation R
      const auto& [ex, ey, ez] = placement.wheel.frame.axes;
      const double tau = std::asin(-ey.x * inclination / std::hypot(ex.x, ez.x)) + std::atan2(ez.x, ex.x);
      EXPECT_NEAR(points[0].tau, tau, 1e-12);
      // the normal n = (cos a sin tau, sin a, -cos a cos tau) turned into the track is (0, sin delta, -cos delta)
      const double a = std::atan(inclination);
      const Point normal =
          placement.wheel.frame.axes * Point{std::cos(a) * std::sin(tau), std::sin(a), -std::cos(a) * std::cos(tau)};
      EXPECT_NEAR(normal.x, 0, 1e-15);
      const double delta = std::atan2(normal.y, -normal.z), y_rail = -head * std::sin(delta);
      EXPECT_NEAR(points[0].inclination, delta, 1e-9);
      EXPECT_NEAR(points[0].place.y, y_rail, 1e-9);
      // along the cone's line at tau y is linear in the profile's y
      const auto line = [&](double y) { return placement.wheel_point(tau, y, inclination * y); };
      const double along = (y_rail - line(0).y) / (line(1).y - line(0).y);
      EXPECT_NEAR(points[0].radius, radius - inclination * along, 1e-9);
      EXPECT_NEAR(points[0].gap, line(along).z - (head * std::cos(delta) - head), 1e-9);
    }
}

/// Waves with kinks here and there.
Profile wavy(ProfileRole role, std::mt19937& random, double roughness) {
  std::uniform_real_distribution<double> any(-1, 1);
  const double sense = role == ProfileRole::rail ? -1 : 1;
  const double a = any(random), b = any(random), c = any(random);
  std::vector<ProfilePoint> points;
  std::vector<std::size_t> kinks;
  for (int k = 0; k <= 120; ++k) {
    const double y = -0.03 + 0.06 * k / 120;
    const double kink = k > 40 ? 0.05 * std::abs(a) * (y + 0.01) : 0;
    points.push_back(
        {y, sense * (4 * y * y + 3e-4 * (a * std::sin(300 * y + 3 * b) + b * std::sin(700 * y + c)) + kink) +
                roughness * any(random)});
  }
  kinks.push_back(40);
  return Profile(role, points, kinks);
}

/// Local minima of the smallest gap of each circle of the wheel over a table of the rail's heights, as (0, y, gap),
/// down to the limit above the smallest one: no use is made of tangents.
std::vector<Point> dense_minima(const Profile& rail, const Profile& wheel, const WheelPlacement<double>& p,
                                double limit) {
  const double y0 = -0.029, step = 2e-6;
  std::vector<double> heights;
  Point before = p.rail_point(0, rail.at(0).value.y, rail.at(0).value.z);
  for (double s = 0; heights.size() < 29000; s += 1e-6) {
    const ProfilePoint r = rail.at(s).value;
    const Point next = p.rail_point(0, r.y, r.z);
    for (double y; (y = y0 + step * static_cast<double>(heights.size())) <= next.y;)
      heights.push_back(before.z + (next.z - before.z) * (y - before.y) / (next.y - before.y));
    before = next;
  }
  const auto gap = [&](const Point& q) {
    const double t = (q.y - y0) / step;
    const auto k = static_cast<std::size_t>(t);
    if (t < 0 || k + 1 >= heights.size()) return 1.0;
    return q.z - heights[k] - (heights[k + 1] - heights[k]) * (t - static_cast<double>(k));
  };
  std::vector<Point> circles;
  const int n = 12000;
  for (int k = 0; k <= n; ++k) {
    const CurvePoint c = wheel.at(wheel.length() * k / n);
    double centre = 0, best = 0, reach = 0.05;
    Point least{0, 0, 1};
    for (int round = 0; round < 7; ++round, reach /= 4, centre = best)
      for (int i = -5; i <= 5; ++i) {
        const double tau = centre + reach * i / 5;
        const Point q = p.wheel_point(tau, c.value.y, c.value.z);
        if (const double g = gap(q); g < least.z) least = {0, q.y, g}, best = tau;
      }
    circles.push_back(least);
  }
  double smallest = 1;
  for (const Point& c : circles) smallest = std::min(smallest, c.z);
  std::vector<Point> found;
  for (int k = 60; k + 60 <= n; ++k) {
    bool least = circles[k].z <= smallest + limit;
    for (int i = -60; least && i <= 60; ++i) least = circles[k].z <= circles[k + i].z;
    if (least && (found.empty() || circles[k].y > found.back().y + 1e-4)) found.push_back(circles[k]);
  }
  return found;
}

TEST(ContactSearch, MissesNoMinimumOfRandomPairs) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1, 1);
  int several = 0;
  for (int k = 0; k < 12; ++k) {
    SCOPED_TRACE(k);
    const Profile rail = wavy(ProfileRole::rail, random, 0), wheel = wavy(ProfileRole::wheel, random, 0);
    ContactSearch search(rail, wheel);
    const auto placement =
        placed(0.46, {0, 0.003 * any(random), 0.47}, 0.02 * any(random), 0.06 * any(random), {}, 0.03 * any(random));
    const double limit = 2e-3;
    const auto expected = dense_minima(rail, wheel, placement, limit);
    const auto points = search.find(placement, limit);
    several += expected.size() > 1;
    for (const Point& e : expected) {
      const auto same = std::find_if(points.begin(), points.end(), [&](const ContactPoint& p) {
        return p.minimum && std::abs(p.place.y - e.y) < 2e-5 && std::abs(p.gap - e.z) < 2e-7;
      });
      EXPECT_NE(same, points.end()) << "minimum at y = " << e.y << ", gap " << e.z;
    }
    // between two minima that follow one another lies a maximum, if it is below the limit
    for (std::size_t i = 0; i + 1 < points.size(); ++i) EXPECT_LT(points[i].place.y, points[i + 1].place.y);
  }
  EXPECT_GT(several, 6);
}

TEST(ContactSearch, StatesNearTheLastOnesHaveThePointsOfASearchAnew) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  std::size_t several = 0;
  for (int pair = 0; pair < 12; ++pair) {
    const Profile rail = wavy(ProfileRole::rail, random, 0), wheel = wavy(ProfileRole::wheel, random, 0);
    ContactSearch search(rail, wheel);
    const ContactSearch unused(rail, wheel);
    Point centre{0, 0.003 * any(random), 0.47};
    double roll = 0.02 * any(random), yaw = pair == 0 ? 0 : 0.06 * any(random);
    for (int step = 0; step < 80; ++step) {
      SCOPED_TRACE(step);
      const double move = step % 20 == 19 ? 10 : step % 5 == 4 ? 1 : 0.2; // far, about as far as counts as near, near
      centre = centre + Point{0, 3e-4 * move * any(random), 1e-4 * move * any(random)};
      roll += 1e-4 * move * any(random), yaw += 1e-4 * move * any(random);
      const auto placement = placed(0.46, centre, roll, yaw, {}, pair % 2 == 0 ? 0.025 : 0);
      const double limit = step % 2 == 0 ? 2e-3 : 3e-4;
      const auto points = search.find(placement, limit);
      ContactSearch anew = unused;
      const auto expected = anew.find(placement, limit);
      ASSERT_EQ(points.size(), expected.size());
      several += expected.size() > 1;
      for (std::size_t k = 0; k < points.size(); ++k) {
        EXPECT_EQ(points[k].gap, expected[k].gap);
        EXPECT_EQ(points[k].wheel_arc, expected[k].wheel_arc);
        EXPECT_EQ(points[k].s_rail, expected[k].s_rail);
      }
    }
  }
  EXPECT_GT(several, 100U);
}

TEST(ContactSearch, EveryPlaceIsStationaryOnTheWheelsSurface) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  int found = 0;
  for (int k = 0; k < 200; ++k) {
    const Profile rail = wavy(ProfileRole::rail, random, 1e-6), wheel = wavy(ProfileRole::wheel, random, 1e-6);
    ContactSearch search(rail, wheel);
    const auto p = placed(0.46, {0, 0.005 * any(random), 0.47}, 0.03 * any(random), 0.06 * any(random));
    const auto points = search.find(p, 5e-4);
    for (const ContactPoint& point : points) {
      if (point.wheel_corner != Corner::none || point.rail_corner != Corner::none) continue;
      ++found;
      const CurvePoint w = wheel.at(point.s_wheel), r = rail.at(point.s_rail);
      const Point on_wheel = p.wheel_point(point.tau, w.value.y, w.value.z),
                  on_rail = p.rail_point(0, r.value.y, r.value.z);
      EXPECT_NEAR(on_wheel.y, on_rail.y, 1e-13);
      EXPECT_NEAR(on_wheel.z - on_rail.z, point.gap, 1e-13);
      EXPECT_NEAR(on_wheel.x, point.place.x, 1e-13);
      // the rail's normal is perpendicular to both tangents of the wheel
      const Point normal = p.rail.frame.axes * Point{0, -r.first.z, r.first.y};
      const double rho = p.radius - w.value.z, s = std::sin(point.tau), c = std::cos(point.tau);
      const Point around = p.wheel.frame.axes * Point{rho * c, 0, rho * s};
      const Point along = p.wheel.frame.axes * Point{-w.first.z * s, w.first.y, w.first.z * c};
      EXPECT_NEAR(dot(normal, around), 0, 1e-10);
      EXPECT_NEAR(dot(normal, along), 0, 1e-10);
    }
  }
  EXPECT_GT(found, 200);
}

TEST(ContactSearch, ARigidMotionOfAllAndTheOriginsOfProfilesDoNotMatter) {
  std::mt19937 random(8);
  const Profile rail = wavy(ProfileRole::rail, random, 0), wheel = wavy(ProfileRole::wheel, random, 0);
  ContactSearch search(rail, wheel);
  const auto base = placed(0.46, {0, 0.002, 0.47}, 0.01, 0.02, {0, 0.001, 0});
  const auto points = search.find(base, 1e-3);
  const std::vector<ContactPoint> expected(points.begin(), points.end());
  ASSERT_GE(expected.size(), 2U);
  const auto compare = [&](std::span<const ContactPoint> found, double turn) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_NEAR(found[k].s_wheel, expected[k].s_wheel, 1e-12);
      EXPECT_NEAR(found[k].s_rail, expected[k].s_rail, 1e-12);
      EXPECT_NEAR(found[k].gap, expected[k].gap, 1e-12);
      EXPECT_NEAR(found[k].inclination - turn, expected[k].inclination, 1e-12);
      EXPECT_NEAR(found[k].tau, expected[k].tau, 1e-12);
    }
  };
  for (const double turn : {0.1, -1.3, 1.5}) {
    auto turned = base;
    const Frame<double> motion{{0, 0.03, -0.02}, rotation_about_x(turn)};
    turned.rail.frame = motion * base.rail.frame;
    turned.wheel.frame = motion * base.wheel.frame;
    compare(search.find(turned, 1e-3, turn), turn);
  }
  // profiles given in other axes, placed where they were
  const auto moved = [](const Profile& profile, ProfilePoint by) {
    std::vector<ProfilePoint> shifted;
    for (const ProfilePiece& piece : profile.pieces()) shifted.push_back({piece.c[0].y + by.y, piece.c[0].z + by.z});
    const ProfilePoint last = profile.at(profile.length()).value;
    shifted.push_back({last.y + by.y, last.z + by.z});
    return Profile(profile.role(), shifted, profile.kinks());
  };
  ContactSearch elsewhere(moved(rail, {0.2, -0.1}), moved(wheel, {-0.1, 0.03}));
  auto placement = base;
  placement.rail.frame.origin = base.rail.frame.outer({0, -0.2, 0.1});
  placement.wheel.frame.origin = base.wheel.frame.outer({0, 0.1, 0});
  placement.radius = base.radius + 0.03;
  compare(elsewhere.find(placement, 1e-3), 0);
}

TEST(ContactSearch, ARoofTouchesAtItsRidge) {
  const std::vector<ProfilePoint> roof{{-0.03, -0.003}, {0, 0}, {0.03, -0.006}};
  const std::size_t ridge[] = {1};
  ContactSearch search(Profile(ProfileRole::rail, roof, ridge), spherical_wheel(0.4));
  const auto points = search.find(placed(0.4, {0, 0.01, 0.5}, 0, 0.1), 1e-4);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].rail_corner, Corner::kink);
  EXPECT_NEAR(points[0].place.y, 0, 1e-14);
  EXPECT_NEAR(points[0].inclination, std::asin(-0.01 / 0.4), 1e-9);
}

TEST(ContactSearch, AWheelsEdgeTouchesWithTheRailsInclination) {
  const std::vector<ProfilePoint> edge{{-0.03, 0.006}, {0, 0}, {0.03, 0.006}};
  const std::size_t tip[] = {1};
  const double head = 0.3, yaw = 0.05;
  ContactSearch search(round_head(head), Profile(ProfileRole::wheel, edge, tip));
  for (const double roll : {0.0, 0.02}) {
    const auto placement = placed(0.4, {0, 0.001, 0.5}, roll, yaw);
    const auto points = search.find(placement, 1e-4);
    ASSERT_EQ(points.size(), 1U);
    EXPECT_EQ(points[0].wheel_corner, Corner::kink);
    EXPECT_NEAR(points[0].radius, 0.4, 1e-15);
    EXPECT_NEAR(points[0].inclination, std::asin(-points[0].place.y / head), 1e-9);
    // a circle in space: its tangent lies in the rail's tangent plane
    const double delta = points[0].inclination;
    const Point tangent = placement.wheel.frame.axes * Point{std::cos(points[0].tau), 0, std::sin(points[0].tau)};
    EXPECT_NEAR(dot(tangent, {0, -std::sin(delta), std::cos(delta)}), 0, 1e-9);
  }
}

TEST(ContactSearch, AtTheEndOfAProfileThePlaceSaysSo) {
  ContactSearch search(round_head(0.3, 0.02), spherical_wheel(0.4));
  const auto beyond_rail = search.find(placed(0.4, {0, 0.05, 0.5}, 0, 0), 1e-4);
  ASSERT_EQ(beyond_rail.size(), 1U);
  EXPECT_EQ(beyond_rail[0].rail_corner, Corner::end);
  EXPECT_NEAR(beyond_rail[0].place.y, 0.02, 1e-14);
  const std::vector<ProfilePoint> slope{{-0.01, 0.001}, {0.01, -0.001}};
  ContactSearch narrow(round_head(0.3, 0.03), Profile(ProfileRole::wheel, slope));
  const auto beyond_wheel = narrow.find(placed(0.4, {0, -0.005, 0.5}, 0, 0), 1e-4);
  ASSERT_EQ(beyond_wheel.size(), 1U);
  EXPECT_EQ(beyond_wheel[0].wheel_corner, Corner::end);
  EXPECT_NEAR(beyond_wheel[0].place.y, 0.005, 1e-14);
  EXPECT_TRUE(search.find(placed(0.4, {0, 1.0, 0.5}, 0, 0), 1e-4).empty());
}

TEST(ContactSearch, ParallelSurfacesCountAsOnePlaceInTheirMidst) {
  const std::vector<ProfilePoint> flat{{-0.03, 0}, {0.03, 0}}, narrow{{-0.02, 0}, {0.01, 0}};
  ContactSearch search(Profile(ProfileRole::rail, flat), Profile(ProfileRole::wheel, narrow));
  const auto points = search.find(placed(0.4, {0, 0, 0.5}, 0, 0), 1e-4);
  ASSERT_GE(points.size(), 1U);
  const auto middle =
      std::find_if(points.begin(), points.end(), [](auto& p) { return p.wheel_corner == Corner::none; });
  ASSERT_NE(middle, points.end());
  EXPECT_NEAR(middle->place.y, -0.005, 1e-12);
  for (const ContactPoint& p : points) EXPECT_NEAR(p.gap, 0.1, 1e-15);
}

TEST(ContactSearch, SteepFlanksAreSeenFromTheSide) {
  // a guard rail's vertical face against the back of a flange: seen from above they never come near one another
  const double rounding = 0.01;
  std::vector<ProfilePoint> back, face;
  for (int k = 0; k <= 200; ++k) {
    const double angle = -1.6 + 1.6 * k / 200;
    back.push_back({rounding * std::sin(angle), rounding * (1 - std::cos(angle))});
  }
  for (int k = 0; k <= 200; ++k) {
    const double angle = 1.6 * k / 200;
    face.push_back({0.013 * (std::sin(angle) - 1), 0.013 * (std::cos(angle) - 1)});
  }
  ContactSearch search(Profile(ProfileRole::rail, face), Profile(ProfileRole::wheel, back));
  // both circles' centres: the wheel's at (y, z + rounding), the rail's at (-0.013, -0.013)
  for (const double yaw : {0.0, 0.02})
    for (const double above : {0.002, 0.004}) {
      const auto p = placed(0.4, {0, 0.0102, 0.4 - 0.013 - rounding + above}, 0, yaw);
      const double view = -std::numbers::pi / 2;
      const auto points = search.find(p, 1e-3, view);
      ASSERT_GE(points.size(), 1U);
      if (yaw == 0) {
        const double delta = std::asin(above / (rounding + 0.013));
        EXPECT_NEAR(points[0].inclination - view, delta, 1e-6);
        EXPECT_NEAR(points[0].gap, 0.0102 + 0.013 - (rounding + 0.013) * std::cos(delta), 1e-8);
      }
      EXPECT_TRUE(points[0].minimum);
    }
}

TEST(ContactSearch, RegionsEndWhereTheCirclesCross) {
  const double sphere = 0.3, head = 0.1;
  ContactSearch search(round_head(head), spherical_wheel(sphere));
  for (const double yaw : {0.0, 0.1})
    for (const double approach : {1e-9, 1e-6, 3e-4}) {
      const double y = 0.006;
      const auto points = search.find(placed(sphere, {0, y, 0.5}, 0, yaw), 1e-3);
      const double lowering = points[0].gap + approach;
      const auto regions = search.regions(lowering);
      ASSERT_EQ(regions.size(), 1U);
      EXPECT_EQ(regions[0].count, 1U);
      // both crossings lie on the circles' common chord
      const double z = 0.5 - lowering + head, distance = std::hypot(y, z);
      const double along = (distance * distance + head * head - sphere * sphere) / (2 * distance);
      const double half = std::sqrt(head * head - along * along), middle = along * y / distance;
      EXPECT_NEAR(regions[0].inner.place.y, middle - half * z / distance, 1e-9);
      EXPECT_NEAR(regions[0].outer.place.y, middle + half * z / distance, 1e-9);
      EXPECT_EQ(regions[0].inner.corner, Corner::none);
    }
}

TEST(ContactSearch, RegionsJoinWhenTheGapBetweenThemCloses) {
  // two ridges of equal height, 12 mm apart, with a valley 20 um deep
  const Profile rail = profile_of(ProfileRole::rail, -0.02, 0.02, 801, [](double y) {
    const double t = y / 0.006;
    return -2e-5 * (t * t - 1) * (t * t - 1);
  });
  const Profile wheel(ProfileRole::wheel, std::vector<ProfilePoint>{{-0.05, 0}, {0.05, 0}});
  ContactSearch search(rail, wheel);
  const auto points = search.find(placed(0.4, {0, 0, 0.4}, 0, 0), 1e-4);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_FALSE(points[1].minimum);
  EXPECT_EQ(search.regions(-1e-6).size(), 0U);
  const auto apart = search.regions(1.999e-5);
  ASSERT_EQ(apart.size(), 2U);
  // t^2 = 1 +- sqrt(1.999/2)
  EXPECT_NEAR(apart[0].outer.place.y, -0.006 * std::sqrt(1 - std::sqrt(0.9995)), 1e-7);
  EXPECT_NEAR(apart[1].outer.place.y, 0.006 * std::sqrt(1 + std::sqrt(0.9995)), 1e-7);
  const auto joined = search.regions(2.001e-5);
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_EQ(joined[0].count, 3U);
  EXPECT_NEAR(joined[0].outer.place.y, 0.006 * std::sqrt(1 + std::sqrt(1.0005)), 1e-7);
}

TEST(ContactSearch, ARegionMayReachTheEndOfTheRail) {
  ContactSearch search(round_head(0.3, 0.02), spherical_wheel(0.4));
  const auto points = search.find(placed(0.4, {0, 0.046, 0.4}, 0, 0), 1e-3);
  const auto regions = search.regions(points[0].gap + 1e-4);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].outer.corner, Corner::end);
  EXPECT_NEAR(regions[0].outer.place.y, 0.02, 1e-9);
  EXPECT_EQ(regions[0].inner.corner, Corner::none);
}

TEST(ContactSearch, RefusesMistakenRoles) {
  EXPECT_THROW(ContactSearch(spherical_wheel(0.3), round_head(0.1)), Error);
}

/// Geometry of S1002 on UIC60 computed independently with another spline search: y [mm], yaw, roll, then y_r, radius
/// and inclination of the left and of the right wheel, which the displacement to the right brings to the flange.
struct Known {
  double y, yaw, roll, y_left, r_left, delta_left, y_right, r_right, delta_right;
};
const Known known[] = {
    {0, 0, 0, 7.279, 459.9063, .0243, -7.279, 459.9063, -.0243},
    {.5, 0, -2.4e-5, 5.917, 459.8652, .0197, -18.531, 460.4175, -.0668},
    {1, 0, -5.4e-5, 5.011, 459.8393, .0167, -18.863, 460.4759, -.0710},
    {3, 0, -1.84e-4, 3.167, 459.7866, .0106, -20.552, 460.7806, -.0922},
    {4.5, 0, -3.02e-4, 2.636, 459.7661, .0088, -22.622, 461.1604, -.1182},
    {5, 0, -3.70e-4, 2.541, 459.7605, .0085, -33.976, 463.4541, -.3005},
    {6, 0, -6.51e-4, 2.420, 459.7496, .0081, -35.472, 464.4275, -.4236},
    {6.5, 0, -4.252e-3, 1.839, 459.7240, .0062, -42.134, 476.5853, -1.1771},
    {10, 0, -1.1350e-2, 3.304, 459.6418, .0110, -39.459, 482.9227, -.8006},
    {6, .0144, -6.33e-4, 2.428, 459.7490, .0081, -35.355, 464.3577, -.4138},
    {6.5, .0156, -4.549e-3, 1.833, 459.7215, .0061, -42.013, 477.0283, -1.1535},
    {10, .0240, -1.1289e-2, 3.409, 459.6399, .0114, -39.442, 482.9521, -.7987},
};

TEST(ContactSearch, S1002OnUic60) {
  const auto rail = shared_profile("contact-cases/MBench_UIC60_v3.prr");
  const auto wheel = shared_profile("contact-cases/MBench_S1002_v3.prw");
  if (!rail || !wheel) GTEST_SKIP() << "the benchmark's profiles are not at hand";
  const NominalPlacement nominal = nominal_placement({}, *rail, {}, *wheel);
  EXPECT_NEAR(nominal.rail.origin.y, 0.7605326, 1e-7);
  ContactSearch search(*rail, *wheel);
  for (const Known& k : known) {
    SCOPED_TRACE("y = " + std::to_string(k.y));
    WheelState<double> state;
    state.lateral = -k.y * 1e-3;
    state.yaw = -k.yaw;
    state.roll = k.roll;
    // the table's y is to the right and its z down: y changes its sign, the inclination, an angle about x, does not;
    // the right side is solved in its mirror image, in which it does
    const auto check = [&](const WheelState<double>& s, double y_r, double r, double delta) {
      const auto placement = place(nominal, s);
      const auto points = search.find(placement, 1e-4);
      const auto least = std::min_element(points.begin(), points.end(),
                                          [](const ContactPoint& a, const ContactPoint& b) { return a.gap < b.gap; });
      ASSERT_NE(least, points.end());
      EXPECT_NEAR(rail->at(least->s_rail).value.y * 1e3, y_r, 1.1e-3);
      EXPECT_NEAR(least->radius * 1e3, r, 2e-3);
      EXPECT_NEAR(least->inclination, delta, 6e-5);
    };
    check(state, -k.y_left, k.r_left, k.delta_left);
    check(state.mirrored(), k.y_right, k.r_right, -k.delta_right);
  }
}

} // namespace
} // namespace microslip
