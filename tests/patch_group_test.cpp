#include "microslip/railway/exact/patch_group.hpp"

#include "microslip/railway/geometry/contact_search.hpp"

#include "tests/support/wheel_rail_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace microslip {
namespace {

/// A round wheel in a rail's groove whose bottom is a little rounder, 0.1 mm deep in it: one wide region.
struct Groove {
  Profile rail = profile_of(ProfileRole::rail, -0.03, 0.03, 601, [](double y) { return 8 * y * y * y * y; });
  Profile wheel = profile_of(ProfileRole::wheel, -0.03, 0.03, 601, [](double y) { return 2 * y * y + 0.02 * y; });
  WheelPlacement<double> placement{};
  ContactSearch search{rail, wheel};
  ContactRegion whole;

  Groove() {
    placement.radius = 0.46;
    placement.wheel.frame.origin = {0, 0, 0.46 - 1e-4};
    search.find(placement, 1e-3);
    whole = search.regions(0).front();
  }

  PatchOutline outline(const ContactRegion& region, PatchShape surface) const {
    return find_outline(placement, rail, wheel, region, surface);
  }

  /// The position of the region's border at a share of the wheel's parameter between its ends.
  ContactRegion::End between(double share) const {
    ContactRegion::End end;
    end.s_wheel = whole.inner.s_wheel + share * (whole.outer.s_wheel - whole.inner.s_wheel);
    end.s_rail = whole.inner.s_rail + share * (whole.outer.s_rail - whole.inner.s_rail);
    return end;
  }

  /// The region's parts before `low` and after `high`.
  std::vector<PatchOutline> parts(double low, double high, PatchShape surface) const {
    ContactRegion first = whole, second = whole;
    first.outer = between(low), second.inner = between(high);
    return {outline(first, surface), outline(second, surface)};
  }
};

TEST(PatchGroup, HasTheFrameOfOneRegionWhereTwoTouch) {
  const Groove groove;
  for (const PatchShape surface : {PatchShape::flat, PatchShape::curved}) {
    const PatchOutline whole = groove.outline(groove.whole, surface);
    for (const double cut : {0.2, 0.5, 0.7}) {
      const auto groups =
          group_patches(groove.placement, groove.rail, groove.wheel, groove.parts(cut, cut, surface), surface, 1e-4);
      ASSERT_EQ(groups.size(), 1U);
      const PatchOutline& joined = groups[0].outline;
      const double length = whole.s_high - whole.s_low;
      EXPECT_NEAR(joined.weight, whole.weight, 1e-3 * whole.weight);
      EXPECT_NEAR(joined.frame.origin.y, whole.frame.origin.y, 1e-3 * length);
      EXPECT_NEAR(joined.frame.angle, whole.frame.angle, 1e-5);
      EXPECT_NEAR(joined.wheel_s, whole.wheel_s, 1e-3 * length);
      EXPECT_NEAR(joined.s_low, whole.s_low, 1e-3 * length);
      EXPECT_NEAR(joined.s_high, whole.s_high, 1e-3 * length);
      EXPECT_NEAR(joined.turn, whole.turn, 0.1 * whole.turn);
    }
  }
}

/// A wheel in the throat of a rail whose surface turns by 60 degrees along the region.
TEST(PatchGroup, ReachesToTheEndsOfItsRegionsAlongTheirSurface) {
  const auto round = [](double radius) {
    return [radius](double y) { return radius - std::sqrt(radius * radius - y * y); };
  };
  const Profile rail = profile_of(ProfileRole::rail, -0.018, 0.018, 601, round(0.02));
  const Profile wheel = profile_of(ProfileRole::wheel, -0.018, 0.018, 601, round(0.0199));
  WheelPlacement<double> placement{};
  placement.radius = 0.46;
  placement.wheel.frame.origin = {0, 0, 0.46 - 1e-4};
  ContactSearch search{rail, wheel};
  search.find(placement, 1e-3);
  const ContactRegion whole = search.regions(0).front();
  ASSERT_GT(whole.outer.s_rail - whole.inner.s_rail, 0.021);
  ContactRegion first = whole, second = whole;
  first.outer.s_wheel = whole.inner.s_wheel + 1e-3, first.outer.s_rail = whole.inner.s_rail + 1e-3;
  second.inner.s_wheel = whole.outer.s_wheel - 5e-3, second.inner.s_rail = whole.outer.s_rail - 5e-3;
  for (const PatchShape surface : {PatchShape::flat, PatchShape::curved}) {
    const std::vector<PatchOutline> parts = {find_outline(placement, rail, wheel, first, surface),
                                             find_outline(placement, rail, wheel, second, surface)};
    const PatchOutline out = joined(placement, rail, parts, std::vector{0.7, 1.0}, surface);
    const PatchSurface rows(rail, wheel, placement);
    for (const auto& [s, rail_s] : {std::pair{out.s_low, second.inner.s_rail}, {out.s_high, second.outer.s_rail}})
      EXPECT_NEAR(rows.row(out.frame, surface, s, rows.first_row(out.frame, out.wheel_s)).rail_s, rail_s, 1e-9);
  }
}

/// Two lobes of a wheel over a convex rail, 20 mm apart.
struct Lobes {
  Profile rail = profile_of(ProfileRole::rail, -0.03, 0.03, 601, [](double y) { return -0.1 * y * y; });
  Profile wheel = profile_of(ProfileRole::wheel, -0.03, 0.03, 601,
                             [](double y) { return 2000 * std::pow(y * y - 1e-4, 2) + 1e-4 * y; });
  WheelPlacement<double> placement{};
  ContactSearch search{rail, wheel};

  std::vector<PatchOutline> patches(double height) {
    placement.radius = 0.46;
    placement.wheel.frame.origin = {0, 0, 0.46 + height};
    search.find(placement, 1e-3);
    std::vector<PatchOutline> all;
    for (const ContactRegion& region : search.regions(0))
      all.push_back(find_outline(placement, rail, wheel, region, PatchShape::curved));
    return all;
  }
};

TEST(PatchGroup, DrawsFramesTogetherBeforeRegionsBecomeOne) {
  Lobes lobes;
  constexpr double depth = 4e-5, step = 2e-8; // [m]
  std::vector<double> ways;                   // between the frames, while the wheel is lowered
  bool apart = false, one_group = false, one_region = false;
  for (double height = 2e-5; height > -1e-4 && !one_region; height -= step) {
    const auto patches = lobes.patches(height);
    if (patches.size() < 2 && ways.empty()) continue;
    const auto groups = group_patches(lobes.placement, lobes.rail, lobes.wheel, patches, PatchShape::curved, depth);
    ASSERT_LE(groups.size(), 2U);
    ways.push_back(groups.back().outline.frame.origin.y - groups.front().outline.frame.origin.y);
    if (groups.size() == 2 && groups[0].shares[1] == 0) {
      apart = true;
      EXPECT_DOUBLE_EQ(groups[0].outline.frame.angle, patches[0].frame.angle);
    }
    one_group = one_group || (patches.size() == 2 && groups.size() == 1);
    one_region = patches.size() == 1;
  }
  EXPECT_TRUE(apart);
  EXPECT_TRUE(one_group);
  EXPECT_TRUE(one_region);
  EXPECT_GT(ways.front(), 0.01);
  EXPECT_EQ(ways.back(), 0);
  for (std::size_t k = 1; k < ways.size(); ++k) EXPECT_LT(std::abs(ways[k] - ways[k - 1]), 0.01 * ways.front());
}

} // namespace
} // namespace microslip
