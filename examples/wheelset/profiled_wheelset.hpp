#pragma once

#include "small_matrix.hpp"

#include <microslip/railway/vehicle/wheelset_on_track.hpp>

#include <filesystem>

/// The points of a Simpack profile (.prr, .prw), to be read in mm with z down, and its spline.
microslip::Profile read_profile(const std::filesystem::path& file, microslip::ProfileRole role);

/// The leading wheelset of a bogie whose frame follows the track. All in SI units.
struct ProfiledParameters {
  double speed = 40;              ///< V [m/s]
  double mass = 1200;             ///< [kg]
  double roll_inertia = 800;      ///< [kg m^2], also about z
  double rolling_inertia = 100;   ///< about the axle [kg m^2]
  double lateral_stiffness = 5e5; ///< of the suspension [N/m]
  double yaw_stiffness = 2e6;     ///< [N m/rad]
  double axle_load = 120e3;       ///< Q, with the weight of the wheelset [N]
  double half_wheelbase = 1.25;   ///< a: how far it is ahead of the bogie's centre [m]
  double curvature = 0;           ///< kappa [1/m], > 0 in a curve to the left
  double cant_deficiency = 0;     ///< [m]: by how much the outer rail of a curve is too low for the speed
};

/// Profiles and what belongs to them.
microslip::WheelRailBodies bodies_from(const std::filesystem::path& profiles, double friction = 0.3,
                                       double cant = 1.0 / 40, double gauge = 1.435);

/// Equations of motion z' = f(z) with their Jacobian. Track axes: x forward, y to the left, z up.
///
/// z = (y, h, phi, psi, their rates, omega): lateral displacement and height [m], roll and yaw [rad], and the speed of
/// rotation [rad/s]. With the force F and the moment M of both contacts on the wheelset, e along the axle, L = I_y
/// omega, and the frame, over the track's centre, turned by -a kappa against the track at the wheelset:
///   m y'' = F_y - k_y y - Q I/(1.5 m) sign(kappa),  m h'' = F_z - Q,
///   I phi'' = M_x + L (psi' + V kappa),  I psi'' = M_z - L phi' - k_psi (psi + a kappa),  I_y omega' = e.M.
class ProfiledWheelset {
public:
  static constexpr std::size_t states = 9;
  using State = Vector<states>;
  using Jacobian = Matrix<states>;
  enum { lateral, height, roll, yaw, lateral_rate, height_rate, roll_rate, yaw_rate, rotation };

  ProfiledWheelset(const microslip::WheelRailBodies& bodies, const ProfiledParameters& parameters,
                   const microslip::WheelRailMethod& method = {});

  const ProfiledParameters& parameters() const { return p_; }
  void set(const ProfiledParameters& parameters) { p_ = parameters; }
  /// At rest but for rolling, in equilibrium of height and roll at a lateral displacement [m].
  State standing(double displacement);
  /// The rates, and their derivatives with respect to the state. Throw std::runtime_error if the contacts are not
  /// solved.
  void rates(const State& z, State& rate);
  void rates(const State& z, State& rate, Jacobian& jacobian);
  /// The contacts of a state.
  microslip::WheelsetSolution contacts_in(const State& z);
  /// What the contacts took so far [s], and how many wheels were solved, derivatives counting as one.
  double contact_seconds() const { return contact_seconds_; }
  long contacts() const { return contacts_; }

private:
  microslip::WheelsetState wheelset_state(const State& z) const;
  template <class Solve> void solve_contacts(const Solve& solve);
  State without_derivatives(const State& z) const;

  ProfiledParameters p_;
  microslip::WheelsetOnTrack contact_;
  microslip::WheelsetSolution found_;
  microslip::WheelsetDerivatives derivatives_;
  double contact_seconds_ = 0;
  long contacts_ = 0;
};
