#pragma once

#include "microslip/railway/vehicle/wheelset_on_track.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace microslip {

/// A number of a wheelset's state. What concerns one wheel alone, deflections and its rail's deviations, has the names
/// of WheelState's numbers behind "left_" or "right_".
struct WheelsetStateQuantity {
  std::string name;              ///< in every interface
  const StateQuantity* of_wheel; ///< the number of a wheel's state: section, unit, limit, description
  bool of_right = false;         ///< of what concerns the right wheel alone

  double value(const WheelsetState& state) const;
  void set(WheelsetState& state, double value) const;
};

/// The forces that interfaces may prescribe, by name.
struct PrescribedWheelsetForces {
  std::optional<double> vertical_force, roll_moment, vertical_force_left, vertical_force_right, axle_torque;

  PrescribedWheelsetForces() = default;
  explicit PrescribedWheelsetForces(const WheelsetLoad& load);
  /// Throws Error for those that cannot be combined: both wheels' forces, or vertical_force with roll_moment, by
  /// default 0; or none.
  WheelsetLoad load() const;
};
struct PrescribedForce {
  std::string_view name, unit;
  double low, high; ///< what makes sense
  std::string_view description;
  std::optional<double> PrescribedWheelsetForces::*of;
};

using WheelsetQuantity = RailwayQuantity<WheelsetSolution>;

/// All of them in the order in which they are shown.
std::span<const WheelsetStateQuantity> wheelset_state_quantities();
std::span<const PrescribedForce> prescribed_forces();
std::span<const WheelsetQuantity> wheelset_quantities();

} // namespace microslip
