#include "microslip/exact/halfspace/traction_shares.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace microslip {
namespace {

constexpr ElementGrid grid{.mx = 6, .my = 4, .x0 = -2.5, .y0 = -3, .dx = 1, .dy = 2};

/// With a contact in rows 1 and 2, columns 1 to 4.
TractionShares shares_of(double (*share_x)(double, double), double (*share_y)(double, double)) {
  std::vector<double> bound(grid.count()), px(bound), py(bound);
  for (int j = 1; j <= 2; ++j)
    for (int i = 1; i <= 4; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      bound[k] = 100 + static_cast<double>(k);
      px[k] = bound[k] * share_x(grid.x(i), grid.y(j));
      py[k] = bound[k] * share_y(grid.x(i), grid.y(j));
    }
  return {grid, bound, px, py};
}

TEST(TractionShares, AreBilinearInsideWhateverTheBound) {
  const auto share_x = [](double x, double y) { return 0.1 + 0.2 * x - 0.05 * y + 0.03 * x * y; };
  const auto share_y = [](double x, double y) { return -0.3 * x * y; };
  const TractionShares shares = shares_of(share_x, share_y);
  for (const double x : {-1.5, -0.7, 0.0, 1.1, 1.5})
    for (const double y : {-1.0, -0.4, 0.9, 1.0}) {
      EXPECT_NEAR(shares.at(x, y).x, share_x(x, y), 1e-14);
      EXPECT_NEAR(shares.at(x, y).y, share_y(x, y), 1e-14);
    }
}

TEST(TractionShares, GoOnBeyondTheEdges) {
  const auto share = [](double x, double y) { return x + 10 * y; };
  const TractionShares shares = shares_of(share, share);
  EXPECT_DOUBLE_EQ(shares.at(2.4, -1).x, share(1.5, -1));
  EXPECT_DOUBLE_EQ(shares.at(-9, 1).y, share(-1.5, 1));
  EXPECT_DOUBLE_EQ(shares.at(0.5, 1.9).x, share(0.5, 1)); // between a row with elements and one without
  EXPECT_DOUBLE_EQ(shares.at(0.5, -1.9).x, share(0.5, -1));
}

TEST(TractionShares, NeedNoBound) {
  TractionShares shares(grid);
  EXPECT_EQ(shares.at(0, 0).x, 0);
  shares.add(2, 0.5, 0, {1, 2});
  EXPECT_EQ(shares.at(0.5, grid.y(2)).x, 0);
}

} // namespace
} // namespace microslip
