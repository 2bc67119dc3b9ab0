#pragma once

#include "microslip/exact/newton/friction_newton.hpp"

#include <cmath>

namespace microslip {

/// Fills in the slip, the states and the residual of a solution whose tractions and constants are known. One product
/// with the matrix. A traction slides if it is on its bound and |p - rho s| > g. A force that is given enters the
/// residual as in FrictionNewton: what the mean traction lacks, once for each of sqrt(n) elements.
void find_residual(const FrictionProblem& problem, FrictionSolution& solution);

/// |p| = g but for rounding.
inline bool on_bound(double px, double py, double g) {
  return std::abs(std::hypot(px, py) - g) <= 1e-14 * g;
}

/// The 2-norm of g over the elements [Pa].
double bound_norm(const FrictionProblem& problem);

} // namespace microslip
