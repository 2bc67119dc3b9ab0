#include "microslip/railway/wheel_rail_derivatives.hpp"

#include "microslip/railway/geometry/relative_motion.hpp"

#include <algorithm>
#include <utility>

namespace microslip {
namespace {

constexpr auto height_number = static_cast<std::size_t>(WheelVariable::vertical);
constexpr std::size_t height_result = 6;

/// Derivatives by the ten basic numbers of a state, and by the vertical force.
struct BasicDerivatives {
  std::array<Wrench, basic_motions> by{};
  Wrench by_force{};
};

/// Steps of differences.
struct DifferenceSteps {
  double position, yaw, creepage; ///< [m], [rad], [-]

  double of(std::size_t basic, double speed) const {
    constexpr double radius = 0.5; // [m]
    switch (static_cast<WheelVariable>(basic)) {
    case WheelVariable::lateral:
    case WheelVariable::vertical:
      return position;
    case WheelVariable::roll:
      return position / radius;
    case WheelVariable::yaw:
      return yaw;
    case WheelVariable::forward_velocity:
    case WheelVariable::lateral_velocity:
    case WheelVariable::vertical_velocity:
      return creepage * speed;
    default:
      return creepage * speed / radius;
    }
  }
};

/// Forward differences of rows: a hundred-thousandth or less of an approach of 50 um and a creepage of 0.001.
// Forces have a noise of some 1e-8 N.
constexpr DifferenceSteps row_steps = {3e-10, 5e-9, 5e-10};

/// Central differences of elements. Elements come and go with every micrometre or so, each with a kink in the forces,
/// and so do those that slide with the creepage: steps take some together. They are small beside the patch's approach
/// [m], on which the load depends where the height is given, and beside creepages of 0.001.
DifferenceSteps element_steps(double approach, bool force_given) {
  constexpr double of_approach = 0.02, of_approach_with_force = 0.08;
  return {(force_given ? of_approach_with_force : of_approach) * approach, 2e-5, 1e-5};
}

/// Along the track [m], and of the wheel's pitch [rad]: surfaces vary slowly there.
constexpr std::array<std::pair<std::size_t, double>, 2> position_steps = {std::pair{longitudinal_number, 1e-6},
                                                                          {pitch_number, 2e-6}};
constexpr double longer_along = 20; ///< these steps for elements
using PositionDerivatives = std::array<Wrench, position_steps.size()>;

/// The ten basic numbers of a state in the order of their differences.
constexpr std::array<WheelVariable, basic_motions> in_order = {WheelVariable::forward_velocity,
                                                               WheelVariable::lateral_velocity,
                                                               WheelVariable::vertical_velocity,
                                                               WheelVariable::roll_velocity,
                                                               WheelVariable::pitch_velocity,
                                                               WheelVariable::yaw_velocity,
                                                               WheelVariable::lateral,
                                                               WheelVariable::yaw,
                                                               WheelVariable::roll,
                                                               WheelVariable::vertical};

bool is_velocity(std::size_t basic) {
  return basic >= static_cast<std::size_t>(WheelVariable::forward_velocity);
}

WheelState<double> moved(WheelState<double> state, std::size_t number, double step) {
  *state.numbers()[number] += step;
  return state;
}

/// Turns derivatives with the height held into those with the vertical force held, by the implicit function theorem;
/// other numbers follow by (W8) and (W9).
BasicDerivatives with_force_held(const BasicDerivatives& height_held) {
  const Wrench& by_height = height_held.by[height_number];
  BasicDerivatives out;
  out.by_force = 1 / by_height.force.z * by_height, out.by_force.height = 1 / by_height.force.z;
  for (std::size_t k = 0; k < basic_motions; ++k)
    out.by[k] = height_held.by[k] - height_held.by[k].force.z * out.by_force;
  return out;
}

void set(WheelRailDerivatives& d, std::size_t variable, const Wrench& by) {
  d.set(variable, by.force, by.moment);
  d.at(height_result, variable) = by.height;
}

/// Differences around a state.
class Differences {
public:
  Differences(const NearbyForces& forces, bool surfaces_vary, const WheelState<double>& state,
              std::optional<double> vertical_force, const WheelRailSolution& found)
      : forces_(forces), surfaces_vary_(surfaces_vary), state_(state), vertical_force_(vertical_force) {
    state_.vertical = found.vertical;
    for (const WheelRailPatch& patch : found.patches)
      speed_ = std::max(speed_, patch.rolling_speed), approach_ = std::max(approach_, patch.approach);
    forces.of_rows(state_);
    here_ = (surfaces_vary ? forces.of_rows : forces.of_shifted_rows)(state_); // to more digits than a solution has
    basic_ = of_rows();
    if (vertical_force) {
      difference_at_equal_load();
      basic_ = with_force_held(basic_);
    }
    if (surfaces_vary)
      for (std::size_t k = 0; k < position_steps.size(); ++k) by_position_[k] = of_rows_along(k);
    if (forces.of_elements) refine();
  }

