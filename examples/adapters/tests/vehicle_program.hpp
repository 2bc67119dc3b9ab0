// A vehicle program in small: markers with pose and motion, and the utilities by which subroutines ask for them, as
// Adams and MotionSolve have them.
#pragma once

#include "microslip/railway/geometry/frame.hpp"
#include "microslip/railway/geometry/wheel_state.hpp"

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace microslip::adapters {

/// A marker in the axes of the ground: [m], [m/s], [rad/s].
struct Marker {
  Vec3<double> position = {};
  Rotation<double> axes = {};
  Vec3<double> velocity = {}, angular_velocity = {};
};

/// What the utilities see and tell; each thread has its own, as each subroutine call has.
struct Program {
  std::map<int, Marker> markers;
  double length = 1;               ///< the model's unit of length [m]
  std::vector<std::string> asked;  ///< of c_sysary, with its markers
  std::vector<std::string> errors; ///< of c_errmes
};
Program& program();

/// The marker in the middle of a wheelset's axle in a state, rolled by an angle about it; in the axes of the track.
inline Marker wheelset_marker(const WheelState<double>& state, double radius, double rolled = 0) {
  const Rotation<double> axes = rotation_about_x(state.roll) * rotation_about_z(state.yaw);
  const Rotation<double> rolling = {
      {std::cos(rolled), 0, -std::sin(rolled)}, {0, 1, 0}, {std::sin(rolled), 0, std::cos(rolled)}};
  return {{state.longitudinal, state.lateral, radius + state.vertical},
          axes * rolling,
          {state.forward_velocity, state.lateral_velocity, state.vertical_velocity},
          axes * Vec3<double>{state.roll_velocity, state.pitch_velocity, state.yaw_velocity}};
}

/// A marker that is given in the axes of another one, which stands still, in those of the ground.
inline Marker placed(const Marker& track, const Marker& inner) {
  return {track.position + track.axes * inner.position, track.axes * inner.axes, track.axes * inner.velocity,
          track.axes * inner.angular_velocity};
}

} // namespace microslip::adapters
