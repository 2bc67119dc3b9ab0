// Elements whose particles have come into contact during a step.

#include "microslip/exact/halfspace/leading_edge.hpp"

#include "microslip/error.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Contact in columns 3 to 7 of the lower row and 5 to 8 of the upper one.
constexpr ElementGrid grid = {10, 2, 0, 0, 1e-3, 1e-3};
const std::vector<double> bound = {0, 0, 0, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0};

TEST(LeadingEdge, SharesOfTheStep) {
  const LeadingEdge edge = {.theta = 1, .where_possible = true};
  const auto entering = entering_elements(grid, bound, 2.5e-3, edge);
  ASSERT_EQ(entering.size(), 2U); // the lower row's first two; the upper row has one element ahead of it
  EXPECT_EQ(entering[0].element, 7U);
  EXPECT_NEAR(entering[0].share, 1 / 2.5, 1e-12);
  EXPECT_EQ(entering[0].ahead, 8U);
  EXPECT_EQ(entering[0].extrapolation, 0); // the edge is at that element's centre
  EXPECT_EQ(entering[1].element, 6U);
  EXPECT_NEAR(entering[1].share, 2 / 2.5, 1e-12);
  EXPECT_TRUE(entering_elements(grid, bound, 1e-3, edge).empty());
}

TEST(LeadingEdge, BackwardsTheOtherEndsLead) {
  const auto entering = entering_elements(grid, bound, -1e-3, {});
  ASSERT_EQ(entering.size(), 2U);
  EXPECT_EQ(entering[0].element, 3U);
  EXPECT_EQ(entering[1].element, 15U);
  EXPECT_NEAR(entering[0].share, 0.5, 1e-12);
}

TEST(LeadingEdge, NeedsTwoElementsAheadUnlessItIsToGoWithout) {
  EXPECT_THROW(entering_elements(grid, bound, 2.5e-3, {}), Error);
}

} // namespace
} // namespace microslip
