/// Critical speeds of a vehicle on straight track: where small motions begin to grow, and down to where a limit cycle
/// lives.

#ifndef MICROSLIP_DYTSI_STABILITY_HPP
#define MICROSLIP_DYTSI_STABILITY_HPP

#include "vehicle.hpp"

#include <vector>

/// Small oscillation about straight running.
struct Mode {
  double growth;    ///< real part of the eigenvalue [1/s]
  double frequency; ///< imaginary part over 2 pi [Hz]
};

/// Least damped mode of hunting at a speed [m/s], by the eigenvalues of the central differences of f at the
/// equilibrium, which Newton's method finds. It is looked for between 1 and 7 Hz: below the car sways, and above the
/// wheelsets bounce on springs without damping. Cost: some 400 evaluations of f. Throws std::runtime_error if there is
/// none.
Mode hunting_mode(DytsiVehicle& vehicle, double speed);

/// Speed at which the hunting mode begins to grow.
struct LinearCriticalSpeed {
  double speed;     ///< [m/s], to 0.001
  double frequency; ///< [Hz]
};

/// Finds it by Alefeld, Potra and Shi's method. Throws std::runtime_error unless the mode decays at `low` and grows at
/// `high` [m/s].
LinearCriticalSpeed linear_critical_speed(DytsiVehicle& vehicle, double low, double high);

/// Amplitude below which a motion dies [m]: limit cycles reach flanges, 5 mm and more.
constexpr double least_amplitude = 3e-3;

/// Motion that is left at a speed.
struct LimitCycle {
  double speed;     ///< [m/s]
  double amplitude; ///< largest lateral displacement of the first wheelset over two seconds [m]
  bool lives() const { return amplitude >= least_amplitude; }
};

/// Limit cycles as the speed [m/s] falls, 5 m/s and 6 s at a time, until they die, in order of speed. At the highest
/// speed both bogies begin 8 mm beside the track's middle; later each speed begins with the motion that the one before
/// has left. From the last that lives on for 20 s more, bisection finds the speed where they die, to 0.1 m/s, with 20 s
/// for each: the nonlinear critical speed. Runge and Kutta's method of fourth order with 1 ms. Throws
/// std::runtime_error if no cycle lives on.
std::vector<LimitCycle> limit_cycles(DytsiVehicle& vehicle, double highest_speed);

#endif
