// Grids of elements twice as large: they cover the grid, keep constants, and return Hertz's pressure.

#include "microslip/exact/halfspace/coarser_elements.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

TEST(CoarserElements, CoverTheGrid) {
  for (const int mx : {1, 2, 7, 8})
    for (const int my : {1, 5, 6}) {
      const ElementGrid grid{.mx = mx, .my = my, .x0 = -0.3, .y0 = 0.2, .dx = 0.1, .dy = 0.25};
      const ElementGrid coarse = coarser_grid(grid);
      EXPECT_EQ(coarse.mx, mx == 1 ? 1 : (mx + 1) / 2);
      EXPECT_EQ(coarse.my, my == 1 ? 1 : (my + 1) / 2);
      EXPECT_NEAR(coarse.x0 - coarse.dx / 2, grid.x0 - grid.dx / 2, 1e-15);
      EXPECT_NEAR(coarse.y0 - coarse.dy / 2, grid.y0 - grid.dy / 2, 1e-15);
      const std::vector<double> gap(grid.count(), 0.75);
      for (const double value : mean_on_coarser(grid, gap)) EXPECT_NEAR(value, 0.75, 1e-15);
    }
}

TEST(CoarserElements, PressureOfAnEllipse) {
  const ElementGrid grid = ElementGrid::across_ellipse(1, 1, 48, 2), coarse = coarser_grid(grid);
  const auto hertz = [](double x, double y) { return std::sqrt(std::max(0.0, 1 - x * x - y * y)); };
  std::vector<double> pressure(coarse.count());
  for (int j = 0; j < coarse.my; ++j)
    for (int i = 0; i < coarse.mx; ++i)
      pressure[static_cast<std::size_t>(j) * coarse.mx + i] = hertz(coarse.x(i), coarse.y(j));
  const auto fine = pressure_from_coarser(grid, pressure);
  ASSERT_EQ(fine.size(), grid.count());
  double error = 0;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const double value = fine[static_cast<std::size_t>(j) * grid.mx + i];
      EXPECT_GE(value, 0);
      error += std::pow(value - hertz(grid.x(i), grid.y(j)), 2);
    }
  EXPECT_LT(std::sqrt(error / static_cast<double>(grid.count())), 0.04);
}

} // namespace
} // namespace microslip
