#include "microslip/railway/geometry/conicity.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace microslip {
namespace {

/// Adds what is between two points, and the second one.
class Refiner {
public:
  Refiner(WheelsetSearch& search, RollRule rule, double yaw, const Progress& progress)
      : search_(search), rule_(rule), yaw_(yaw), progress_(progress) {}

  WheelsetContact at(double lateral) {
    go_on(progress_, 0);
    return search_.solve(lateral, yaw_, rule_);
  }

  /// False if there is no contact further on.
  bool extend(WheelsetCurve& curve, double to) { return add(curve, at(to)); }

private:
  bool add(WheelsetCurve& curve, const WheelsetContact& next) {
    if (next.status != Status::ok) return false;
    const WheelsetContact last = curve.back();
    const double middle = (last.lateral + next.lateral) / 2, width = std::abs(next.lateral - last.lateral);
    const WheelsetContact between = at(middle);
    if (between.status != Status::ok) return false;
    const double straight = (last.rolling_radius_difference() + next.rolling_radius_difference()) / 2;
    const double error = std::abs(between.rolling_radius_difference() - straight);
    constexpr double tolerance = 1e-7, jump = 1e-9;
    if (error <= tolerance || width < jump) {
      curve.push_back(next);
      return true;
    }
    return add(curve, between) && add(curve, next);
  }

  WheelsetSearch& search_;
  RollRule rule_;
  double yaw_;
  const Progress& progress_;
};

void check(const WheelsetBase& base) {
  require_positive("contact_distance", base.contact_distance, "m");
  require_positive("nominal_radius", base.nominal_radius, "m");
}

/// Returns whether the radii stay the same on either side of the middle, to rounding.
bool is_cylindrical(const RollingRadiusDifference& difference, double amplitude) {
  if (!(difference.from() <= -amplitude && amplitude <= difference.to())) return false;
  constexpr int points = 200;
  for (int k = -points; k <= points; ++k)
    if (std::abs(difference.at(amplitude * k / points)) > 1e-10) return false;
  return true;
}

} // namespace

WheelsetCurve wheelset_curve(WheelsetSearch& search, double from, double to, RollRule rule, double yaw,
                             const Progress& progress, double step) {
  require_between("from", from, "m", -1, 0);
  require_between("to", to, "m", 0, 1);
  require_positive("step", step, "m");
  if (!(from < to)) throw Error("wheelset curve: from must be less than to");
  Refiner refiner(search, rule, yaw, progress);
  const auto side = [&](double end) {
    WheelsetCurve curve{refiner.at(0)};
    if (curve.front().status != Status::ok)
      throw Error("wheelset curve: no contact of both wheels in the middle of the track");
    const int steps = static_cast<int>(std::ceil(std::abs(end) / step - 1e-9));
    for (int k = 1; k <= steps; ++k)
      if (!refiner.extend(curve, end * k / steps)) break;
    return curve;
  };
  WheelsetCurve curve = side(from);
  std::reverse(curve.begin(), curve.end());
  const WheelsetCurve rest = side(to);
  curve.insert(curve.end(), rest.begin() + 1, rest.end());
  return curve;
}

WheelsetCurve curve_of_amplitudes(WheelsetSearch& search, double largest_amplitude, bool sides_are_alike, RollRule rule,
                                  const Progress& progress) {
  const double reach = largest_amplitude + (sides_are_alike ? 1e-4 : 5e-3);
  return wheelset_curve(search, -reach, reach, rule, 0, progress);
}

RollingRadiusDifference::RollingRadiusDifference(std::vector<Value> values) : values_(std::move(values)) {
  if (values_.size() < 2) throw Error("rolling radius difference: fewer than two values");
  require_finite("lateral", values_.front().lateral, "m");
  require_finite("rolling radius difference", values_.front().difference, "m");
  integrals_.push_back(0);
  for (std::size_t k = 1; k < values_.size(); ++k) {
    const Value &a = values_[k - 1], &b = values_[k];
    require_finite("rolling radius difference", b.difference, "m");
    if (!(b.lateral >= a.lateral)) throw Error("rolling radius difference: lateral displacements must ascend");
    integrals_.push_back(integrals_.back() + (b.lateral - a.lateral) * (a.difference + b.difference) / 2);
  }
}

