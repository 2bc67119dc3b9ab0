#pragma once

#include "microslip/progress.hpp"
#include "microslip/railway/wheel_rail.hpp"

#include <array>
#include <memory>
#include <optional>
#include <variant>

namespace microslip {

/// Load of a wheelset on both rails together, as forces on it.
struct AxleLoad {
  double vertical_force = 0; ///< [N], > 0
  double roll_moment = 0;    ///< [N m] about the wheelset's centre, about the track's x
};

/// Load on each rail, as forces on the wheels.
struct WheelLoads {
  double left = 0, right = 0; ///< [N], > 0, vertical
};

/// Forces that are prescribed; what they leave open is the state's.
struct WheelsetLoad {
  std::optional<std::variant<AxleLoad, WheelLoads>> vertical; ///< finds height and roll
  /// [N m] about the axle, > 0 drives the wheelset forward: finds the pitch velocity at which the contacts balance it,
  /// at 0 that of free rolling.
  std::optional<double> axle_torque;
};

struct WheelsetSolution {
  WheelRailSolution left, right; ///< moments about each wheel's centre
  Vec3<double> force;            ///< of both, on the wheelset, in track axes [N]
  Vec3<double> moment;           ///< of both, about the wheelset's centre [N m]
  double vertical = 0;           ///< of the wheelset's centre, as given or found [m]
  double roll = 0;               ///< as given or found [rad]
  double pitch_velocity = 0;     ///< as given or found [rad/s]
  /// The largest of: vertical force over the load, roll moment over the load times half the wheels' distance, axle
  /// torque over the load times the radius.
  double residual = 0;
  int iterations = 0; ///< over height, roll and pitch velocity
  Warnings warnings;  ///< of both wheels, and of the wheelset
  Status status = Status::ok;
  Unsolved reason = Unsolved::none; ///< why the status is not ok
};

/// Variables of differentiation of a wheelset's forces: numbers of its state, and the prescribed forces.
enum class WheelsetVariable {
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
  vertical_force,
  roll_moment,
  vertical_force_left,
  vertical_force_right,
  axle_torque,
};
inline constexpr std::size_t wheelset_variables = 15;

/// Derivatives of the first numbers of wheelset_quantities(), with all that is prescribed held, by each
/// WheelsetVariable. Those by what was not given are zero: by height, roll and pitch velocity where they are found, by
/// forces that are not prescribed.
inline constexpr std::size_t differentiated_wheelset_results = 9;
struct WheelsetDerivatives : ForceDerivatives<differentiated_wheelset_results, wheelset_variables> {
  double roll(std::size_t k) const { return at(7, k); }
  double pitch_velocity(std::size_t k) const { return at(8, k); }
};

/// Solves both wheels of a wheelset on their rails, state after state, with all tables made once.
class WheelsetOnTrack {
public:
  /// Both wheels and rails alike: the side does not count. Throws Error as WheelRail.
  explicit WheelsetOnTrack(const WheelRailBodies& bodies, const WheelRailMethod& method = {});
  /// Each wheel with separate profiles and friction; track and wheelset are the left one's.
  WheelsetOnTrack(WheelRailBodies left, WheelRailBodies right, const WheelRailMethod& method = {});
  WheelsetOnTrack(WheelsetOnTrack&&) noexcept;
  WheelsetOnTrack& operator=(WheelsetOnTrack&&) noexcept;
  ~WheelsetOnTrack();

  /// The forces in a state, by Newton's method from the position where both rigid wheels touch, and by bracketing where
  /// contacts jump. `method.tolerance` is that of the residual. Forces that no height, roll and pitch velocity give are
  /// the status no_solution; a jump of the forces across the prescribed ones is not_converged, with the residual beside
  /// it. Where nothing is prescribed, a wheel may be off its rail; only if both are is the status no_contact. Cost some
  /// 4 derivatives of each wheel. `progress` is called before each solve of a wheel and within those at the level
  /// `exact`, of no fraction; where it returns false Stopped is thrown, and the solver is as good as before.
  void solve(const WheelsetState& state, const WheelsetLoad& load, WheelsetSolution& solution,
             const Progress& progress = {});
  WheelsetSolution solve(const WheelsetState& state, const WheelsetLoad& load = {}, const Progress& progress = {});
  /// Forgets the last state, from which wheels where nothing is prescribed start, as WheelRail::reset() does.
  void reset();

  /// Solves with derivatives, those of WheelRail::differentiate and the implicit function theorem. Those of
  /// unsolved quantities are zero.
  void differentiate(const WheelsetState& state, const WheelsetLoad& load, WheelsetSolution& solution,
                     WheelsetDerivatives& derivatives, const Progress& progress = {});

private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

} // namespace microslip
