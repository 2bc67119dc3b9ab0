#include "microslip/elasticity/half_strips.hpp"
#include "microslip/elasticity/influence.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Where rectangles of the length 1 end: some regular ones around 0, and some of other lengths.
std::vector<double> ends() {
  std::vector<double> x;
  for (int i = -9; i <= 12; ++i) x.push_back(i - 0.5);
  for (const double other : {12.0, 13.7, 13.9, 20.0}) x.push_back(other);
  return x;
}

/// A rectangle's integrals, from those of the half strips that end at its sides.
KernelIntegrals between(const HalfStrips::Row& row, std::size_t k) {
  KernelIntegrals i;
  i.xx = row.xx[k + 1] - row.xx[k];
  i.yy = row.yy[k + 1] - row.yy[k];
  i.xy = row.xy[k + 1] - row.xy[k];
  return i;
}

/// The largest difference of the tangential and normal influence, over that of an element on itself.
double error(const Influence& a, const Influence& b, const Influence& own) {
  return std::max({std::abs(a.xx - b.xx), std::abs(a.xy - b.xy), std::abs(a.yy - b.yy), std::abs(a.zz - b.zz)}) /
         std::min(own.xx, own.zz);
}

TEST(HalfStrips, TheirDifferencesAreTheInfluenceOfRectanglesForAllMaterials) {
  const std::vector<double> x = ends();
  for (const double dy : {0.05, 0.3, 1.0, 4.0, 20.0}) {
    HalfStrips strips(x, dy);
    for (int row = 0; row < 25; ++row) {
      const HalfStrips::Row here = strips.at(row);
      for (const double nu : {0.0, 0.28, 0.5}) {
        const CombinedMaterial material{3, nu, 0};
        for (std::size_t k = 0; k + 1 < x.size(); ++k) {
          const double width = x[k + 1] - x[k], middle = (x[k + 1] + x[k]) / 2;
          const Influence direct = influence(material, width, dy, middle, row * dy);
          EXPECT_LT(error(influence_of(material, between(here, k)), direct, influence(material, 1, dy, 0, 0)), 1e-12)
              << "dy = " << dy << ", row " << row << ", x = " << middle;
        }
      }
    }
  }
}

TEST(HalfStrips, HaveTheSameBitsForEveryInstructionSet) {
  const std::vector<double> x = ends();
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
    if (!is_available(set)) continue;
    HalfStrips baseline(x, 0.3, InstructionSet::baseline), strips(x, 0.3, set);
    for (int row = 0; row < 5; ++row) {
      const HalfStrips::Row here = strips.at(row), wanted = baseline.at(row);
      for (const auto& [found, expected] : {std::pair{here.xx, wanted.xx}, {here.yy, wanted.yy}, {here.xy, wanted.xy}})
        EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin())) << "row " << row;
    }
  }
}

TEST(HalfStrips, EndlessOnesAreThoseOfLineContacts) {
  const std::vector<double> x = ends();
  const CombinedMaterial material{3, 0.28, 0};
  constexpr double far = 30;
  HalfStrips strips = HalfStrips::endless(x, far);
  const HalfStrips::Row row = strips.at(0);
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    const Influence direct = line_influence(material, x[k + 1] - x[k], (x[k + 1] + x[k]) / 2, far);
    EXPECT_LT(error(influence_of(material, between(row, k)), direct, line_influence(material, 1, 0, far)), 1e-14);
  }
}

/// Lengths scale out: an integral of a rectangle is a length.
TEST(HalfStrips, ScaleWithTheUnitOfLength) {
  std::vector<double> x = ends();
  HalfStrips one(x, 0.7);
  for (double& place : x) place *= 4;
  HalfStrips four(x, 4 * 0.7);
  for (int row = 0; row < 5; ++row) {
    const HalfStrips::Row a = one.at(row), b = four.at(row);
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
      EXPECT_NEAR(between(b, k).xx, 4 * between(a, k).xx, 1e-12);
      EXPECT_NEAR(between(b, k).yy, 4 * between(a, k).yy, 1e-12);
      EXPECT_EQ(between(b, k).xy, 4 * between(a, k).xy);
    }
  }
}

TEST(HalfStrips, RowsInAnyOrder) {
  const std::vector<double> x = ends();
  HalfStrips in_turn(x, 0.6), leaping(x, 0.6);
  std::vector<std::vector<double>> rows;
  for (int row = 0; row < 6; ++row) {
    const HalfStrips::Row here = in_turn.at(row);
    rows.emplace_back(here.yy.begin(), here.yy.end());
  }
  for (const int row : {3, 0, 5, 5, 1, 2}) {
    const HalfStrips::Row here = leaping.at(row);
    EXPECT_TRUE(std::equal(here.yy.begin(), here.yy.end(), rows[static_cast<std::size_t>(row)].begin())) << row;
  }
}

} // namespace
} // namespace microslip
