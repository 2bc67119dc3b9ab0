#include "microslip/exact/classical/grid_part.hpp"
#include "tests/support/fields.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const ElementGrid grid{.mx = 60, .my = 50, .x0 = -2, .y0 = 3, .dx = 0.1, .dy = 0.2};

/// A pressure on the columns and rows from `left` and `low` to `right` and `high`.
Field block(int left, int right, int low, int high) {
  Field p(grid.count());
  for (int j = low; j <= high; ++j)
    for (int i = left; i <= right; ++i) p[static_cast<std::size_t>(j) * grid.mx + i] = 1;
  return p;
}

TEST(GridPart, HasAllElementsWithAPressureAndLiesWithinTheGrid) {
  struct Block {
    int left, right, low, high;
  };
  for (const auto& [left, right, low, high] :
       std::vector<Block>{{20, 30, 20, 30}, {0, 5, 0, 3}, {55, 59, 46, 49}, {0, 59, 20, 21}, {31, 31, 7, 7}}) {
    const Field p = block(left, right, low, high);
    const GridPart part = GridPart::around(p, grid);
    EXPECT_FALSE(part.is_whole());
    EXPECT_EQ(sum(part.cut(p)), sum(p));
    EXPECT_EQ(part.spread(part.cut(p)), p);
    EXPECT_GE(part.grid().x(0), grid.x(0) - 1e-9);
    EXPECT_LE(part.grid().x(part.grid().mx - 1), grid.x(grid.mx - 1) + 1e-9);
    EXPECT_LE(part.grid().y(part.grid().my - 1), grid.y(grid.my - 1) + 1e-9);
    const Field x = part.cut(over_grid(grid, [](double at_x, double) { return at_x; })),
                y = part.cut(over_grid(grid, [](double, double at_y) { return at_y; }));
    std::size_t k = 0;
    for (int j = 0; j < part.grid().my; ++j)
      for (int i = 0; i < part.grid().mx; ++i, ++k) {
        EXPECT_NEAR(x[k], part.grid().x(i), 1e-12);
        EXPECT_NEAR(y[k], part.grid().y(j), 1e-12);
      }
    std::size_t elements = 0;
    for (std::size_t e = 0; e < grid.count(); ++e) elements += part.has(e) ? 1 : 0;
    EXPECT_EQ(elements, part.grid().count());
  }
}

TEST(GridPart, IsTheWholeGridWhereMostOfItIsNeeded) {
  EXPECT_TRUE(GridPart::around(block(5, 55, 5, 45), grid).is_whole());
  EXPECT_TRUE(GridPart::around(Field(grid.count()), grid).is_whole());
  EXPECT_TRUE(GridPart(grid).is_whole());
  EXPECT_TRUE(GridPart(grid).cut({}).empty());
}

} // namespace
} // namespace microslip
