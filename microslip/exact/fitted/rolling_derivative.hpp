#pragma once

#include "microslip/exact/fitted/centred_slip.hpp"
#include "microslip/exact/fitted/fitted_operator.hpp"
#include "microslip/exact/newton/friction_newton.hpp"

#include <memory>
#include <span>
#include <vector>

namespace microslip {

/// Derivatives of the tractions of steady rolling with respect to the slip without tractions: the implicit function
/// theorem for the equations F(p) = 0 of FrictionNewton, with forces not given. Solved in single precision, which takes
/// less time and whose rounding is far below the accuracy wanted of derivatives of forces.
class RollingDerivative {
public:
  RollingDerivative(const FittedOperator& fitted_operator, const FittedContact& contact, const TransformPlans& plans);
  RollingDerivative(RollingDerivative&&) noexcept;
  RollingDerivative& operator=(RollingDerivative&&) noexcept;
  ~RollingDerivative();

  /// Per unit of whatever changes.
  struct Change {
    std::vector<double> px, py; ///< of the tractions [Pa]
    long products = 0;
  };

  /// The solution of a problem with these traction bounds and this slip, about which all that follows is linear. Holds
  /// where no element is just between adhesion and slip.
  void linearise(std::span<const double> bound, const FrictionSolution& solution, CentredSlip<float> slip);

  /// The change for dcx, dcy, to a relative residual of `tolerance`, at least 1e-6. Throws Stopped.
  Change solve(std::span<const double> dcx, std::span<const double> dcy, double tolerance,
               const Progress& progress = {});

private:
  class Equations;
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

} // namespace microslip
