#pragma once

#include "microslip/contact/force_response.hpp"
#include "microslip/progress.hpp"
#include "microslip/railway/geometry/wheel_state.hpp"
#include "microslip/railway/problem/wheel_rail_types.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace microslip {

/// Throws Error for a shape of patches that the theory does not have, with this text before the message.
void require_shape(const WheelRailMethod& method, const std::string& name = "shape");
/// Throws Error for layers out of range, and for a method that cannot have them.
void require_layers(const std::optional<LayeredBodies>& layered, const WheelRailMethod& method);

/// Variables of differentiation: the numbers of a state in the order of state_quantities(), and the vertical
/// force. Round wheels and fixed profiles have no derivatives by position along the track and angle of pitch.
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
  curvature,
  deflection_longitudinal,
  deflection_lateral,
  deflection_vertical,
  deflection_roll,
  deflection_yaw,
  deflection_longitudinal_velocity,
  deflection_lateral_velocity,
  deflection_vertical_velocity,
  deflection_roll_velocity,
  deflection_pitch_velocity,
  deflection_yaw_velocity,
  deviation_lateral,
  deviation_vertical,
  deviation_roll,
  deviation_lateral_velocity,
  deviation_vertical_velocity,
  deviation_roll_velocity,
  longitudinal,
  pitch,
  vertical_force,
};
inline constexpr std::size_t wheel_variables = state_numbers + 1;

/// Derivatives in SI units of forces and moments about x, y, z, of the height and what follows in the tables of
/// results, by each variable.
template <std::size_t results, std::size_t variables> struct ForceDerivatives {
  std::array<double, results * variables> values{}; ///< result by result

  double& at(std::size_t result, std::size_t variable) { return values[result * variables + variable]; }
  double at(std::size_t result, std::size_t variable) const { return values[result * variables + variable]; }
  Vec3<double> force(std::size_t k) const { return {at(0, k), at(1, k), at(2, k)}; }
  Vec3<double> moment(std::size_t k) const { return {at(3, k), at(4, k), at(5, k)}; }
  double vertical(std::size_t k) const { return at(6, k); } ///< of the wheelset's height

  void set(std::size_t k, const Vec3<double>& force, const Vec3<double>& moment) {
    at(0, k) = force.x, at(1, k) = force.y, at(2, k) = force.z;
    at(3, k) = moment.x, at(4, k) = moment.y, at(5, k) = moment.z;
  }
};

/// Derivatives of the forces on a wheel: of wheel_derivatives() (wheel_rail_quantities.hpp) by each WheelVariable.
/// Those by what was not given are zero: by the height with a vertical force, by the vertical force with a height.
inline constexpr std::size_t differentiated_results = 7;
struct WheelRailDerivatives : ForceDerivatives<differentiated_results, wheel_variables> {};

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
  /// gives invalid_input. With the theories `fastsim2` and `table` it allocates nothing once `solution` has had its
  /// size, unless fields are asked for, or wear, which needs them: with a hardness. Where surfaces vary, or on rollers,
  /// it first finds the equivalent rail of each state, which takes some 10 ms and allocates. Without contact, too,
  /// where a rail is interrupted. `progress` is called often with the theory `exact`, without a fraction; where it
  /// returns false Stopped is thrown, and the solver is as good as before.
  void solve(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& solution,
             const Progress& progress = {});
  WheelRailSolution solve(const WheelState<double>& state, std::optional<double> vertical_force = {},
                          const Progress& progress = {});
  /// Forgets the last state, from which the next solve with the theories `fastsim2` and `table` starts where it is
  /// near. That changes results by about the tolerance, and halves the time; after reset() they are those of a new
  /// solver to the last bit.
  void reset();

  /// Solves with derivatives, which hold where no patch comes or goes. With respect to the first ten numbers of a state
  /// they are differences, the others follow (relative_motion.hpp). At `fastsim2` and `table`, where they cost some two
  /// solves and allocate as little, their errors are 1e-5 of the largest of their row. At `exact` they cost some 20
  /// solves and are slopes over some micrometres, since forces have kinks where elements come and go; with one element
  /// more across each contact half of those by positions differ by up to 1e-2, and by velocities by 5e-4. Derivatives
  /// of unsolved quantities are zero.
  void differentiate(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& solution,
                     WheelRailDerivatives& derivatives, const Progress& progress = {});

  /// The responses of each patch, about its steady rolling, at wavenumbers omega/V [1/m] of its own rolling speed, to
  /// oscillations of its creepages, its normal force and roughness; forces along and moments about the axes of its
  /// frame. Those of the theory `exact` on half-spaces; else throws Error. What the rows' angles add to the
  /// displacements of conformal patches stays as it is. Patches in the order of the solution's; none unless that is
  /// solved. Cost: some 15 ms for each patch and wavenumber at 24 elements across.
  std::vector<FrequencyResponse> respond(const WheelState<double>& state, std::optional<double> vertical_force,
                                         std::span<const double> wavenumbers, WheelRailSolution& solution,
                                         const Progress& progress = {});

private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

} // namespace microslip
