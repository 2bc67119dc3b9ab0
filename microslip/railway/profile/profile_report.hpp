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
  /// Wavelength of smoothing [m] that takes the deviation of the curvature down to 3 1/m; 0 if it is below.
  double smoothing_length = 0;
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
  double smoothing_length = 0; ///< [m], 0: the spline passes through the points
};

} // namespace microslip
