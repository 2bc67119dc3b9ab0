#pragma once

#include "microslip/progress.hpp"
#include "microslip/railway/geometry/wheelset_contact.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// The contact of a wheelset over its lateral displacement, ascending. Where a contact jumps, two entries are closer to
/// each other than 1e-9 m. Ends early where a wheel leaves its rail.
using WheelsetCurve = std::vector<WheelsetContact>;

/// Curve from `from` to `to` [m], from < to, with 0 between or at an end: at steps of `step` and between them, as fine
/// as the rolling radius difference needs to be linear in between within 1e-7 m. Throws Error for a range that is
/// empty, and if there is no contact at 0. Cost 100 to 1000 contacts per mm; `progress` is called before each, without
/// a fraction; if it returns false Stopped is thrown.
WheelsetCurve wheelset_curve(WheelsetSearch& search, double from, double to, RollRule rule = RollRule::equilibrium,
                             double yaw = 0, const Progress& progress = {}, double step = 1e-4);

/// The curve that motions with amplitudes [m] up to the largest one need. Sides that differ run beside the track's
/// middle. Throws Error as above.
WheelsetCurve curve_of_amplitudes(WheelsetSearch& search, double largest_amplitude, bool sides_are_alike,
                                  RollRule rule = RollRule::equilibrium, const Progress& progress = {});

/// The rolling radius difference over the lateral displacement, linear between values, with its integral.
class RollingRadiusDifference {
public:
  struct Value {
    double lateral = 0;    ///< [m]
    double difference = 0; ///< [m], left less right radius
  };

  /// Throws Error for fewer than two values, and lateral displacements that descend.
  explicit RollingRadiusDifference(std::vector<Value> values);
  explicit RollingRadiusDifference(const WheelsetCurve& curve);

  double from() const { return values_.front().lateral; }
  double to() const { return values_.back().lateral; }
  /// [m]; at a jump the value above it.
  double at(double lateral) const;
  /// [m^2], from the first value.
  double integral(double lateral) const;

private:
  std::size_t before(double lateral) const;

  std::vector<Value> values_;
  std::vector<double> integrals_;
};

/// Dimensions that relate a rolling radius difference to the wheelset's motion.
struct WheelsetBase {
  double contact_distance = 1.5; ///< e [m], between both contacts, > 0
  double nominal_radius = 0.46;  ///< r0 [m], > 0
};

/// Period of the motion of a free wheelset that rolls without slip on straight track.
struct KinematicOscillation {
  double from = 0, to = 0; ///< [m], extreme lateral displacements, 2 amplitudes apart
  double wavelength = 0;   ///< [m]
  double conicity = 0;     ///< [-], of the conical wheels that have the same wavelength (Klingel, (W3))
};

/// The exact solution of y'' + dr(y)/(e r0) = 0 with the given amplitude [m]: (y')^2/2 = (S(y_max) - S(y))/(e r0) with
/// S' = dr, S(y_min) = S(y_max), y_max - y_min = 2 amplitudes; half a wavelength is the integral of dy/y' over [y_min,
/// y_max], with y = (y_min + y_max)/2 + amplitude sin t by the midpoint rule with 4000 points; equivalent conicity
/// gamma = (2 pi/L)^2 e r0/2 (EN 15302). Empty if the displacements are not covered or no such motion exists, as with
/// wheels that steer outward; cylindrical wheels have the conicity 0 and an infinite wavelength. Throws Error for an
/// amplitude or base that is not positive.
std::optional<KinematicOscillation> kinematic_oscillation(const RollingRadiusDifference& difference, double amplitude,
                                                          const WheelsetBase& base);

/// Change of the equivalent conicity from 2 to 4 mm of amplitude, per metre [1/m]; EN 15302 gives it per millimetre.
/// Empty where one of both is.
std::optional<double> nonlinearity_parameter(const RollingRadiusDifference& difference, const WheelsetBase& base);

/// The rolling radius difference at a lateral displacement over e r0/R, which rolls without slip through a curve of
/// radius R [m]: above 1 the wheelset can steer itself radially.
double radial_steering_index(const RollingRadiusDifference& difference, double lateral, double curve_radius,
                             const WheelsetBase& base);

} // namespace microslip
