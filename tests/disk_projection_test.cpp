#include "microslip/exact/newton/disk_projection.hpp"

#include <utility>

#include <gtest/gtest.h>

namespace microslip {
namespace {

TEST(DiskProjection, LeavesWhatIsOnTheDisk) {
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.3, -0.4}, {-3.0, 4.0}}) {
    const DiskProjection p = project_on_disk(x, y, 5);
    EXPECT_EQ(p.scale, 1);
    EXPECT_FALSE(p.outside);
  }
  EXPECT_EQ(project_on_disk(0, 0, 0).scale, 1);
}

TEST(DiskProjection, TakesTheRestToTheEdge) {
  const DiskProjection p = project_on_disk(-6, 8, 5);
  EXPECT_TRUE(p.outside);
  EXPECT_DOUBLE_EQ(p.scale, 0.5);
  EXPECT_EQ(project_on_disk(1e-300, 0, 0).scale, 0);
}

} // namespace
} // namespace microslip
