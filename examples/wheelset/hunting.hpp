#pragma once

#include "history.hpp"
#include "wheelset.hpp"

/// Straight running at z = 0, a little disturbed: the largest real part of the eigenvalues of f's Jacobian [1/s], and
/// the imaginary part that belongs to it [rad/s].
struct LinearGrowth {
  double rate, frequency;
};
LinearGrowth linear_growth(WheelsetParameters parameters, double speed);

/// The speed between `low` and `high` at which the growth rate changes its sign [m/s]. Throws std::runtime_error if it
/// has the same sign at both.
double critical_speed(const WheelsetParameters& parameters, double low = 5, double high = 200);

/// A run from a lateral displacement at rest, in equal steps.
History<Wheelset::states> run(const WheelsetParameters& parameters, double displacement, double duration,
                              double step = 1e-3);

/// The speed at which a small disturbance neither grows nor decays in the nonlinear run, found between 0.95 and 1.05 of
/// the critical speed.
double critical_speed_of_runs(const WheelsetParameters& parameters);
