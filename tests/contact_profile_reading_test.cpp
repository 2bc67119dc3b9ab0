// Profiles as CONTACT's input files name them: which of them have z upwards, and where they are looked for.

#include "compat/contact/wheel_rail/profile_reading.hpp"
#include "paths.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

namespace fs = std::filesystem;

class ContactProfileReading : public ::testing::Test {
protected:
  /// The curve of a file of two columns.
  std::shared_ptr<const ProfileCurve> read(const std::vector<ProfilePoint>& points, ProfileRole role,
                                           int mirror_z = 0) const {
    const fs::path path = folder_ / "profile.txt";
    std::ofstream file(path);
    file.precision(15);
    for (const ProfilePoint& p : points) file << p.y << " " << p.z << "\n";
    file.close();
    ProfileRecord record;
    record.file = path.string();
    record.mirror_z = mirror_z;
    return read_profile_curve(record, role);
  }

  /// Returns whether the sign of z is changed.
  bool is_turned(const std::vector<ProfilePoint>& points, ProfileRole role) const {
    const auto found = read(points, role)->points(), turned = read(points, role, 1)->points();
    const auto same = [](const ProfilePoint& a, const ProfilePoint& b) { return a.z == b.z; };
    return std::equal(found.begin(), found.end(), turned.begin(), same);
  }

  /// Over y from -20 to 40 mm in 60 steps.
  static std::vector<ProfilePoint> over_y(const std::function<double(double)>& z) {
    std::vector<ProfilePoint> points;
    for (int k = 0; k <= 60; ++k) points.push_back({-20.0 + k, z(-20.0 + k)});
    return points;
  }

  TemporaryFolder folder_;
};

/// A head that falls by 1.3 mm at one end and by 25 mm at the other, as measured rails do that end on the top: within
/// the outer tenth of the points the flat end changes by 2 % of the height.
double head(double y) {
  return y < 25 ? y * y / 300 : 25 * 25 / 300.0 + std::pow(y - 25, 2) / 10;
}

TEST_F(ContactProfileReading, RailsWithZUpwardsAreTurned) {
  EXPECT_TRUE(is_turned(over_y([](double y) { return -head(y); }), ProfileRole::rail));
  EXPECT_FALSE(is_turned(over_y(head), ProfileRole::rail));
}

/// CONTACT's threshold is a thousandth of the whole height; what is below it says nothing, and the other end decides.
TEST_F(ContactProfileReading, AChangeOfAThousandthCounts) {
  const auto rail = [](double step) {
    auto points = over_y([](double y) { return y < 10 ? 0 : -std::pow(y - 10, 2) / 9; }); // up, 100 high
    for (std::size_t k = 1; k < 6; ++k) points[k].z = points.front().z - step;            // and down at the other end
    return points;
  };
  EXPECT_TRUE(is_turned(rail(0.099), ProfileRole::rail));
  EXPECT_FALSE(is_turned(rail(0.101), ProfileRole::rail)) << "the ends contradict each other";
}

/// Where neither end changes the least z decides: at an end it is that of a rail's side, with z upwards.
TEST_F(ContactProfileReading, FlatEndsLeaveItToTheLeastZ) {
  const auto step = [](double y) { return std::abs(y - 10) < 15 ? 5.0 : 0.0; };
  EXPECT_TRUE(is_turned(over_y(step), ProfileRole::rail));
  EXPECT_FALSE(is_turned(over_y([&](double y) { return -step(y); }), ProfileRole::rail));
}

TEST_F(ContactProfileReading, WheelsWithZUpwardsAreTurned) {
  const auto down = [](double y) { return 28 * std::exp(-std::pow((y + 10) / 5, 2)) - y / 20; }; // flange at y = -10
  EXPECT_FALSE(is_turned(over_y(down), ProfileRole::wheel));
  EXPECT_TRUE(is_turned(over_y([&](double y) { return -down(y); }), ProfileRole::wheel));
  // Hollow: least and greatest z both lie within the profile.
  const auto hollow = [&](double y) { return down(y) - 8 * std::exp(-std::pow((y - 20) / 8, 2)); };
  EXPECT_FALSE(is_turned(over_y(hollow), ProfileRole::wheel));
  EXPECT_TRUE(is_turned(over_y([&](double y) { return -hollow(y); }), ProfileRole::wheel));
}

