#pragma once

#include "microslip/exact/newton/coupled_equations.hpp"
#include "microslip/exact/newton/semismooth_newton.hpp"
#include "microslip/numerics/gmres.hpp"

#include <span>
#include <vector>

namespace microslip {

/// Derivatives of tractions and pressure at a solution of a CoupledFrictionProblem, by the implicit function theorem
/// for the equations of CoupledEquations: contact, adhesion, slip and its direction's share are those of the solution.
/// They hold where no element is just between two states. Not for a bound that depends on the slip, nor for prescribed
/// forces. What the problem refers to must outlive this.
class CoupledDerivative {
public:
  CoupledDerivative(const CoupledFrictionProblem& problem, const CoupledFrictionSolution& solution);

  /// Per unit of whatever changes.
  struct Change {
    std::vector<double> px, py, pressure; ///< [Pa]
  };

  /// The change by one of the slip without tractions, dcx and dcy, and of the load, to a relative residual of
  /// `tolerance`. Cost: some tens of products. Throws Stopped.
  Change solve(std::span<const double> dcx, std::span<const double> dcy, double dload, double tolerance,
               const Progress& progress = {});

private:
  CoupledFrictionProblem problem_;
  CoupledEquations equations_;
  Gmres<double> gmres_;
  LinearisedProblem<CoupledEquations> linearised_;
};

} // namespace microslip
