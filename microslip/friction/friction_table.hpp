#pragma once

#include "microslip/numerics/dual.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace microslip {

/// Coefficients of friction at the nodes of a grid.
struct FrictionGrid {
  std::vector<double> slip_velocities;   ///< [m/s], at least two, in [0, largest_velocity], ascending
  std::vector<double> pressures = {};    ///< [Pa], >= 0, ascending; none: friction does not depend on the pressure
  std::vector<double> temperatures = {}; ///< [deg C], ascending; none: nor on the surfaces' temperature
  /// [-], one for each node, in [0, FrictionLaw::largest_coefficient]: those of all velocities at the first pressure
  /// and temperature, then at the next pressure, and so on.
  std::vector<double> coefficients = {};

  friend bool operator==(const FrictionGrid&, const FrictionGrid&) = default;
};

/// Coefficients of friction at slip velocities, as they are measured or sampled, and between them by monotone cubics
/// with a continuous slope (Fritsch & Butland 1984): mu(v) has no extremum but at the given velocities, and is constant
/// beyond the first and the last of them. Where a smooth mu(v) was sampled at distances h it is within O(h^3) of that,
/// O(h^2) at extrema. Between pressures and temperatures mu is linear, beyond them constant.
class FrictionTable {
public:
  // Beyond these numbers of the axes are taken for mistakes; none but a temperature is negative.
  static constexpr double largest_velocity = 1e6;                               ///< [m/s]
  static constexpr double largest_pressure = 1e15;                              ///< [Pa]
  static constexpr double lowest_temperature = -274, highest_temperature = 1e6; ///< [deg C]

  /// Throws Error with the place of a number that is out of range, "slip_velocities.3".
  explicit FrictionTable(FrictionGrid grid);
  /// mu(v) alone.
  FrictionTable(std::vector<double> slip_velocities, std::vector<double> coefficients);

  /// Samples mu(v) from 0 to `fastest` [m/s] in [1e-6, 1e6], so close that in the middle and at the quarters between
  /// any two samples it is within `accuracy` [-] > 0 of the cubic. `coefficient` is called some hundred times for a
  /// smooth mu(v), and never again. Throws Error for coefficients out of range, where mu(v) jumps, and if 100,000
  /// samples are not enough.
  static FrictionTable sampled(const std::function<double(double slip_velocity)>& coefficient, double fastest,
                               double accuracy = 1e-6);

  const FrictionGrid& grid() const { return grid_; }
  bool depends_on_pressure() const { return !grid_.pressures.empty(); }
  bool depends_on_temperature() const { return !grid_.temperatures.empty(); }
  double largest() const { return *std::max_element(grid_.coefficients.begin(), grid_.coefficients.end()); }
  /// The same at a pressure [Pa] as far as it is linear: not less than mu there.
  double largest(double pressure) const;
  double least() const { return *std::min_element(grid_.coefficients.begin(), grid_.coefficients.end()); }

  /// mu(v), v >= 0 [m/s], at the lowest pressure and temperature; infinite gives the last one. Cost O(log n). `Real` is
  /// double, or Dual for the derivative.
  template <class Real> Real coefficient(const Real& slip_velocity) const { return of_curve(slip_velocity, 0); }
  /// mu(v, p, T), p [Pa], T [deg C].
  template <class Real>
  Real coefficient(const Real& slip_velocity, const Real& pressure, const Real& temperature) const;
  /// The table of mu(v) at a pressure [Pa] and a temperature [deg C].
  FrictionTable at(double pressure, double temperature) const;

  friend bool operator==(const FrictionTable& one, const FrictionTable& other) { return one.grid_ == other.grid_; }

private:
  /// Powers of v - v_i that make up mu behind v_i.
  struct Cubic {
    double slope = 0, square = 0, cube = 0;
  };
  /// Where a number lies between the nodes of an axis.
  template <class Real> struct Place {
    std::size_t node = 0;
    Real share; ///< of the next node, in [0, 1]; 0 at and beyond the last one
  };

  template <class Real> static Place<Real> place(const std::vector<double>& axis, const Real& value);
  template <class Real> Real of_curve(const Real& slip_velocity, std::size_t curve) const;
  template <class Real>
  Real at_temperature(const Real& slip_velocity, const Place<Real>& pressure, std::size_t temperature) const;

  FrictionGrid grid_;
  std::vector<Cubic> cubics_; ///< of each curve one less than there are velocities
};

template <class Real>
FrictionTable::Place<Real> FrictionTable::place(const std::vector<double>& axis, const Real& value) {
  const auto next = std::upper_bound(axis.begin(), axis.end(), value_of(value));
  if (next == axis.begin()) return {0, Real(0.0)};
  const auto node = static_cast<std::size_t>(next - axis.begin()) - 1;
  if (next == axis.end()) return {node, Real(0.0)};
  return {node, (value - Real(axis[node])) / Real(axis[node + 1] - axis[node])};
}

template <class Real> Real FrictionTable::of_curve(const Real& v, std::size_t curve) const {
  const std::vector<double>& velocities = grid_.slip_velocities;
  const double* mu = grid_.coefficients.data() + curve * velocities.size();
  const auto next = std::upper_bound(velocities.begin(), velocities.end(), value_of(v));
  if (next == velocities.begin()) return Real(mu[0]);
  const auto i = static_cast<std::size_t>(next - velocities.begin()) - 1;
  if (next == velocities.end()) return Real(mu[i]);
  const Cubic& c = cubics_[curve * (velocities.size() - 1) + i];
  const Real s = v - Real(velocities[i]);
  return Real(mu[i]) + s * (Real(c.slope) + s * (Real(c.square) + s * c.cube));
}

template <class Real>
Real FrictionTable::at_temperature(const Real& v, const Place<Real>& pressure, std::size_t temperature) const {
  const std::size_t curve = temperature * std::max(std::size_t{1}, grid_.pressures.size()) + pressure.node;
  const Real mu = of_curve(v, curve);
  return value_of(pressure.share) > 0 ? mu + pressure.share * (of_curve(v, curve + 1) - mu) : mu;
}

template <class Real>
Real FrictionTable::coefficient(const Real& v, const Real& pressure, const Real& temperature) const {
  const Place<Real> p = place(grid_.pressures, pressure), t = place(grid_.temperatures, temperature);
  const Real mu = at_temperature(v, p, t.node);
  return value_of(t.share) > 0 ? mu + t.share * (at_temperature(v, p, t.node + 1) - mu) : mu;
}

} // namespace microslip
