#pragma once

#include "microslip/railway/vehicle/wheel_pair.hpp"

namespace microslip {

/// The equations of a wheelset whose forces balance its load (W10), for what that leaves open: F_z = Q; M_x = the roll
/// moment or F_z,left - F_z,right = Q_left - Q_right; the moment of the contacts about the axle = -torque. Unknowns are
/// height, roll and pitch velocity, in units of changes that matter; residuals count in units of the load, times half
/// the base or the radius where they are moments. What is not prescribed has the residual 0, and its unknown stays.
class WheelsetEquations {
public:
  using Vector = std::array<double, 3>;
  using Matrix = std::array<double, 9>; ///< row by row
  enum Unknown : std::size_t { height, roll, pitch_velocity };

  /// `vertical_force` [N], of the state, is the unit of residuals where no load is prescribed.
  WheelsetEquations(const WheelsetState& state, const WheelsetLoad& load, const WheelPair& wheels,
                    double vertical_force);

  bool finds(std::size_t unknown) const { return unknown == pitch_velocity ? has_torque_ : has_load_; }
  bool has_wheel_loads() const { return has_wheel_loads_; }
  double load() const { return value_[0]; }                                         ///< on both wheels [N]
  double size_of(std::size_t unknown) const { return sizes_of_unknowns_[unknown]; } ///< [m], [rad], [rad/s]
  /// Each wheel's load where the left one has this share of both [N].
  WheelLoads loads(double share) const { return {share * load(), (1 - share) * load()}; }
  /// The left wheel's share of the load, a half where only the roll moment is known.
  double share() const { return has_wheel_loads_ ? 0.5 + value_[1] / (2 * load()) : 0.5; }

  /// A state moved by changes of the unknowns.
  WheelsetState moved(WheelsetState state, const Vector& step) const;
  Vector residual(const WheelsetState& state, const WheelsetSolution& found) const;
  Matrix jacobian(const WheelsetState& state, const WheelsetSolution& found, const WheelPairDerivatives& by) const;
  /// Turns derivatives with nothing held into those with prescribed quantities held, by the implicit function theorem:
  /// du/dx = -R_u^-1 R_x. Those with respect to unknowns stay as they are.
  void hold(const WheelsetState& state, const WheelsetSolution& found, const WheelPairDerivatives& by,
            WheelsetDerivatives& out) const;

private:
  Vector scaled(const Vector& found) const;
  Vector slope(const WheelsetState& state, const WheelsetSolution& found, const WheelPairDerivatives& by,
               std::size_t number) const;

  bool has_load_, has_torque_, has_wheel_loads_ = false;
  Vector value_{}, sizes_{1, 1, 1}, sizes_of_unknowns_{};
};

} // namespace microslip
