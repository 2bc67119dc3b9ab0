#pragma once

#include "microslip/numerics/dual.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace microslip {

/// Coefficients of friction at slip velocities, as they are measured or sampled, and between them by monotone cubics
/// with a continuous slope (Fritsch & Butland 1984): mu(v) has no extremum but at the given velocities, and is constant
/// beyond the first and the last of them. Where a smooth mu(v) was sampled at distances h it is within O(h^3) of that,
/// O(h^2) at extrema.
class FrictionTable {
public:
  /// `slip_velocity` [m/s]: at least two, in [0, 1e6], ascending. `coefficient` [-]: one of each, in
  /// [0, FrictionLaw::largest_coefficient]. Throws Error with the place of a number that is not, "slip_velocities.3".
  FrictionTable(std::vector<double> slip_velocity, std::vector<double> coefficient);

  /// Samples mu(v) from 0 to `fastest` [m/s] > 0, so close that in the middle and at the quarters between any two
  /// samples it is within `accuracy` [-] > 0 of the cubic. `coefficient` is called some hundred times for a smooth
  /// mu(v), and never again. Throws Error for coefficients out of range, where mu(v) jumps, and if 100,000 samples are
  /// not enough.
  static FrictionTable sampled(const std::function<double(double slip_velocity)>& coefficient, double fastest,
                               double accuracy = 1e-6);

  const std::vector<double>& slip_velocities() const { return slip_velocities_; }
  const std::vector<double>& coefficients() const { return coefficients_; }

  /// mu(v), v >= 0 [m/s]; infinite gives the last one. Cost O(log n). `Real` is double, or Dual for the derivative.
  template <class Real> Real coefficient(const Real& slip_velocity) const;
  double largest() const { return *std::max_element(coefficients_.begin(), coefficients_.end()); }
  double least() const { return *std::min_element(coefficients_.begin(), coefficients_.end()); }

  friend bool operator==(const FrictionTable& one, const FrictionTable& other) {
    return one.slip_velocities_ == other.slip_velocities_ && one.coefficients_ == other.coefficients_;
  }

private:
  /// Powers of v - v_i that make up mu behind v_i.
  struct Cubic {
    double slope = 0, square = 0, cube = 0;
  };

  std::vector<double> slip_velocities_, coefficients_;
  std::vector<Cubic> cubics_; ///< one less than there are velocities
};

template <class Real> Real FrictionTable::coefficient(const Real& v) const {
  const auto next = std::upper_bound(slip_velocities_.begin(), slip_velocities_.end(), value_of(v));
  if (next == slip_velocities_.begin()) return Real(coefficients_.front());
  if (next == slip_velocities_.end()) return Real(coefficients_.back());
  const auto i = static_cast<std::size_t>(next - slip_velocities_.begin()) - 1;
  const Cubic& c = cubics_[i];
  const Real s = v - Real(slip_velocities_[i]);
  return Real(coefficients_[i]) + s * (Real(c.slope) + s * (Real(c.square) + s * c.cube));
}

} // namespace microslip
