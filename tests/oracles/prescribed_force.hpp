#pragma once

#include "microslip/exact/newton/friction_newton.hpp"

#include <functional>
#include <span>

namespace microslip {

/// Solves a problem without prescribed forces to a tolerance, from tractions to start with (empty: zero).
using FrictionSolver =
    std::function<FrictionSolution(const FrictionProblem& problem, double tolerance, std::span<const double> start_px,
                                   std::span<const double> start_py)>;

/// Solves a problem with one or two forces prescribed by a solver that does not know of them: Newton's method on the
/// constants, with derivatives by differences and a step that is halved until the forces come nearer. Without forces it
/// is one call of the solver. The plain reference beside FrictionNewton, for which the constants are unknowns like
/// others.
FrictionSolution solve_prescribed_force(const FrictionProblem& problem, double tolerance, const FrictionSolver& solve,
                                        std::span<const double> start_px = {}, std::span<const double> start_py = {});

} // namespace microslip
