#pragma once

#include "microslip/railway/wheel_rail_types.hpp"
#include "microslip/railway/wheel_state.hpp"

#include <array>
#include <memory>
#include <optional>

namespace microslip {

/// What the forces are differentiated by. A wheel's angle of pitch and its place along the track change nothing.
enum class WheelVariable {
  lateral,
  vertical,
  roll,
  yaw,
  forward_velocity,
  lateral_velocity,
  vertical_velocity,
  roll_velocity,
  pitch_velocity,
  yaw_velocity,
};
inline constexpr std::size_t wheel_variables = 10;

/// Forces with their derivatives, in SI units: by a variable of the state, in the order of WheelVariable. Where the
/// vertical force is given, it is held in all columns but that of the height, which holds the derivatives by the force.
struct WheelRailDerivatives {
  std::array<Vec3<double>, wheel_variables> force, moment;
  std::array<double, wheel_variables> vertical{}; ///< of the wheelset's height
};

/// Solves one wheel on its rail, state after state, with all tables made once.
class WheelRail {
public:
  /// Throws Error for input out of range and profiles that do not fit the track or the wheelset.
  WheelRail(WheelRailBodies bodies, const WheelRailMethod& method = {});
  WheelRail(WheelRail&&) noexcept;
  WheelRail& operator=(WheelRail&&) noexcept;
  ~WheelRail();

  /// The forces in a state. `vertical_force` [N] > 0 is F_z on the wheel, its height then an unknown; without it the
  /// state's is taken. No contact, a force that no height gives, and not converging are statuses; NaN in the state
  /// gives invalid_input. At the level `fastsim2` it allocates nothing once `solution` has had its size,
  /// unless fields are asked for, or wear, which needs them: with a hardness.
  void solve(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& solution);
  WheelRailSolution solve(const WheelState<double>& state, std::optional<double> vertical_force = {});

  /// The same with derivatives, by central differences of steps of a ten-thousandth of what changes the forces much,
  /// the wheel being held in its height; so they hold where no patch comes or goes. Errors of 1e-5 of the largest of
  /// their row at the level `fastsim2`, where they cost some three solves, of 1e-2 at `exact`, where they cost 20.
  /// Derivatives of a solution that is not ok are zero.
  void differentiate(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& solution,
                     WheelRailDerivatives& derivatives);

private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

} // namespace microslip
