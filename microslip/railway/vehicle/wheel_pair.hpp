#pragma once

#include "microslip/railway/geometry/relative_motion.hpp"
#include "microslip/railway/vehicle/wheelset_on_track.hpp"

namespace microslip {

/// Derivatives of the forces on both wheels by the first numbers of a state, with none of them held.
struct WheelPairDerivatives {
  std::array<Vec3<double>, basic_motions> force, moment; ///< of both, about the wheelset's centre [N], [N m]
  std::array<double, basic_motions> difference{};        ///< of F_z of the left wheel less that of the right one [N]
};

/// The axis about which roll or yaw turns a wheelset; none for other numbers of its state.
Vec3<double> turning_axis(const WheelState<double>& state, std::size_t number);

/// Both wheels of a wheelset on their rails: the forces on them in a state, whatever the load.
class WheelPair {
public:
  /// Throws Error as WheelRail.
  WheelPair(const WheelRailBodies& left, const WheelRailBodies& right, const WheelRailMethod& method);

  void reset() { left_.reset(), right_.reset(); } ///< forgets the last state
  /// Finds the forces where the state puts the wheels, or with each by itself lowered until it carries its load.
  void solve(const WheelsetState& state, const std::optional<WheelLoads>& loads, WheelsetSolution& out,
             const Progress& progress);
  /// Solves with derivatives, where the state puts them. Those of unsolved quantities are zero.
  void differentiate(const WheelsetState& state, WheelsetSolution& out, WheelPairDerivatives& derivatives,
                     const Progress& progress);
  /// Adds up both wheels' forces and statuses.
  void sum(const WheelsetState& state, WheelsetSolution& out) const;

  double nominal_radius() const { return left_place_.nominal_radius; } ///< [m]
  double half_base() const { return left_place_.wheel.lateral; }       ///< from the centre to a wheel [m]

private:
  Vec3<double> left_lever(const WheelsetState& state) const;
  Vec3<double> right_lever(const WheelsetState& state) const;

  NominalPlacement left_place_, right_place_;
  WheelRail left_, right_;
  WheelRailDerivatives by_left_{}, by_right_{};
};

} // namespace microslip