RollingRadiusDifference::RollingRadiusDifference(const WheelsetCurve& curve)
    : RollingRadiusDifference([&] {
        std::vector<Value> values;
        for (const WheelsetContact& c : curve) values.push_back({c.lateral, c.rolling_radius_difference()});
        return values;
      }()) {}

std::size_t RollingRadiusDifference::before(double lateral) const {
  const auto after = std::upper_bound(values_.begin() + 1, values_.end() - 1, lateral,
                                      [](double y, const Value& v) { return y < v.lateral; });
  return static_cast<std::size_t>(after - values_.begin()) - 1;
}

double RollingRadiusDifference::at(double lateral) const {
  const std::size_t k = before(lateral);
  const Value &a = values_[k], &b = values_[k + 1];
  return a.difference + (b.difference - a.difference) * (lateral - a.lateral) / (b.lateral - a.lateral);
}

double RollingRadiusDifference::integral(double lateral) const {
  const std::size_t k = before(lateral);
  return integrals_[k] + (lateral - values_[k].lateral) * (values_[k].difference + at(lateral)) / 2;
}

std::optional<KinematicOscillation> kinematic_oscillation(const RollingRadiusDifference& difference, double amplitude,
                                                          const WheelsetBase& base) {
  require_positive("amplitude", amplitude, "m");
  check(base);
  if (is_cylindrical(difference, amplitude))
    return KinematicOscillation{-amplitude, amplitude, std::numeric_limits<double>::infinity(), 0};
  // the extremes, at which the integral is the same: the midpoint by bisection
  const auto excess = [&](double middle) {
    return difference.integral(middle + amplitude) - difference.integral(middle - amplitude);
  };
  double low = difference.from() + amplitude, high = difference.to() - amplitude;
  if (!(low <= high) || excess(low) > 0 || excess(high) < 0) return std::nullopt;
  for (int k = 0; k < 100 && high - low > 1e-16; ++k) {
    const double middle = (low + high) / 2;
    (excess(middle) > 0 ? high : low) = middle;
  }
  const double middle = (low + high) / 2;
  KinematicOscillation motion{middle - amplitude, middle + amplitude, 0, 0};

  const double energy = difference.integral(motion.to), product = base.contact_distance * base.nominal_radius;
  constexpr int points = 4000;
  double half = 0;
  for (int k = 0; k < points; ++k) {
    const double t = std::numbers::pi * ((k + 0.5) / points - 0.5);
    const double rest = energy - difference.integral(middle + amplitude * std::sin(t));
    if (!(rest > 0)) return std::nullopt;
    half += amplitude * std::cos(t) / std::sqrt(2 * rest / product) * (std::numbers::pi / points);
  }
  motion.wavelength = 2 * half;
  const double wavenumber = 2 * std::numbers::pi / motion.wavelength;
  motion.conicity = wavenumber * wavenumber * product / 2;
  return motion;
}

std::optional<double> nonlinearity_parameter(const RollingRadiusDifference& difference, const WheelsetBase& base) {
  const auto small = kinematic_oscillation(difference, 2e-3, base),
             large = kinematic_oscillation(difference, 4e-3, base);
  if (!small || !large) return std::nullopt;
  return (large->conicity - small->conicity) / 2e-3;
}

double radial_steering_index(const RollingRadiusDifference& difference, double lateral, double curve_radius,
                             const WheelsetBase& base) {
  check(base);
  require_positive("curve_radius", curve_radius, "m");
  return difference.at(lateral) * curve_radius / (base.contact_distance * base.nominal_radius);
}

} // namespace microslip
