#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/exact/element_grid.hpp"
#include "microslip/exact/friction_newton.hpp"
#include "microslip/exact/normal_problem.hpp"

#include <span>

namespace microslip {

/// NORM, Kalker's active set algorithm for the normal problem (Kalker 1990, section 4.3): the equations e = 0 in an
/// assumed contact are solved by conjugate gradients, elements with a negative pressure leave it until there are none,
/// then elements that overlap enter. The plain reference beside NormalProblem: same input, same result and residual,
/// O(N^2) operations for a product, no transforms. `iterations` counts the sets. Throws Error as NormalProblem does.
NormalSolution solve_norm(const CombinedMaterial& material, const ElementGrid& grid, std::span<const double> gap,
                          const NormalLoad& load, double tolerance = 1e-8);

struct TangSolution : FrictionSolution {
  int sets = 0; ///< divisions into adhesion and slip
};

/// TANG, Kalker's active set algorithm for the tangential problem (Kalker 1990, section 4.3): with an assumed division
/// into adhesion and slip it solves s = 0 in adhesion and |p| = g, s parallel to p in slip by Newton's method; elements
/// of adhesion beyond their bound go to slip until there are none, then elements that slip in the direction of their
/// traction go to adhesion. It begins with adhesion everywhere, or with the division that tractions to start with
/// have. The plain reference beside FrictionNewton, for any response. Where a force is given, solve_prescribed_force
/// calls this method, and `sets` counts all. Throws Error for a tolerance that is not positive.
TangSolution solve_tang(const FrictionProblem& problem, double tolerance = 1e-6, std::span<const double> start_px = {},
                        std::span<const double> start_py = {});

} // namespace microslip
