#pragma once

#include "microslip/railway/wheel_rail.hpp"
#include "microslip/railway/wheel_state.hpp"

#include <span>
#include <string_view>

namespace microslip {

/// A number of a wheel's state. Case files, Python and result files read it from here: a new one is a line of the table
/// in wheel_rail_quantities.cpp.
struct StateQuantity {
  std::string_view section;     ///< of case files: track, rail or wheel
  std::string_view name;        ///< in every door
  std::string_view unit;        ///< SI
  double limit;                 ///< the largest magnitude that makes sense, in that unit
  std::string_view description; ///< with the sign's meaning
  double& (*of)(WheelState<double>& state);

  double value(WheelState<double> state) const { return of(state); }
};

/// A number of a solution for the wheel, or for one of its patches. Printed tables, JSON, HDF5 and Python read it from
/// here.
template <class Of> struct RailwayQuantity {
  std::string_view name, unit, description;
  double (*value)(const Of& of);
};
using WheelQuantity = RailwayQuantity<WheelRailSolution>;
using PatchQuantity = RailwayQuantity<WheelRailPatch>;

/// All of them in the order in which they are shown.
std::span<const StateQuantity> state_quantities();
std::span<const WheelQuantity> wheel_quantities();
std::span<const PatchQuantity> patch_quantities();

/// T-gamma of a patch, |Fx xi| + |Fy eta| [N, or J per metre rolled]: what wear indices of wheels and rails are
/// functions of (McEwen & Harvey, Full-scale wheel-on-rail wear testing, 1985). With the spin |Mz phi| is added.
double t_gamma(const WheelRailPatch& patch);
double t_gamma_with_spin(const WheelRailPatch& patch);

/// From this turn [rad] of the rail's surface across a flat patch on, distances along it differ by 3 % from those in
/// its plane: cos = 1/1.03.
inline constexpr double largest_flat_turn = 0.2419;

} // namespace microslip
