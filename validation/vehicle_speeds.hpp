#pragma once

#include <string>
#include <vector>

namespace microslip::validation {

/// A vehicle that ran over an irregular straight track.
struct VehicleSpeed {
  std::string name;
  int wheels = 0;
  int threads = 1;
  double real_time = 0;          ///< simulated seconds in a second of processor time
  double real_time_elapsed = 0;  ///< and in a second that elapsed, which needs free processors
  double contact_share = 0;      ///< of the time
  double seconds_a_wheel = 0;    ///< processor time of a solve of one wheel
  double evaluations_a_step = 0; ///< of the integrator, which takes steps of 1 ms
};

/// Lets a wheelset, a bogie and a car run by the fast theories, the car by two threads too. Throws Error where
/// microslip was built without Simbody. Cost some 10 s.
std::vector<VehicleSpeed> vehicle_speeds();

} // namespace microslip::validation