  const WheelState<double>& state() const { return state_; } ///< in the height that was found
  const BasicDerivatives& basic() const { return basic_; }
  const PositionDerivatives& by_position() const { return by_position_; }

private:
  Wrench forward(std::size_t number, double step, const std::function<Wrench(const WheelState<double>&)>& forces) {
    Wrench d = 1 / step * (forces(moved(state_, number, step)) - here_);
    d.height = 0; // held
    return d;
  }

  double row_step(WheelVariable which) const {
    return (surfaces_vary_ ? 100 : 1) * row_steps.of(static_cast<std::size_t>(which), speed_);
  }
  const std::function<Wrench(const WheelState<double>&)>& forces_elsewhere() const {
    return surfaces_vary_ ? forces_.of_rows : forces_.of_shifted_rows;
  }

  /// Derivatives of rows with the height held. Each state starts from the one before: velocities alone need no new
  /// pressures and come first, what changes the loads most comes last.
  BasicDerivatives of_rows() {
    BasicDerivatives derivatives;
    for (const WheelVariable which : in_order) {
      const auto k = static_cast<std::size_t>(which);
      if (const double step = row_step(which); step > 0)
        derivatives.by[k] = forward(k, step, is_velocity(k) ? forces_.of_moving_rows : forces_elsewhere());
    }
    return derivatives;
  }

  /// With a force held, what a wheel does that moves across or turns is the small difference of two large changes, by
  /// that motion and by the height, which amplifies the load's second derivative, large at small approaches, and noise.
  /// Differences along both together, at nearly the same load, do not, and their steps may be longer.
  void difference_at_equal_load() {
    constexpr double longer = 10;
    const Wrench& by_height = basic_.by[height_number];
    for (const WheelVariable which : {WheelVariable::lateral, WheelVariable::yaw, WheelVariable::roll}) {
      Wrench& by = basic_.by[static_cast<std::size_t>(which)];
      const double lift = -by.force.z / by_height.force.z, step = longer * row_step(which);
      WheelState<double> there = moved(state_, static_cast<std::size_t>(which), step);
      there.vertical += lift * step;
      Wrench along = 1 / step * (forces_elsewhere()(there) - here_);
      along.height = 0; // as in the others
      by = along - lift * by_height;
    }
  }

  /// Derivative by the position along the track or the pitch, with the same held as for the basic ones.
  Wrench of_rows_along(std::size_t k) {
    const Wrench d = forward(position_steps[k].first, position_steps[k].second, forces_.of_rows);
    return d - d.force.z * basic_.by_force;
  }

  Wrench central(std::size_t number, double step) {
    const Wrench up = forces_.of_elements(moved(state_, number, step), vertical_force_);
    Wrench d = 0.5 / step * (up - forces_.of_elements(moved(state_, number, -step), vertical_force_));
    if (!vertical_force_) d.height = 0; // as it is given
    return d;
  }

  /// Refines those of rows to those of elements, with prescribed quantities held.
  void refine() {
    constexpr double share_of_force = 1e-3;
    const DifferenceSteps steps = element_steps(approach_, vertical_force_.has_value());
    for (std::size_t k = 0; k < basic_motions; ++k) {
      const double step = steps.of(k, speed_);
      if (step > 0 && !(vertical_force_ && k == height_number)) basic_.by[k] = central(k, step);
    }
    if (surfaces_vary_)
      for (std::size_t k = 0; k < position_steps.size(); ++k)
        by_position_[k] = central(position_steps[k].first, longer_along * position_steps[k].second);
    if (!vertical_force_) return;
    const double step = share_of_force * *vertical_force_;
    const Wrench up = forces_.of_elements(state_, *vertical_force_ + step);
    basic_.by_force = 0.5 / step * (up - forces_.of_elements(state_, *vertical_force_ - step));
  }

  const NearbyForces& forces_;
  bool surfaces_vary_;
  WheelState<double> state_;
  std::optional<double> vertical_force_;
  double speed_ = 0, approach_ = 0; ///< the largest of the patches [m/s], [m]
  Wrench here_;                     ///< of rows
  BasicDerivatives basic_;
  PositionDerivatives by_position_{};
};

} // namespace

void differentiate(const NearbyForces& forces, const NominalPlacement& nominal, bool surfaces_vary,
                   const WheelState<double>& state, std::optional<double> vertical_force,
                   const WheelRailSolution& found, WheelRailDerivatives& d) {
  const Differences differences(forces, surfaces_vary, state, vertical_force, found);
  const auto& [by, by_force] = differences.basic();
  const auto motions = relative_motions(nominal, differences.state());
  for (std::size_t k = 0; k < state_numbers; ++k) {
    const Wrench turned = {cross(motions[k].turn, found.force), cross(motions[k].turn, found.moment)};
    Wrench sum = turned - turned.force.z * by_force + motions[k].ahead * differences.by_position()[0];
    if (k == pitch_number) sum = sum + differences.by_position()[1];
    for (std::size_t i = 0; i < basic_motions; ++i) sum = sum + motions[k].combination[i] * by[i];
    set(d, k, sum);
  }
  if (vertical_force)
    set(d, height_number, {});
  else
    d.at(height_result, height_number) = 1;
  set(d, state_numbers, by_force);
}

} // namespace microslip
