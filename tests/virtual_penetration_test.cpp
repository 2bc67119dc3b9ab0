#include "microslip/railway/rows/virtual_penetration.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "tests/support/s1002_on_60e1.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace microslip {
namespace {

const double modulus = steel.contact_modulus();

/// A wheel near its rail, lowered to depths below its first touch.
class Lowered {
public:
  Lowered(const WheelRailBodies& bodies, double lateral)
      : nominal_(nominal_placement(bodies.track, bodies.rail, bodies.wheelset, bodies.wheel)),
        search_(bodies.rail, bodies.wheel), penetration_(bodies.rail, bodies.wheel, 8) {
    state_.lateral = lateral;
    const auto points = search_.find(place(nominal_, state_), 1e-3);
    touch_ = *std::min_element(points.begin(), points.end(),
                               [](const ContactPoint& a, const ContactPoint& b) { return a.gap < b.gap; });
    penetration_.start();
  }

  const VirtualPenetration& at(double depth) {
    WheelState<double> there = state_;
    there.vertical = -touch_.gap - depth;
    penetration_.sample(place(nominal_, there), search_.regions(touch_.gap + depth), depth);
    return penetration_;
  }
  const ContactPoint& touch() const { return touch_; }

private:
  NominalPlacement nominal_;
  ContactSearch search_;
  VirtualPenetration penetration_;
  WheelState<double> state_;
  ContactPoint touch_;
};

TEST(VirtualPenetration, HasHertzsDepthOnRoundHeads) {
  for (const double head : {0.08, 0.3, 1.0}) {
    const WheelRailBodies bodies{
        round_head(head), spherical_wheel(0.46), {.rail_origin = ProfilePoint{0.75, 0}}, {}, TrackSide::left, steel,
        {{0, 0.3}}};
    Lowered wheel(bodies, 0);
    const ContactPoint& touch = wheel.touch();
    for (const double load : {5e3, 80e3}) {
      const HertzContact hertz = hertz_from_load({1 / (2 * touch.radius), touch.curvature / 2}, steel, load);
      const double depth = wheel.at(1.3 * hertz.approach).depth_for(load, modulus, 0.46);
      EXPECT_NEAR(depth, hertz.approach, 0.05 * hertz.approach) << head << ' ' << load;
    }
  }
}

TEST(VirtualPenetration, DepthsOfLobedContactsAreNearThoseOfTheRows) {
  const WheelRailBodies bodies = s1002_on_60e1();
  WheelRail contact(bodies, {});
  for (const double lateral : {-3e-3, 0.0, 2e-3, 4e-3}) {
    Lowered wheel(bodies, lateral);
    const WheelRailSolution found = contact.solve(running(lateral), 80e3);
    const double wanted = -found.vertical - wheel.touch().gap;
    EXPECT_NEAR(wheel.at(1.3 * wanted).depth_for(80e3, modulus, 0.46), wanted, 0.2 * wanted) << lateral;
  }
}

TEST(VirtualPenetration, IsTheSameAtADepthAfterAnotherOne) {
  const WheelRailBodies bodies = s1002_on_60e1();
  Lowered once(bodies, 1e-3), again(bodies, 1e-3);
  again.at(1.5e-4);
  const auto wanted = once.at(9e-5).samples(), found = again.at(9e-5).samples();
  ASSERT_EQ(wanted.size(), found.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    EXPECT_NEAR(found[k].overlap, wanted[k].overlap, 1e-11);
    EXPECT_NEAR(found[k].s, wanted[k].s, 1e-14);
  }
}

} // namespace
} // namespace microslip
