// CONTACT's rules by which regions of overlap become patches.

#include "compat/contact/wheel_rail/patch_rules.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

/// Regions of 2 mm across, all at the same height, with centres at these y.
std::vector<GapRegion> regions_at(const std::vector<double>& centres) {
  std::vector<GapRegion> regions;
  for (const double y : centres) {
    GapRegion r;
    r.x0 = -1, r.x1 = 1;
    r.y0 = y - 1, r.y1 = y + 1;
    r.y = y;
    r.angle = 0.01 * y;
    r.weight = 1;
    regions.push_back(r);
  }
  return regions;
}

PatchRules rules() {
  PatchRules d;
  d.a_sep = 1.5;
  d.d_sep = 8;
  d.d_comb = 4;
  d.d_turn = 12;
  return d;
}

TEST(ContactPatchRules, NearRegionsAreOne) {
  const auto patches = make_patches(regions_at({0, 5}), rules());
  ASSERT_EQ(patches.size(), 1u);
  EXPECT_EQ(patches[0].parts.size(), 1u);
  EXPECT_EQ(patches[0].whole.y0, -1);
  EXPECT_EQ(patches[0].whole.y1, 6);
  EXPECT_DOUBLE_EQ(patches[0].whole.y, 2.5);
  EXPECT_DOUBLE_EQ(patches[0].whole.weight, 2);
}

TEST(ContactPatchRules, FurtherApartTheyActLessOnEachOther) {
  const auto patches = make_patches(regions_at({0, 8}), rules()); // 6 mm apart
  ASSERT_EQ(patches.size(), 1u);
  ASSERT_EQ(patches[0].parts.size(), 2u);
  EXPECT_EQ(patches[0].parts[0].y, 8) << "from the field side on";
  EXPECT_EQ(patches[0].factors[0], 1);
  EXPECT_DOUBLE_EQ(patches[0].factors[1], std::pow(0.5, 0.8));
}

TEST(ContactPatchRules, PartsThatAreFarApartDoNotActOnEachOther) {
  const auto patches = make_patches(regions_at({0, 8, 16}), rules());
  ASSERT_EQ(patches.size(), 1u);
  EXPECT_EQ(patches[0].factors[2], 0);
  EXPECT_GT(patches[0].factors[1], 0);
}

/// Two of 2 x 2 mm at nearly the same y, one of them 3 mm behind the other along the track.
std::vector<GapRegion> one_behind_the_other() {
  auto regions = regions_at({0, 0.1});
  regions[1].x0 = 4, regions[1].x1 = 6;
  return regions;
}

TEST(ContactPatchRules, OfRegionsAtTheSameYOnlyTheDistanceAlongTheTrackCounts) {
  PatchRules d = rules();
  d.d_comb = 3.01;
  const auto patches = make_patches(one_behind_the_other(), d);
  ASSERT_EQ(patches.size(), 1u);
  EXPECT_EQ(patches[0].parts.size(), 1u);
  d.d_comb = 1, d.d_sep = 2.99;
  EXPECT_EQ(make_patches(one_behind_the_other(), d).size(), 2u);
}

/// No line along the track separates them.
TEST(ContactPatchRules, RegionsAtTheSameYAreNoSeparateParts) {
  PatchRules d = rules();
  d.d_comb = 1;
  auto regions = one_behind_the_other();
  regions.push_back(regions_at({5}).front()); // beside both
  const auto patches = make_patches(regions, d);
  ASSERT_EQ(patches.size(), 1u);
  ASSERT_EQ(patches[0].parts.size(), 2u);
  EXPECT_EQ(patches[0].parts[1].x0, -1);
  EXPECT_EQ(patches[0].parts[1].x1, 6);
  EXPECT_EQ(patches[0].whole.y1, 6);
}

TEST(ContactPatchRules, FramesTurnBeforePatchesJoin) {
  const auto patches = make_patches(regions_at({0, 12}), rules()); // 10 mm apart, halfway from 8 to 12
  ASSERT_EQ(patches.size(), 2u);
  EXPECT_DOUBLE_EQ(patches[0].whole.angle, 0.12 + 0.5 * (0.06 - 0.12));
  EXPECT_DOUBLE_EQ(patches[1].whole.angle, 0.5 * 0.06);
  const auto apart = make_patches(regions_at({0, 20}), rules());
  EXPECT_DOUBLE_EQ(apart[0].whole.angle, 0.2);
}

TEST(ContactPatchRules, RegionsOfOtherAnglesStayApart) {
  PatchRules d = rules();
  d.a_sep = 0.04;
  EXPECT_EQ(make_patches(regions_at({0, 5}), d).size(), 2u);
  EXPECT_EQ(make_patches(regions_at({0, 3.5}), d).size(), 1u);
}

} // namespace
} // namespace microslip::contact_program
