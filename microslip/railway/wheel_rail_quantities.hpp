#pragma once

#include "microslip/damage/surface_strength.hpp"
#include "microslip/railway/geometry/wheel_state.hpp"
#include "microslip/railway/wheel_rail.hpp"

#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>
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
  bool is_odd = false; ///< it changes its sign in a mirror whose plane is x, z

  double value(WheelState<double> state) const { return of(state); }
  double* odd(WheelState<double>& state) const { return is_odd ? &of(state) : nullptr; }
};

/// A number that a wheel is given: one of its state, or the vertical force on it.
struct WheelInput {
  std::string_view name, unit, description;
  const StateQuantity* of_state = nullptr; ///< none of the vertical force, which is 0 where a height is given
  std::size_t variable = 0;                ///< its index among the derivatives
};

/// The smallest and the largest vertical force [N] on a wheel or a wheelset, in every interface.
inline constexpr double least_vertical_force = 1e-6, largest_vertical_force = 1e9;
inline bool is_vertical_force(double force) {
  return force >= least_vertical_force && force <= largest_vertical_force;
}

/// A number of a solution for the wheel, or for one of its patches. Printed tables, JSON, HDF5, Python and C read it
/// from here. It is NaN where what it needs is not given, as a hardness, or not there, as a flange; tables and files
/// leave out what no wheel or patch has.
template <class Of> struct RailwayQuantity {
  std::string_view name, unit, description;
  double (*value)(const Of& of) = nullptr;
  bool is_code = false;                    ///< a whole number with meanings of its own, such as a status
  double& (*odd_number)(Of& of) = nullptr; ///< where it is kept, if it changes its sign in a mirror whose plane is x, z

  constexpr RailwayQuantity() = default;
  constexpr RailwayQuantity(std::string_view called, std::string_view in, std::string_view text,
                            double (*of)(const Of&), bool code = false)
      : name(called), unit(in), description(text), value(of), is_code(code) {}
  /// A member, by a function that returns a reference.
  template <class Member>
  requires std::is_invocable_r_v<double&, Member, Of&>
  constexpr RailwayQuantity(std::string_view called, std::string_view in, std::string_view text, Member, bool is_odd)
      : RailwayQuantity(called, in, text, [](const Of& of) -> double { return Member{}(const_cast<Of&>(of)); }) {
    if (is_odd) odd_number = [](Of& of) -> double& { return Member{}(of); };
  }

  bool is_odd() const { return odd_number != nullptr; }
  double* odd(Of& of) const { return odd_number ? &odd_number(of) : nullptr; }

  template <class Values> bool is_given(const Values& values) const {
    for (const Of& of : values)
      if (!std::isnan(value(of))) return true;
    return false;
  }
};
using WheelQuantity = RailwayQuantity<WheelRailSolution>;
using PatchQuantity = RailwayQuantity<WheelRailPatch>;

inline constexpr const char* profile_end_codes = "1: a patch ends where a profile ends";

/// All of them in the order in which they are shown, without codes.
std::span<const StateQuantity> state_quantities();
/// Returns whether all numbers of a state are within their ranges.
bool is_in_range(WheelState<double> state) noexcept;
std::span<const WheelQuantity> wheel_quantities();
std::span<const PatchQuantity> patch_quantities();

/// The rows of arrays, whose indices and lengths programs keep: a new number stands at the end. What a wheel is
/// given; numbers and codes of a wheel and of a patch; what has derivatives.
std::span<const WheelInput> wheel_inputs();
const WheelInput& vertical_force_input();
std::span<const WheelQuantity> wheel_results();
std::span<const PatchQuantity> patch_results();
std::span<const WheelQuantity> wheel_derivatives();

/// A left wheel's solution or derivatives as those of a right one and back, seen in a mirror whose plane is x, z: what
/// is odd changes its sign.
void mirror(WheelRailSolution& solution);
void mirror(WheelRailDerivatives& derivatives);

/// T-gamma of a patch (damage/wear.hpp).
double t_gamma(const WheelRailPatch& patch);
double t_gamma_with_spin(const WheelRailPatch& patch);

} // namespace microslip
