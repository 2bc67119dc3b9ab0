#pragma once

#include "microslip/exact/newton/coupled_friction_problem.hpp"
#include "microslip/exact/newton/friction_problem.hpp"

#include <optional>
#include <span>

namespace microslip {

/// If no creepage gives the forces that a problem prescribes, as they are beyond the sum of its bounds, or of the
/// largest that any slip allows: everything slides in their direction, status no_solution, and the residual is how much
/// they are beyond it, over it. With one force given this is all that is known whatever the other creepage is: the sum
/// of the bounds is what tractions along the force would have.
std::optional<FrictionSolution> full_sliding(const FrictionProblem& problem);

/// Full sliding of a problem whose pressure is to be found. The sum of its bounds is not known then, but that it is at
/// most the largest coefficient of friction times the normal force. The tractions are those that belong to `pressure`.
std::optional<FrictionSolution> full_sliding(const CoupledFrictionProblem& problem, std::span<const double> pressure);

} // namespace microslip
