#pragma once

#include "microslip/exact/newton/friction_problem.hpp"
#include "microslip/exact/newton/newton_budget.hpp"
#include "microslip/numerics/gmres.hpp"
#include "microslip/progress.hpp"

#include <optional>

namespace microslip {

inline constexpr int most_newton_steps = 100;

/// Solves F(p) = p - P_g(p - rho s(p)) = 0 (E16), where P_g projects each element's traction on the disk of radius g,
/// by a semi-smooth Newton method (FrictionEquations, take_newton_steps).
class FrictionNewton {
public:
  struct Options {
    double tolerance = 1e-6; ///< of the residual of FrictionSolution
    int most_steps = most_newton_steps;
    double shortest_step = 0;       ///< as of NewtonLimits
    NewtonBudget* budget = nullptr; ///< of the whole solve, if this is a part of one
    /// A step's state before. The residual then falls below `tolerance` times that of these tractions, too, but not
    /// below 1e-12: a step however small is solved to its scale, and nothing of it is lost in the next one.
    std::optional<TractionsView> before = {};
    Progress progress = {}; ///< called after each step; false ends the iteration
  };

  /// Forces that no creepage gives end at once: full_sliding().
  FrictionSolution solve(const FrictionProblem& problem, const Options& options, const FrictionStart& start = {});

private:
  Gmres<double> gmres_;
};

} // namespace microslip
