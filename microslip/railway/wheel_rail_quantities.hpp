#pragma once

#include "microslip/damage/surface_strength.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/railway/wheel_state.hpp"

#include <cmath>
#include <span>
#include <string_view>
#include <vector>

namespace microslip {

/// A number of a wheel's state. Case files, Python and result files read it from here: a new one is a line of the table
/// in wheel_rail_quantities.cpp.
struct StateQuantity {
  std::string_view section;     ///< of case files: track, rail or wheel
  std::string_view name;        ///< in every interface
  std::string_view unit;        ///< SI
  double limit;                 ///< the largest magnitude that makes sense, in that unit
  std::string_view description; ///< with the sign's meaning
  double& (*of)(WheelState<double>& state);

  double value(WheelState<double> state) const { return of(state); }
};

/// The smallest and the largest vertical force [N] on a wheel or a wheelset, in every interface.
inline constexpr double least_vertical_force = 1e-6, largest_vertical_force = 1e9;
inline bool is_vertical_force(double force) {
  return force >= least_vertical_force && force <= largest_vertical_force;
}

/// A number of a solution for the wheel, or for one of its patches. Printed tables, JSON, HDF5 and Python read it from
/// here. It is NaN where what it needs is not given, as a hardness, or not there, as a flange; tables and files leave
/// out what no wheel or patch has.
template <class Of> struct RailwayQuantity {
  std::string_view name, unit, description;
  double (*value)(const Of& of);

  template <class Values> bool is_given(const Values& values) const {
    for (const Of& of : values)
      if (!std::isnan(value(of))) return true;
    return false;
  }
};
using WheelQuantity = RailwayQuantity<WheelRailSolution>;
using PatchQuantity = RailwayQuantity<WheelRailPatch>;

/// A field of damage on a patch: a value for each element, none where a strength is not given.
struct DamageField {
  std::string_view name, unit, description;
  std::vector<double> (*values)(const ContactSolution& fields, const WheelRailPatch& patch,
                                const SurfaceStrength& strength);
};

/// All of them in the order in which they are shown.
std::span<const StateQuantity> state_quantities();
std::span<const WheelQuantity> wheel_quantities();
std::span<const PatchQuantity> patch_quantities();
std::span<const DamageField> damage_fields();

/// T-gamma of a patch (damage/wear.hpp).
double t_gamma(const WheelRailPatch& patch);
double t_gamma_with_spin(const WheelRailPatch& patch);

} // namespace microslip
