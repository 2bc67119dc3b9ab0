#pragma once

#include "microslip/railway/geometry/frame.hpp"

#include <array>
#include <cstddef>

namespace microslip {

/// Small motion of a wheel against its axle, in the wheelset's axes at the wheel's centre: [m], [rad], [m/s], [rad/s].
template <class T> struct WheelDeflection {
  T longitudinal{}, lateral{}, vertical{};
  T roll{}, yaw{}; ///< right-handed about x and z
  T longitudinal_velocity{}, lateral_velocity{}, vertical_velocity{};
  T roll_velocity{}, pitch_velocity{}, yaw_velocity{};
};

/// A rail off its nominal position, in track axes: [m], [rad], [m/s], [rad/s]; turned about its profile's origin.
template <class T> struct RailDeviation {
  T lateral{}, vertical{};
  T roll{}; ///< right-handed about x
  T lateral_velocity{}, vertical_velocity{}, roll_velocity{};
};

/// Number of numbers of a state.
inline constexpr std::size_t state_numbers = 30;
/// Indices of the numbers that matter only where surfaces vary along the track or around the wheel, or on rollers.
inline constexpr std::size_t longitudinal_number = 28, pitch_number = 29;

/// Position and motion of a wheelset on the track, with all that concerns one of its wheels. Track axes: x forward,
/// y to the left, z up, moving along the track with the wheelset. Angles are right-handed: roll > 0 raises the left
/// wheel, yaw > 0 turns to the left. The wheelset's axes are those of the track turned first by yaw, then by roll: R =
/// Rx(roll) Rz(yaw). Lengths in m, angles in rad, velocities in m/s and rad/s. T is double or a dual number.
template <class T> struct WheelState {
  T lateral{};  ///< of the wheelset's centre
  T vertical{}; ///< of the wheelset's centre above the nominal radius
  T roll{}, yaw{};
  T forward_velocity{}, lateral_velocity{}, vertical_velocity{}; ///< of the wheelset's centre, in track axes
  T roll_velocity{}, pitch_velocity{}, yaw_velocity{};           ///< in the wheelset's axes; pitch > 0 rolls forward
  T curvature{};                                                 ///< of the track [1/m], > 0 in a curve to the left
  WheelDeflection<T> deflection;
  RailDeviation<T> rail;
  T longitudinal{}; ///< of the wheelset's centre: along the track, where slices of a rail count from; from a roller's
                    ///< top
  T pitch{};        ///< of the wheelset, > 0 turned as it rolls forward: where slices of a wheel count from

  /// All of them in the order in which they stand here, that of state_quantities() (wheel_rail_quantities.hpp).
  std::array<T*, state_numbers> numbers();
  /// State seen in a mirror whose plane is x, z: turns a right wheel into a left one and back. Numbers that are odd
  /// (state_quantities()) change their sign. Of doubles only.
  WheelState mirrored() const;
};

/// Position and motion of a wheelset, with all that concerns both wheels.
struct WheelsetState {
  WheelState<double> left; ///< the wheelset's, with what concerns the left wheel alone
  WheelDeflection<double> right_deflection;
  RailDeviation<double> right_rail;

  /// The wheelset's state with what concerns the right wheel.
  WheelState<double> right() const {
    WheelState<double> state = left;
    state.deflection = right_deflection, state.rail = right_rail;
    return state;
  }
};

template <class T> std::array<T*, state_numbers> WheelState<T>::numbers() {
  WheelDeflection<T>& d = deflection;
  RailDeviation<T>& r = rail;
  return {&lateral,
          &vertical,
          &roll,
          &yaw,
          &forward_velocity,
          &lateral_velocity,
          &vertical_velocity,
          &roll_velocity,
          &pitch_velocity,
          &yaw_velocity,
          &curvature,
          &d.longitudinal,
          &d.lateral,
          &d.vertical,
          &d.roll,
          &d.yaw,
          &d.longitudinal_velocity,
          &d.lateral_velocity,
          &d.vertical_velocity,
          &d.roll_velocity,
          &d.pitch_velocity,
          &d.yaw_velocity,
          &r.lateral,
          &r.vertical,
          &r.roll,
          &r.lateral_velocity,
          &r.vertical_velocity,
          &r.roll_velocity,
          &longitudinal,
          &pitch};
}

template <> WheelState<double> WheelState<double>::mirrored() const;

} // namespace microslip
