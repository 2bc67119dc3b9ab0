#pragma once

#include "io/json.hpp"
#include "microslip/railway/geometry/conicity.hpp"

#include <optional>
#include <string>
#include <vector>

namespace microslip::cases {

/// Input of `microslip conicity`: a wheelset on a track.
struct ConicityInput {
  Track track = {};
  Wheelset wheelset = {};
  double contact_distance = 1.5; ///< [m]
  RollRule roll = RollRule::equilibrium;
  std::vector<double> amplitudes = {};     ///< of the lateral displacement [m], ascending
  std::optional<double> curve_radius = {}; ///< [m], for the radial steering index
};

/// Results at one gauge.
struct ConicityResult {
  double gauge = 0;
  WheelsetCurve curve;
  std::vector<double> conicity, wavelength; ///< over the amplitudes; NaN where there is no motion
  std::optional<double> nonlinearity;
};

/// Amplitudes from `from` to `to` [m] in steps of `step`, without the rounding errors of sums.
/// Throws Error, with `field` before it, for a range without or with more than 10,000 of them.
std::vector<double> amplitude_range(const std::string& field, double from, double to, double step);

/// Throws Error as WheelsetSearch and curve_of_amplitudes.
ConicityResult find_conicity(const ConicityInput& input, const WheelsetSearch::Side& left,
                             const WheelsetSearch::Side& right, bool sides_are_alike);

/// Steering at the largest amplitude; empty without a curve's radius.
std::optional<double> steering_index(const ConicityInput& input, const ConicityResult& result);

/// The result as members of a JSON object: conicity over the amplitudes; rolling radius difference and so on in steps
/// of 0.1 mm, with the contact points on the profiles.
io::Json conicity_document(const ConicityInput& input, const ConicityResult& result, const WheelsetSearch::Side& left,
                           const WheelsetSearch::Side& right);
/// The units of these members.
io::Json conicity_units();

} // namespace microslip::cases
