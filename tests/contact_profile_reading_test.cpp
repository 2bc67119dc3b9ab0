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

} // namespace
} // namespace microslip::contact_program
