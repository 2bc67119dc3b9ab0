#pragma once

#include "microslip/exact/friction_newton.hpp"

namespace microslip {

/// Fills in the slip, the states and the residual of a solution whose tractions and constants are known. One product
/// with the matrix. A force that is given enters the residual as in FrictionNewton: what the mean traction lacks, once
/// for each of sqrt(n) elements.
void find_residual(const FrictionProblem& problem, FrictionSolution& solution);

/// The 2-norm of g over the elements [Pa].
double bound_norm(const FrictionProblem& problem);

} // namespace microslip
