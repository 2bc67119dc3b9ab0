#pragma once

#include "microslip/exact/newton/friction_newton.hpp"

#include <span>

namespace microslip {

struct TangOptions {
  double tolerance = 1e-6; ///< of FrictionSolution::residual
  int most_divisions = 100;
};

struct TangSolution : FrictionSolution {
  int divisions = 0; ///< into adhesion and slip
};

/// TANG, Kalker's active set algorithm for the tangential problem (Kalker 1990, section 4.3): for an assumed division
/// into adhesion and slip it solves s = 0 in adhesion, |p| = g and s parallel to p in slip by Newton's method; elements
/// of adhesion beyond their bound go to slip until there are none, then elements that slip in the direction of their
/// traction go to adhesion. It begins with adhesion everywhere. The plain reference beside FrictionNewton, for any
/// response. Where a force is given, solve_prescribed_force calls this method, and `divisions` counts all.
///
/// `start` is where it begins: tractions and, from them, the division; empty spans mean zero tractions. Throws Error
/// for options out of range.
TangSolution solve_tang(const FrictionProblem& problem, const TangOptions& options,
                        std::span<const double> start_px = {}, std::span<const double> start_py = {});

} // namespace microslip
