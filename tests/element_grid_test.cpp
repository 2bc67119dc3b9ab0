#include "microslip/contact/element_grid.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"

#include <gtest/gtest.h>

namespace microslip {
namespace {

TEST(ElementGrid, AcrossAnEllipse) {
  const double a = 3e-3, b = 5e-3;
  for (const int margin : {0, 1, 4}) {
    const ElementGrid grid = ElementGrid::across_ellipse(a, b, 7, 12, margin);
    EXPECT_EQ(grid.mx, 7 + 2 * margin);
    EXPECT_EQ(grid.my, 12 + 2 * margin);
    EXPECT_EQ(grid.count(), static_cast<std::size_t>(grid.mx) * grid.my);
    EXPECT_FALSE(grid.line);
    // The elements next to the margin end at the ellipse's ends; the grid is symmetric.
    EXPECT_NEAR(grid.x(margin) - grid.dx / 2, -a, 1e-15);
    EXPECT_NEAR(grid.y(margin + 11) + grid.dy / 2, b, 1e-15);
    EXPECT_NEAR(grid.x(grid.mx - 1), -grid.x(0), 1e-15);
    EXPECT_NEAR(grid.y(grid.my - 1), -grid.y(0), 1e-15);
    EXPECT_NEAR(grid.element_area() * 7 * 12, 4 * a * b, 1e-15);
    check(grid);
  }
  const ElementGrid square = ElementGrid::across_ellipse(a, b, 9, 2), same = ElementGrid::across_ellipse(a, b, 9, 9, 2);
  EXPECT_EQ(square.mx, same.mx);
  EXPECT_EQ(square.my, same.my);
  EXPECT_EQ(square.y0, same.y0);
}

TEST(ElementGrid, AcrossALine) {
  const ElementGrid grid = ElementGrid::across_line(2e-3, 8, 3, 0.4);
  EXPECT_TRUE(grid.line);
  EXPECT_EQ(grid.mx, 14);
  EXPECT_EQ(grid.my, 1);
  EXPECT_EQ(grid.dy, 0.4);
  EXPECT_NEAR(grid.x(3) - grid.dx / 2, -2e-3, 1e-15);
  EXPECT_NEAR(grid.x(13), -grid.x(0), 1e-15);
  check(grid);
}

TEST(ElementGrid, RefusesWhatMakesNoSense) {
  for (const double bad : {0.0, -1e-3, nan, infinity}) {
    expect_error([&] { ElementGrid::across_ellipse(bad, 1, 5); }, "a", "[m]: must be positive and finite");
    expect_error([&] { ElementGrid::across_ellipse(1, bad, 5); }, "b", "[m]: must be positive and finite");
    expect_error([&] { ElementGrid::across_line(bad, 5); }, "a", "[m]: must be positive and finite");
    expect_error([&] { ElementGrid::across_line(1, 5, 0, bad); }, "length", "[m]: must be positive and finite");
    ElementGrid grid = ElementGrid::across_ellipse(1, 1, 3);
    grid.dx = bad;
    expect_error([&] { check(grid); }, "grid.dx", "[m]: must be positive and finite");
    grid = ElementGrid::across_ellipse(1, 1, 3);
    grid.dy = bad;
    expect_error([&] { check(grid); }, "grid.dy", "[m]: must be positive and finite");
  }
  for (const int bad : {0, -3, 10001}) {
    EXPECT_THROW(ElementGrid::across_ellipse(1, 1, bad), Error);
    EXPECT_THROW(ElementGrid::across_ellipse(1, 1, 3, bad, 0), Error);
    EXPECT_THROW(ElementGrid::across_line(1, bad), Error);
  }
  ElementGrid grid = ElementGrid::across_ellipse(1, 1, 3);
  grid.x0 = nan;
  expect_error([&] { check(grid); }, "grid.x0", "[m]: must be finite");
  expect_error([] { check(ElementGrid{}); }, "grid.mx", "[-]: must be in [1, 1e+08]");
}

} // namespace
} // namespace microslip
