#pragma once

#include "microslip/railway/wheel_rail.hpp"
#include "tests/support/steel.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

namespace microslip {

/// S1002 on 60E1, canted 1:40, with mu = 0.3.
inline WheelRailBodies s1002_on_60e1(TrackSide side = TrackSide::left) {
  static const Profile rail = example_profile("60e1.prr"), wheel = example_profile("s1002.prw");
  return {rail, wheel, {.rail_origin = {}, .cant = 1.0 / 40}, {}, side, steel, {{0, 0.3}}};
}

/// A wheel of 0.46 m that runs with a creepage.
inline WheelState<double> running(double lateral, double yaw = 0, double creepage = 0, double speed = 20) {
  WheelState<double> s;
  s.lateral = lateral, s.yaw = yaw;
  s.forward_velocity = speed, s.pitch_velocity = speed / 0.46 * (1 + creepage);
  return s;
}

} // namespace microslip