/// A measured rail of CONTACT's test bank, whose field end falls by 0.1 mm from point to point.
TEST_F(ContactProfileReading, AMeasuredRailIsTurned) {
  const fs::path path = MICROSLIP_SOURCE_DIR "/../shared/contact-cases/wheel-rail/profiles/avg_HR.BAN";
  if (!fs::exists(path)) GTEST_SKIP() << "no file " << path;
  ProfileRecord record;
  record.file = path.string();
  record.mirror_y = 1;
  const auto found = read_profile_curve(record, ProfileRole::rail)->points();
  record.mirror_z = 1;
  const auto turned = read_profile_curve(record, ProfileRole::rail)->points();
  ASSERT_EQ(found.size(), turned.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k].z, turned[k].z);
}

/// One with a remark behind its numbers, which CONTACT reads.
TEST_F(ContactProfileReading, RemarksBehindTheNumbersOfMiniProfAreRead) {
  std::ofstream(folder_ / "rail.ban")
      << "XYPoints=4\nColumnDef=X,Y,A\n\n-20 5 0 first point, added\n-10 1 0\n10 1 0 \" x\n"
         "20 5 0 12 more\n";
  ProfileRecord record;
  record.file = (folder_ / "rail.ban").string();
  EXPECT_EQ(read_profile_curve(record, ProfileRole::rail)->points().size(), 4u);
  std::ofstream(folder_ / "rail.ban") << "ColumnDef=X,Y,A\n\n-20 5 0\n-10 1 about 0\n10 1 0\n";
  EXPECT_EQ(error_of([&] { read_profile_curve(record, ProfileRole::rail); }),
            record.file + ":4: a coordinate: \"about\" is not a finite number");
}

/// The least distance of points is in the file's unit: 1e-4, or what a Simpack file says.
TEST_F(ContactProfileReading, SimpackFilesSayWhichPointsAreOne) {
  const auto points_of = [this](const std::string& keys) {
    std::ofstream file(folder_ / "rail.prr");
    file.precision(15);
    file << "header.begin\n type = 0\nheader.end\nspline.begin\n units.len.f = 1\n" << keys << " point.begin\n";
    for (int k = 0; k <= 400; ++k) file << 5e-5 * (k - 200) << " " << 5e-6 * std::abs(k - 200) << "\n"; // m
    file << " point.end\nspline.end\n";
    file.close();
    ProfileRecord record;
    record.file = (folder_ / "rail.prr").string();
    return read_profile_curve(record, ProfileRole::rail)->points().size();
  };
  EXPECT_EQ(points_of(""), 201u);
  EXPECT_EQ(points_of(" point.dist.min = 0\n"), 401u);
  EXPECT_EQ(points_of(" point.dist.min = 1.2e-4\n"), 134u);
}

/// -1 undoes a Simpack file's mirror, 1 does so, too, and 0 leaves it.
TEST_F(ContactProfileReading, MirrorsOfFileAndRecordAddUp) {
  std::ofstream(folder_ / "wheel.prw") << "header.begin\n type = 1\nheader.end\nspline.begin\n mirror.y = 1\n"
                                          " mirror.z = 1\n units.len.f = 1000\n point.begin\n"
                                          "-20 -5\n0 0\n30 1\n point.end\nspline.end\n";
  ProfileRecord record;
  record.file = (folder_ / "wheel.prw").string();
  for (const int mirror : {-1, 0, 1}) {
    record.mirror_y = record.mirror_z = mirror;
    const auto least = read_profile_curve(record, ProfileRole::wheel)->points().front();
    EXPECT_NEAR(least.y / mm, mirror == 0 ? -30 : -20, 1e-12) << mirror;
    EXPECT_NEAR(least.z / mm, mirror == 0 ? -1 : -5, 1e-12) << mirror;
  }
}

