#pragma once

#include "microslip/exact/newton/coupled_friction_problem.hpp"
#include "microslip/exact/newton/newton_budget.hpp"
#include "microslip/numerics/gmres.hpp"

#include <span>

namespace microslip {

/// Solves for pressure and tractions simultaneously by a semi-smooth Newton method for p_n - max(0, p_n - r e) = 0 and,
/// as FrictionNewton, p - P_g(p - rho s) = 0 with g = mu p_n (Alart & Curnier 1991). The residual is the 2-norm of both
/// over the elements, tractions in units of the mean friction, over that of the pressure. Cost: products with the
/// operator, each three transforms there and three back.
class CoupledNewton {
public:
  struct Options {
    double tolerance = 1e-6;
    int most_steps = 200;
    double shortest_step = 0;       ///< as of NewtonLimits
    NewtonBudget* budget = nullptr; ///< of the whole solve, if this is a part of one
    bool preconditioned = true;     ///< else slower, and at times where that does not converge
    Progress progress = {};         ///< called after each step and before each product; false ends the iteration
  };

  /// Begins with the start that has the least residual; each further one costs a product. Forces that no creepage gives
  /// end at once, with the pressure of the first: full_sliding().
  CoupledFrictionSolution solve(const CoupledFrictionProblem& problem, const Options& options,
                                std::span<const CoupledFrictionStart> starts);

private:
  Gmres<double> gmres_;
};

} // namespace microslip
