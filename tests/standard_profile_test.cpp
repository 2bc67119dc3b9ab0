#include "microslip/railway/profile/standard_profile.hpp"

#include "io/profile_file.hpp"
#include "microslip/railway/profile/profile_dimensions.hpp"
#include "paths.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

namespace microslip {
namespace {

constexpr StandardProfile wheels[] = {StandardProfile::s1002, StandardProfile::cone_20, StandardProfile::cone_40};
constexpr StandardProfile rails[] = {StandardProfile::rail_60, StandardProfile::rail_54};
constexpr double thicknesses[] = {28.5e-3, 29e-3, 30.5e-3, 31.7e-3, 32.5e-3};

/// The largest curvature [1/m] of the polygon: how far it turns over the length of half its sides there.
double sharpest_bend(const std::vector<ProfilePoint>& points) {
  double worst = 0;
  for (std::size_t k = 1; k + 1 < points.size(); ++k) {
    const double y = points[k].y - points[k - 1].y, z = points[k].z - points[k - 1].z;
    const double next_y = points[k + 1].y - points[k].y, next_z = points[k + 1].z - points[k].z;
    const double turn = std::atan2(next_z, next_y) - std::atan2(z, y);
    worst = std::max(worst, 2 * std::abs(turn) / (std::hypot(y, z) + std::hypot(next_y, next_z)));
  }
  return worst;
}

/// Distance [m] of a point from the polygon, which is convex or hollow between its points.
double distance(ProfilePoint p, const std::vector<ProfilePoint>& polygon) {
  double nearest = 1;
  for (std::size_t k = 0; k + 1 < polygon.size(); ++k) {
    const auto a = polygon[k], b = polygon[k + 1];
    const double dy = b.y - a.y, dz = b.z - a.z;
    const double t = std::clamp(((p.y - a.y) * dy + (p.z - a.z) * dz) / (dy * dy + dz * dz), 0., 1.);
    nearest = std::min(nearest, std::hypot(p.y - a.y - t * dy, p.z - a.z - t * dz));
  }
  return nearest;
}

TEST(StandardProfile, IsThatOfTheExamples) {
  const auto expect_same = [](StandardProfile standard, const char* file) {
    const auto points = standard_points(standard);
    const auto example =
        io::read_profile(std::filesystem::path(MICROSLIP_SOURCE_DIR) / "examples/profiles" / file).points;
    for (const auto p : points) EXPECT_LT(distance(p, example), 1e-10) << file;
    for (const auto p : example) EXPECT_LT(distance(p, points), 1e-10) << file;
  };
  expect_same(StandardProfile::s1002, "s1002.prw");
  expect_same(StandardProfile::rail_60, "60e1.prr");
}

/// Widths and heights that the drawings print besides the arcs: 72 mm at 14.3 mm, 70 mm at 14.1 mm.
TEST(StandardProfile, ArcsOfHeadsCloseToTheirWidth) {
  const auto side = [](StandardProfile standard, double depth) {
    const Profile rail = standard_profile(standard).profile;
    return rail.at(crossings(rail, &ProfilePoint::z, -depth).front()).value.y;
  };
  EXPECT_NEAR(side(StandardProfile::rail_60, 14.3e-3), -36e-3, 1e-6);
  EXPECT_NEAR(side(StandardProfile::rail_54, 14.1e-3), -35e-3, 1e-6);
  for (const auto standard : rails) {
    const auto points = standard_points(standard);
    const auto top = *std::max_element(points.begin(), points.end(), [](auto a, auto b) { return a.z < b.z; });
    EXPECT_EQ(top.y, 0);
    EXPECT_EQ(top.z, 0);
    for (std::size_t k = 0; k < points.size(); ++k) { // mirrored in its axis
      EXPECT_NEAR(points[k].y, -points[points.size() - 1 - k].y, 1e-15);
      EXPECT_NEAR(points[k].z, points[points.size() - 1 - k].z, 1e-15);
    }
  }
}

TEST(StandardProfile, PartsAreTangent) {
  const auto expect_smooth = [](const std::vector<ProfilePoint>& points, double radius) {
    EXPECT_LT(sharpest_bend(points), 1.01 / radius);
  };
  for (const auto standard : rails) expect_smooth(standard_points(standard), 13e-3);
  for (const auto standard : wheels)
    for (const double thickness : thicknesses) expect_smooth(standard_points(standard, thickness), 12e-3);
}

TEST(StandardProfile, FlangeHasItsThicknessAndHeight) {
  for (const auto standard : wheels)
    for (const double thickness : thicknesses) {
      const auto wheel = standard_profile(standard, thickness).profile;
      const auto dimensions = wheel_dimensions(wheel, default_tape_line(wheel));
      EXPECT_EQ(dimensions.tape_line, 0);
      EXPECT_NEAR(dimensions.flange_thickness.value(), thickness, 2e-7) << thickness;
      EXPECT_NEAR(dimensions.flange_height.value(), 28e-3, 2e-8) << thickness;
      EXPECT_NEAR(dimensions.flange_angle.value(), std::atan(2.747477419), 2e-3)
          << thickness; // the spline swings where arcs end
    }
}

/// A thinner flange leaves the tread as it is, from y = -26 mm on, and the flank's angle.
TEST(StandardProfile, ThinnerFlangeHasTheSameTread) {
  const auto whole = standard_points(StandardProfile::s1002);
  for (const double thickness : thicknesses)
    for (const auto p : standard_points(StandardProfile::s1002, thickness)) {
      EXPECT_GE(p.y, -70e-3 - 1e-12);
      if (p.y >= -26e-3) {
        EXPECT_LT(distance(p, whole), 1e-9);
      }
    }
}

TEST(StandardProfile, ConesAreStraight) {
  for (const auto& [standard, inclination] :
       {std::pair{StandardProfile::cone_20, 0.05}, {StandardProfile::cone_40, 0.025}})
    for (const auto p : standard_points(standard)) {
      if (p.y > -25e-3) {
        EXPECT_NEAR(p.z, inclination * p.y, 1e-15);
      }
    }
}

/// The tip of the reference wheels of EN 15302, arcs of 12 and 20 mm, is that of EN 13715; backs and treads are others.
TEST(StandardProfile, FlangeIsThatOfTheReferenceWheelsOfEn15302) {
  const auto folder = std::filesystem::path(MICROSLIP_SOURCE_DIR) / "../shared/data/en15302";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  const auto whole = standard_points(StandardProfile::s1002);
  for (const char* file : {"wheel_a.dat", "wheel_b.dat"}) {
    const auto reference = io::read_profile(folder / file).points;
    double worst = 0;
    for (const auto p : reference)
      if (p.y > -62.7e-3 && p.y < -40e-3) worst = std::max(worst, distance(p, whole));
    EXPECT_LT(worst, 2e-6) << file;
  }
}

TEST(StandardProfile, RefusesFlangesThatItHasNot) {
  EXPECT_EQ(error_of([] { standard_points(StandardProfile::s1002, 0.04); }),
            "flange_thickness = 0.04 [m]: must be in [0.0285, 0.0325]");
  EXPECT_EQ(error_of([] { standard_points(StandardProfile::rail_54, 0.03); }), "flange_thickness: 54E1 is a rail");
}

} // namespace
} // namespace microslip
