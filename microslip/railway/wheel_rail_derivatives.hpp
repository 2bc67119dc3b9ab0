#pragma once

#include "microslip/railway/geometry/wheel_placement.hpp"
#include "microslip/railway/wheel_rail.hpp"

#include <functional>

namespace microslip {

/// Force and moment of all patches on a wheel, and the wheelset's height.
struct Wrench {
  Vec3<double> force, moment; ///< [N], [N m]
  double height = 0;          ///< [m]

  static Wrench of(const WheelRailSolution& s) { return {s.force, s.moment, s.vertical}; }
  friend Wrench operator+(const Wrench& a, const Wrench& b) {
    return {a.force + b.force, a.moment + b.moment, a.height + b.height};
  }
  friend Wrench operator-(const Wrench& a, const Wrench& b) { return a + -1 * b; }
  friend Wrench operator*(double f, const Wrench& a) { return {f * a.force, f * a.moment, f * a.height}; }
};

/// Forces on a left wheel in states near the one that is differentiated.
struct NearbyForces {
  /// Forces of its rows, in the state's height.
  std::function<Wrench(const WheelState<double>& state)> of_rows;
  /// Forces of rows in a state next to the last one of these.
  std::function<Wrench(const WheelState<double>& state)> of_shifted_rows;
  /// Forces of rows in a state that differs from it in velocities alone.
  std::function<Wrench(const WheelState<double>& state)> of_moving_rows;
  /// Forces of the elements of its patches, in the state's height or with a vertical force [N]; none if the rows'
  /// forces are the solution's.
  std::function<Wrench(const WheelState<double>& state, std::optional<double> vertical_force)> of_elements;
};

/// Finds the derivatives of a left wheel's solution in a state by differences: forward ones of rows, central ones of
/// elements; those by numbers beyond the first ten follow by relative_motions(). Where surfaces vary the equivalent
/// rail is found anew at each step, to fewer digits, and position along the track and pitch have derivatives, too.
void differentiate(const NearbyForces& forces, const NominalPlacement& nominal, bool surfaces_vary,
                   const WheelState<double>& state, std::optional<double> vertical_force,
                   const WheelRailSolution& found, WheelRailDerivatives& derivatives);

} // namespace microslip
