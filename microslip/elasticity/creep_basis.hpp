#pragma once

#include "microslip/elasticity/layered_body.hpp"

#include <complex>
#include <span>
#include <vector>

namespace microslip {

/// Retardation times that describe the creep of any structure of some materials. At rest each of its responses is c0 +
/// sum of c_j/(1 + i omega T_j), and at the rate 1/T_j some modulus is not positive: so T_j lies between a relaxation
/// time and the retardation time above it, of some material. 1/(1 + i omega T) as a function of ln T is analytic for
/// |Im ln T| < pi/2: times at Chebyshev points of these ranges interpolate it, for all frequencies, with an error of
/// some rho^-n, rho = d + sqrt(1 + d^2), d = pi/ln(T_max/T_min).
class CreepBasis {
public:
  /// Times so many that the error is below 1e-10 of the response. None for elastic bodies.
  explicit CreepBasis(const LayeredBody& body);

  std::span<const double> times() const { return times_; } ///< T [s], ascending
  /// Frequencies [rad/s] at which `fit` takes a response; the first is 0.
  std::span<const double> frequencies() const { return frequencies_; }
  /// Finds amounts c with sum of c_m/(1 + i omega T_m) = creep(omega), the response less the instantaneous one:
  /// regularised least squares, of which the part that fits nothing is below 1e-9.
  void fit(std::span<const std::complex<double>> creep, std::span<double> amounts) const;

private:
  std::vector<double> times_, frequencies_;
  /// Q and R of the equations' matrix: columns, one after another, of real and imaginary parts in turn; columns of R.
  /// (Its inverse would multiply rounding by 1e9.)
  std::vector<double> orthogonal_, triangle_;
};

} // namespace microslip
