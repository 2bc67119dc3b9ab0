#pragma once

#include "small_matrix.hpp"

#include <microslip/simplified/fastsim2.hpp>

#include <array>

/// A wheelset that runs straight on at constant speed, held by springs to a frame that does not move sideways. Conical
/// treads, small angles, constant wheel loads, and a spring for the flanges. All in SI units.
struct WheelsetParameters {
  double speed = 40;              ///< V [m/s]
  double mass = 1200;             ///< [kg]
  double yaw_inertia = 800;       ///< [kg m^2]
  double rolling_inertia = 100;   ///< about the axle [kg m^2]
  double radius = 0.46;           ///< r0 [m]
  double half_gauge = 0.75;       ///< l, from the centre to a contact [m]
  double conicity = 0.1;          ///< lambda [-]
  double lateral_stiffness = 2e5; ///< of the suspension [N/m]
  double yaw_stiffness = 1e6;     ///< [N m/rad]
  double wheel_load = 60e3;       ///< [N]
  double rail_head_radius = 0.3;  ///< transverse [m]
  double friction = 0.3;          ///< [-]
  double flange_clearance = 7e-3; ///< [m]
  double flange_stiffness = 1e7;  ///< [N/m]
};

/// Equations of motion z' = f(z) with their Jacobian. Frame and signs as in microslip: x forward, y to the left, z up.
///
/// z = (y, psi, y', psi', w): lateral displacement [m], yaw to the left [rad], their rates, and the speed of rotation
/// beyond V/r0 [rad/s]. With the left (+) and right (-) wheel:
///   rolling radius r = r0 +- lambda y,  xi = (V -+ l psi' - (V/r0 + w) r)/V,  eta = y'/V - psi,
///   phi = psi'/V -+ lambda/r0,
///   m y'' = sum Fy - k_y y - flange(y),  I_z psi'' = sum (-+ l Fx + Mz) - k_psi psi,  I_y w' = - sum r Fx.
class Wheelset {
public:
  static constexpr std::size_t states = 5;
  using State = Vector<states>;
  using Jacobian = Matrix<states>;
  enum { lateral, yaw, lateral_rate, yaw_rate, rotation };

  explicit Wheelset(const WheelsetParameters& parameters);

  const WheelsetParameters& parameters() const { return p_; }
  /// The rates, and their derivatives with respect to the state. Throw std::runtime_error if the contact law refuses
  /// its input.
  void rates(const State& z, State& rate);
  void rates(const State& z, State& rate, Jacobian& jacobian);
  /// What the contact law took so far [s], and for how many contacts.
  double contact_seconds() const { return contact_seconds_; }
  long contacts() const { return contacts_; }

private:
  /// What forces on a wheel do to lateral, yaw and rolling motion: levers of (fx, fy, mz).
  std::array<Vector<3>, 3> levers(double side, const State& z) const;
  /// Motion and springs, with forces on the wheels.
  State without_derivatives(const State& z, const std::array<Vector<3>, 2>& forces) const;
  /// Runs the contact law on the creepages of a state.
  template <class Solve> void solve_contacts(const State& z, const Solve& solve);
  void add_wheel(double side, const State& z, const microslip::ContactDerivatives& found, Jacobian& jacobian) const;
  double flange_force(double displacement) const;
  double rolling_radius(double side, const State& z) const { return p_.radius + side * p_.conicity * z[lateral]; }
  microslip::Creepage creepage(double side, const State& z) const;
  std::array<State, 3> creepage_derivatives(double side, const State& z) const;

  WheelsetParameters p_;
  microslip::Fastsim2 law_;
  std::array<microslip::EllipticContact, 2> contact_; ///< left, right
  double contact_seconds_ = 0;
  long contacts_ = 0;
};
