#pragma once

#include "history.hpp"
#include "profiled_wheelset.hpp"

#include <span>
#include <vector>

using ProfiledHistory = History<ProfiledWheelset::states>;

/// Small disturbances of straight running: of the eigenvalues below 50 Hz the largest real part [1/s] and the imaginary
/// part that belongs to it [rad/s].
struct SmallMotion {
  double rate, frequency;
};
SmallMotion small_motion(const microslip::WheelRailBodies& bodies, ProfiledParameters parameters, double speed);

/// The speed between `low` and `high` at which the growth rate changes its sign [m/s]. Throws std::runtime_error if it
/// has the same sign at both.
double critical_speed(const microslip::WheelRailBodies& bodies, const ProfiledParameters& parameters, double low = 20,
                      double high = 120);

/// A run from a lateral displacement at rest.
ProfiledHistory run(const microslip::WheelRailBodies& bodies, const ProfiledParameters& parameters, double displacement,
                    double duration, double step = 1e-3);

/// A run of a wheelset from a state.
ProfiledHistory run(ProfiledWheelset& wheelset, const ProfiledWheelset::State& start, double duration,
                    double step = 1e-3);

/// Amplitudes that are left at each speed after `duration` [s], from the state in which the speed before left the
/// wheelset; from 0.1 mm where less is left.
std::vector<double> amplitudes(const microslip::WheelRailBodies& bodies, ProfiledParameters parameters, double start,
                               std::span<const double> speeds, double duration);

/// A run from straight track into a curve: straight for `duration`/6, a transition of the same length in which
/// curvature and cant deficiency grow linearly, then the curve.
ProfiledHistory enter_curve(const microslip::WheelRailBodies& bodies, const ProfiledParameters& parameters,
                            double duration, double step = 1e-3);

/// The curve of a radius [m] at that cant deficiency and the speed that belongs to it: V^2 = R g (cant + deficiency) /
/// 1.5 m.
ProfiledParameters in_curve(double radius, double cant_deficiency, double cant = 0.1);

/// Lateral over vertical force of a wheel towards its flange, Y/Q: -1 for the left wheel's sign of y, +1 for the right.
double flange_ratio(const microslip::WheelRailSolution& wheel, double side);
