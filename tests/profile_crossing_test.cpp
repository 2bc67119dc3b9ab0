#include "microslip/railway/profile/profile_crossing.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

TEST(ProfileCrossing, IsFoundBetweenSidesThatAreNotNeighbours) {
  const std::vector<ProfilePoint> loop = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  const auto found = find_crossing(loop);
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, std::pair(std::size_t{0}, std::size_t{2}));
  const std::vector<ProfilePoint> touching = {{0, 0}, {2, 0}, {2, 1}, {1, 0}}, on_itself = {{0, 0}, {2, 0}, {1, 0}},
                                  zigzag = {{0, 0}, {2, 0}, {1, 0.1}, {3, 0.2}};
  EXPECT_TRUE(find_crossing(touching));
  EXPECT_FALSE(find_crossing(on_itself)) << "neighbours";
  EXPECT_FALSE(find_crossing(zigzag));
  EXPECT_FALSE(find_crossing({}));
}

} // namespace
} // namespace microslip
