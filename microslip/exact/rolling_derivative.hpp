#pragma once

#include "microslip/exact/fitted_product.hpp"
#include "microslip/exact/fitted_response.hpp"
#include "microslip/exact/friction_newton.hpp"
#include "microslip/exact/linearised_friction.hpp"
#include "microslip/exact/rolling_preconditioner.hpp"
#include "microslip/numerics/gmres.hpp"

#include <span>
#include <vector>

namespace microslip {

/// By how much the tractions of steady rolling change when the slip without tractions changes: the implicit function
/// theorem for the equations F(p) = 0 of FrictionNewton, with forces not given. Solved in single precision, whose
/// rounding is far below what derivatives of forces are wanted to, with twice the speed of double precision.
class RollingDerivative {
public:
  RollingDerivative(const FittedResponse& response, const FittedContact& contact);

  /// Per unit of whatever changes.
  struct Change {
    std::vector<double> px, py; ///< of the tractions [Pa]
    std::vector<double> sx, sy; ///< of the slip
    long products = 0;
  };

  /// The solution of a problem with these traction bounds, about which all that follows is linear. Holds where no
  /// element is just between adhesion and slip.
  void linearise(std::span<const double> bound, const FrictionSolution& solution);

  /// The change for dcx, dcy, to a relative residual of `tolerance`, at least 1e-6. `start` is a change near the one
  /// looked for, with its slip's change for these dcx, dcy.
  Change solve(std::span<const double> dcx, std::span<const double> dcy, double tolerance,
               const Change* start = nullptr);

private:
  class Equations;

  double rho_;
  FittedProduct<float> product_; ///< rho D
  RollingPreconditioner<float> preconditioner_;
  LinearisedFriction<float> friction_;
  Gmres<float> gmres_;
};

} // namespace microslip
