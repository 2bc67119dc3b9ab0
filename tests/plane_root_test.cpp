// Two equations with two unknowns.

#include "microslip/numerics/plane_root.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace microslip {
namespace {

TEST(PlaneRoot, SmoothEquations) {
  const auto f = [](Vec2 v) -> Vec2 { return {v.x * v.x + v.y - 3, v.x - v.y * v.y + 1}; };
  const PlaneRoot root = find_plane_root(f, {1, 1}, {1, 1}, 1e-12);
  EXPECT_TRUE(root.found);
  EXPECT_LE(root.size, 1e-12);
  EXPECT_NEAR(root.at.x * root.at.x + root.at.y, 3, 1e-11);
}

/// The unknowns' scales may differ by many orders.
TEST(PlaneRoot, UnknownsOfUnequalSize) {
  const auto f = [](Vec2 v) -> Vec2 { return {std::atan(v.x / 1e-9) - 1.2, v.y / 1e6 + std::tanh(v.x / 1e-9)}; };
  const PlaneRoot root = find_plane_root(f, {}, {1e-9, 1e6}, 1e-10);
  EXPECT_TRUE(root.found);
  EXPECT_NEAR(root.at.x / 1e-9, std::tan(1.2), 1e-7);
}

/// Like a force that friction limits, where Newton's first step leads beyond the limit.
TEST(PlaneRoot, DoesNotStayOnAPlateau) {
  const auto force = [](double v) { return std::clamp(v - v * std::abs(v) / 4, -1.0, 1.0); };
  const auto limited = [&](double v) { return std::abs(v) < 2 ? force(v) : std::copysign(1.0, v); };
  for (const double wanted : {0.5, 0.9, 0.99, 0.999}) {
    const auto f = [&](Vec2 v) -> Vec2 { return {limited(v.x) - wanted, v.y}; };
    const PlaneRoot root = find_plane_root(f, {}, {1, 1}, 1e-10);
    EXPECT_TRUE(root.found) << wanted;
    EXPECT_NEAR(root.at.x, 2 * (1 - std::sqrt(1 - wanted)), 1e-7);
  }
}

TEST(PlaneRoot, SaysWhereThereIsNone) {
  const auto f = [](Vec2 v) -> Vec2 { return {v.x * v.x + 1, v.y}; };
  const PlaneRoot root = find_plane_root(f, {1, 0}, {1, 1}, 1e-10);
  EXPECT_FALSE(root.found);
  EXPECT_GT(root.size, 0.9);
  const auto nowhere = [](Vec2) -> Vec2 { return {std::nan(""), 0}; };
  EXPECT_FALSE(find_plane_root(nowhere, {}, {1, 1}, 1e-10).found);
}

} // namespace
} // namespace microslip
