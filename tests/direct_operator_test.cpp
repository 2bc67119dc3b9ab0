#include "tests/oracles/direct_operator.hpp"

#include "dense_response.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace microslip {
namespace {

std::vector<ElementGrid> grids() {
  return {{1, 1, 0, 0, 1e-3, 2e-3, false},
          {1, 7, 0, 0, 1e-3, 2e-3, false},
          {9, 1, 0, 0, 1e-3, 2e-3, false},
          {8, 5, 0, 0, 1e-3, 4e-4, false},
          {12, 1, 0, 0, 1e-4, 1, true}};
}

PlaneFields random_tractions(const ElementGrid& grid) {
  std::mt19937 engine(3);
  PlaneFields p{Field(grid.count()), Field(grid.count())};
  for (Field* field : {&p.x, &p.y})
    for (double& value : *field) value = 1e8 * (static_cast<double>(engine()) * 0x1p-31 - 1);
  for (std::size_t k = 0; k < grid.count(); k += 3) p.x[k] = p.y[k] = 0; // no traction there
  return p;
}

PlaneFields apply(DirectOperator response, const PlaneFields& p) {
  PlaneFields s{Field(p.x.size(), 1e9), Field(p.x.size(), 1e9)}; // what was there does not matter
  response.apply(p.x, p.y, s.x, s.y);
  EXPECT_EQ(response.products(), 1);
  return s;
}

void expect_same(const PlaneFields& s, const PlaneFields& exact) {
  double scale = 0;
  for (std::size_t k = 0; k < s.x.size(); ++k) scale = std::max({scale, std::abs(exact.x[k]), std::abs(exact.y[k])});
  for (std::size_t k = 0; k < s.x.size(); ++k) {
    ASSERT_NEAR(s.x[k], exact.x[k], 1e-13 * scale);
    ASSERT_NEAR(s.y[k], exact.y[k], 1e-13 * scale);
  }
}

TEST(DirectOperator, IsTheSumOverPairs) {
  for (const ElementGrid& grid : grids()) {
    const PlaneFields p = random_tractions(grid);
    const auto displaced = [&](double shift) { return dense_displacement(steel, grid, p.x, p.y, shift); };
    expect_same(apply(DirectOperator(TangentialKernel::displacement(steel, grid)), p), displaced(0));
    for (const double step : {grid.dx, -grid.dx, 2.7 * grid.dx}) {
      const PlaneFields here = displaced(0), there = displaced(step);
      PlaneFields difference = here, moved = there;
      for (std::size_t k = 0; k < p.x.size(); ++k) {
        difference.x[k] = (here.x[k] - there.x[k]) / std::abs(step);
        difference.y[k] = (here.y[k] - there.y[k]) / std::abs(step);
        moved.x[k] /= 3;
        moved.y[k] /= 3;
      }
      expect_same(apply(DirectOperator(TangentialKernel::difference(steel, grid, step)), p), difference);
      expect_same(apply(DirectOperator(TangentialKernel::displacement(steel, grid, {step, 0}, 3)), p), moved);
    }
  }
}

TEST(DirectOperator, ThreadsDoNotChangeABit) {
  const ElementGrid grid{17, 13, 0, 0, 1e-3, 2e-3, false};
  const PlaneFields p = random_tractions(grid);
  const TangentialKernel kernel = TangentialKernel::difference(steel, grid, grid.dx);
  const PlaneFields one = apply(DirectOperator(kernel), p);
  for (const int threads : {2, 5, 20}) {
    const PlaneFields s = apply(DirectOperator(kernel, threads), p);
    EXPECT_EQ(s.x, one.x);
    EXPECT_EQ(s.y, one.y);
  }
  EXPECT_THROW(DirectOperator(kernel, 0), Error);
}

/// A row's sums may be put together from parts of other rows, for parts of the row.
TEST(DirectOperator, SlipAddsUpOverParts) {
  const ElementGrid grid{11, 4, 0, 0, 1e-3, 2e-3, false};
  const PlaneFields p = random_tractions(grid);
  const TangentialKernel kernel = TangentialKernel::difference(steel, grid, grid.dx);
  const PlaneFields whole = apply(DirectOperator(kernel), p);
  PlaneFields parts{Field(grid.count(), 0.0), Field(grid.count(), 0.0)};
  for (int to = 0; to < grid.my; ++to)
    for (const auto& [begin, end] : {std::pair{0, 4}, std::pair{4, 5}, std::pair{5, 11}})
      for (int from = 0; from < grid.my; ++from) {
        add_slip(kernel, {from, 0, 6}, p.x, p.y, {to, begin, end}, parts.x, parts.y);
        add_slip(kernel, {from, 6, 11}, p.x, p.y, {to, begin, end}, parts.x, parts.y);
      }
  EXPECT_EQ(parts.x, whole.x);
  EXPECT_EQ(parts.y, whole.y);
}

} // namespace
} // namespace microslip
