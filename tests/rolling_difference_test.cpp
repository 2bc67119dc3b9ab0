#include "microslip/exact/halfspace/rolling_difference.hpp"

#include "microslip/exact/halfspace/surface_operator.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace microslip {
namespace {

void expect_same(const Field& found, const Field& wanted) {
  for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(found[k], wanted[k], 1e-12 * largest(wanted));
}

/// The kernels of the difference and of the displacement, computed apart at all offsets, do the same.
TEST(RollingDifference, IsThatOfTheKernelsOfSlipAndDisplacement) {
  std::vector<ElementGrid> grids = {{.mx = 17, .my = 9, .x0 = 0, .y0 = 0, .dx = 3e-4, .dy = 2e-4},
                                    {.mx = 5, .my = 12, .x0 = 0, .y0 = 0, .dx = 1e-4, .dy = 5e-4},
                                    {.mx = 20, .my = 1, .x0 = 0, .y0 = 0, .dx = 1e-4, .dy = 1, .line = true}};
  grids.push_back(grids[0]);
  grids.back().shape = ElementShape::bilinear;
  Bodies layered = steel;
  layered.layer.flexibility = 2e-15;
  for (const ElementGrid& grid : grids)
    for (const Bodies& bodies : {Bodies(steel), layered})
      for (const int columns : {1, -1, 3, -2}) {
        const Field px = random_field(grid.count(), 1, 1e8), py = random_field(grid.count(), 2, 1e8);
        Field sx(px), sy(px), wanted_x(px), wanted_y(px);
        RollingDifference rolling(bodies, grid, columns);
        TangentialOperator difference = TangentialOperator::difference(bodies, grid, columns * grid.dx);
        rolling.apply(px, py, sx, sy);
        difference.apply(px, py, wanted_x, wanted_y);
        expect_same(sx, wanted_x);
        expect_same(sy, wanted_y);
        EXPECT_NEAR(rolling.diagonal(), difference.diagonal(), 1e-12 * difference.diagonal());
        rolling.displacement(px, py, sx, sy);
        TangentialOperator::displacement(bodies, grid).apply(px, py, wanted_x, wanted_y);
        expect_same(sx, wanted_x);
        expect_same(sy, wanted_y);
        EXPECT_EQ(rolling.products(), 2);
      }
}

} // namespace
} // namespace microslip
