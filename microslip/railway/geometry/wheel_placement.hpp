#pragma once

#include "microslip/railway/geometry/track.hpp"
#include "microslip/railway/geometry/wheel_state.hpp"
#include "microslip/railway/geometry/wheelset.hpp"

namespace microslip {

/// The left wheel and the left rail in their nominal positions: what the state does not change.
struct NominalPlacement {
  Frame<double> rail;
  WheelPlace wheel;
  double nominal_radius = 0; ///< [m], height of the wheelset's centre above the tops of the rails
  double roller_radius = 0;  ///< [m], that of Track
};

/// Throws Error as place_rail and place_wheel.
inline NominalPlacement nominal_placement(const Track& track, const Profile& rail, const Wheelset& wheelset,
                                          const Profile& wheel) {
  return {place_rail(track, rail), place_wheel(wheelset, wheel), wheelset.nominal_radius, track.roller_radius};
}

/// A left wheel on its rail, in track axes. The rail's frame has the axes of its profile. The wheel's has its origin on
/// the axle at y = 0 of the profile, y along the axle, z up at yaw and roll 0; it does not turn with the wheel, while
/// its angular velocity does.
template <class T> struct WheelPlacement {
  MovingFrame<T> rail, wheel;
  double radius = 0;        ///< of the wheel where its profile's z = 0 [m]
  double roller_radius = 0; ///< of the rail likewise; 0: prismatic
  double longitudinal = 0;  ///< along the track, of x = 0 [m]
  double pitch = 0;         ///< of the wheel, from where its slices count [rad]

  /// The point of the rail's surface at (y, z) of its profile, in the section x of the rail's axes.
  Vec3<T> rail_point(const T& x, const T& y, const T& z) const { return rail.frame.outer({x, y, z}); }
  /// The point of the wheel's surface at (y, z) of its profile and at the angle tau [rad] from the wheel's lowest line,
  /// tau > 0 ahead of it: origin + R (rho sin tau, y, -rho cos tau), rho = radius - z.
  Vec3<T> wheel_point(const T& tau, const T& y, const T& z) const {
    using std::cos, std::sin;
    const T rho = T(radius) - z;
    return wheel.frame.outer({rho * sin(tau), y, -(rho * cos(tau))});
  }
};

/// The left wheel in the state given, of a right wheel in its mirror image (WheelState::mirrored). In a curve the axes
/// turn with the track, and so the rail turns against them. A roller has the forward velocity at its nominal radius,
/// seen from axes that move forward with that; its axle stays where it is, along y, in deviations too. Cost some 100
/// operations.
template <class T> WheelPlacement<T> place(const NominalPlacement& nominal, const WheelState<T>& state) {
  const WheelDeflection<T>& flex = state.deflection;
  const RailDeviation<T>& deviation = state.rail;
  WheelPlacement<T> placed;
  placed.radius = nominal.wheel.radius;
  placed.roller_radius = nominal.roller_radius;
  placed.pitch = value_of(state.pitch);
  const bool on_roller = nominal.roller_radius != 0;
  if (!on_roller) placed.longitudinal = value_of(state.longitudinal);

  const auto& [origin, axes] = nominal.rail;
  const auto vector = [](const Vec3<double>& v) { return Vec3<T>{T(v.x), T(v.y), T(v.z)}; };
  Frame<T>& rail = placed.rail.frame;
  rail.origin = vector(origin) + Vec3<T>{T(0), deviation.lateral, deviation.vertical};
  rail.axes = rotation_about_x(deviation.roll) * Rotation<T>{vector(axes.ex), vector(axes.ey), vector(axes.ez)};
  const T turning = state.forward_velocity * state.curvature;
  placed.rail.angular_velocity = {deviation.roll_velocity, T(0), -turning};
  placed.rail.velocity = {turning * rail.origin.y, deviation.lateral_velocity, deviation.vertical_velocity};
  if (on_roller) {
    const T spin = -(state.forward_velocity / T(nominal.roller_radius));
    placed.rail.angular_velocity.y = spin;
    placed.rail.velocity.x = placed.rail.velocity.x + spin * rail.origin.z;
  }

  const Frame<T> wheelset{
      {on_roller ? state.longitudinal : T(0), state.lateral, T(nominal.nominal_radius) + state.vertical},
      rotation_about_x(state.roll) * rotation_about_z(state.yaw)};
  // The wheelset's axes do not turn with the pitch, so neither does a deflection of the wheel's centre.
  const Vec3<T> turn = wheelset.axes * Vec3<T>{state.roll_velocity, T(0), state.yaw_velocity};
  MovingFrame<T>& wheel = placed.wheel;
  wheel.frame = wheelset * Frame<T>{{flex.longitudinal, T(nominal.wheel.lateral) + flex.lateral, flex.vertical},
                                    rotation_about_x(flex.roll) * rotation_about_z(flex.yaw)};
  wheel.velocity = Vec3<T>{state.forward_velocity, state.lateral_velocity, state.vertical_velocity} +
                   cross(turn, wheel.frame.origin - wheelset.origin) +
                   wheelset.axes * Vec3<T>{flex.longitudinal_velocity, flex.lateral_velocity, flex.vertical_velocity};
  wheel.angular_velocity =
      turn + wheelset.axes * Vec3<T>{flex.roll_velocity, state.pitch_velocity + flex.pitch_velocity, flex.yaw_velocity};
  return placed;
}

} // namespace microslip
