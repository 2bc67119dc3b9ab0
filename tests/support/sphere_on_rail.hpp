#pragma once

#include "microslip/railway/wheel_rail.hpp"
#include "tests/support/steel.hpp"
#include "tests/support/wheel_rail_pairs.hpp"

namespace microslip {

/// A sphere on a rail's head, an arc whose top is 0.7 m from the track's centre, with mu = 0.3.
inline WheelRailBodies sphere_on_rail(double radius, double head, double width = 0.03) {
  WheelRailBodies bodies{
      round_head(head, width), spherical_wheel(radius, 0.03), {}, {}, TrackSide::left, steel, {{0, 0.3}}};
  bodies.track.rail_origin = ProfilePoint{0.7, 0};
  bodies.wheelset = {
      .flange_back_distance = 1.4, .flange_back_position = 0, .nominal_radius = radius, .tape_circle = {}};
  return bodies;
}

} // namespace microslip
