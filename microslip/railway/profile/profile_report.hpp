#pragma once

#include "microslip/railway/profile/profile.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace microslip {

/// A corner of a profile, at which its spline is cut.
struct ProfileKink {
  ProfilePoint point = {};
  double s = 0;     ///< [m]
  double angle = 0; ///< by which the direction turns [rad]; positive to the left
};

/// Scatter of a profile's points across the curve.
struct ProfileNoise {
  double deviation = 0; ///< standard deviation [m]
  double curvature = 0; ///< standard deviation of the curvature that follows from it [1/m]
  /// Standard deviation [m] of independent errors that have the same waves of a few millimetres: more than `deviation`
  /// where neighbours share errors, or values are rounded.
  double long_waves = 0;
  /// Wavelength of smoothing [m] with the best peak pressures; 0 where the curvature is certain within 3 1/m as it is.
  double smoothing_length = 0;
};

/// What smoothing did to a profile.
struct ProfileSmoothing {
  double length = 0;           ///< the wavelength that was asked for [m], 0: none
  bool by_noise = false;       ///< by the points' noise, where nothing was asked for
  double mean_move = 0;        ///< root mean square of the points' [m]
  double largest_move = 0;     ///< [m]
  double curvature_change = 0; ///< root mean square, of the polygon [1/m]
  /// Standard deviations that the noise leaves, by_noise: of the curvature of 6 mm [1/m], median of the profile, and
  /// of the peak pressure, relative, of this profile's part (`pressure_deviation`).
  double curvature_left = 0, pressure_left = 0;
};

/// Operations on a profile's points, and conspicuous features of them, in words for users. Lengths in them are in
/// mm.
struct ProfileReport {
  std::string source = {};  ///< the file's name
  std::string format = {};  ///< "Simpack", "MiniProf", ...; empty if the points came from no file
  std::string comment = {}; ///< from the file
  double unit = 1;          ///< length [m] of the file's unit, with the scale
  std::size_t points_read = 0;
  std::size_t points = 0; ///< of the spline

  std::vector<std::string> steps = {};       ///< what was done to the points, in order
  std::vector<std::string> assumptions = {}; ///< what the file does not say and the options do not either
  std::vector<std::string> warnings = {};    ///< what is probably wrong
  std::vector<ProfileKink> kinks = {};
  ProfileNoise noise = {};
  ProfileSmoothing smoothing = {};
};

} // namespace microslip