/// A break between two kinks that have one point between them, or between the profile's beginning in CONTACT's order
/// and the first one: a wheel begins at the field side.
TEST_F(ContactProfileReading, NearKinksHaveABreakBetweenThem) {
  const std::vector<ProfilePoint> roof = {{-40, 20}, {-30, 10}, {-20, 0}, {-17, 0},
                                          {-14, 0},  {-11, 3},  {-1, 13}, {9, 23}};
  const auto kinks = read(roof, ProfileRole::rail, -1)->kinks();
  EXPECT_EQ(kinks, (std::vector<std::size_t>{1, 2, 3, 4}));
  std::vector<ProfilePoint> turned;
  for (const auto& p : roof) turned.insert(turned.begin(), {-p.y, -p.z});
  EXPECT_EQ(read(turned, ProfileRole::wheel, -1)->kinks(), (std::vector<std::size_t>{3, 4, 5, 6}));
}

TEST_F(ContactProfileReading, GivenPointsKeepTheirZigzags) {
  const std::vector<ProfilePoint> zigzag = {{-20, 0}, {1, 0}, {-1, 0.01}, {20, 0.02}};
  EXPECT_EQ(profile_curve_through(zigzag, {}, ProfileRole::rail)->points().size(), 4u);
  EXPECT_EQ(read(zigzag, ProfileRole::rail, -1)->points().size(), 3u);
}

TEST_F(ContactProfileReading, ProfilesThatCrossThemselvesAreRefused) {
  const std::string text = error_of([&] {
    read({{-20, 0}, {10, 0}, {10, 5}, {0, -5}, {20, 0}}, ProfileRole::rail, -1);
  });
  EXPECT_NE(text.find("the profile crosses itself"), std::string::npos) << text;
}

/// What smoothing leaves of the points, with CONTACT's weights, has no mean and no moment over s: straight lines are
/// smooth, so they fit the rest best.
TEST_F(ContactProfileReading, EndsOfASmoothedProfileWeighMore) {
  const auto rough = over_y([](double y) { return 0.1 * std::cos(1.7 * y * y); });
  ProfileRecord record;
  record.mirror_z = -1;
  record.smooth = 5;
  for (const int method : {0, 1, 2}) {
    record.smoothing = method;
    const auto smooth = profile_curve_through(rough, record, ProfileRole::rail)->points();
    std::vector<double> s = {0};
    for (std::size_t k = 1; k < rough.size(); ++k)
      s.push_back(s.back() + std::hypot(rough[k].y - rough[k - 1].y, rough[k].z - rough[k - 1].z));
    double mean = 0, moment = 0, second = 0, scatter = 0;
    for (std::size_t k = 0; k < rough.size(); ++k) {
      const bool first = k == 0, last = k + 1 == rough.size();
      const double side = first ? s[1] : last ? s[k] - s[k - 1] : (s[k + 1] - s[k - 1]) / 2;
      const double weight = method == 0 ? 1 : first || last ? 20 * side : side;
      const double moved = rough[k].z - smooth[k].z / mm;
      mean += weight * moved;
      moment += weight * s[k] * moved;
      second += weight * s[k] * s[k] * moved;
      scatter += weight * std::abs(moved);
    }
    EXPECT_GT(scatter, 0.1) << method;
    EXPECT_NEAR(mean, 0, 1e-9) << method;
    EXPECT_NEAR(moment, 0, 1e-7) << method;
    if (method == 2) {
      EXPECT_NEAR(second, 0, 1e-5) << "parabolas are smooth, too";
    }
  }
}

} // namespace
} // namespace microslip::contact_program
