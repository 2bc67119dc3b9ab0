// Zigzags of a polygon are two turns in a row that go back; ends of the polygon do not turn.

#include "microslip/railway/profile/profile_kinks.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const std::vector<ProfilePoint> line = {{0, 0}, {1, 0}, {2, 0}, {3, 0}};

TEST(ProfileZigzags, AreTwoTurnsInARow) {
  const std::vector<ProfilePoint> back = {{0, 0}, {2, 0}, {1, 0}, {3, 0}};
  const auto kept = without_zigzags(back, 2);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_EQ(kept[1].y, 1.5);
  EXPECT_EQ(without_zigzags(line, 2).size(), line.size());
}

TEST(ProfileZigzags, EndsStayWhateverTheAngle) {
  for (const double angle : {-1.0, 0.0, 1.0})
    for (std::size_t count = 0; count <= line.size(); ++count) {
      const auto kept = without_zigzags({line.data(), count}, angle);
      ASSERT_EQ(kept.empty(), count == 0);
      if (count == 0) continue;
      EXPECT_EQ(kept.front().y, 0);
      EXPECT_EQ(kept.back().y, line[count - 1].y) << angle << " " << count;
    }
}

} // namespace
} // namespace microslip
