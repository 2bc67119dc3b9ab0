#pragma once

#include "microslip/exact/newton/friction_newton.hpp"
#include "microslip/exact/normal/normal_problem.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// The discrete normal and tangential problem as one: find p_n and p = (px, py) with e = h - delta + u_n >= 0, p_n >=
/// 0, p_n e = 0, |p| <= mu p_n and, with the slip s = c + D (p, p_n), p = -mu p_n s/|s| where s is not zero. The normal
/// displacement u_n depends on p_n and p. Where a force is given, delta or the constant part of c is an unknown too.
struct CoupledFrictionProblem {
  CoupledResponse& response;
  std::span<const double> gap; ///< h [m]; infinite for elements that cannot come into contact
  NormalLoad load;
  std::span<const double> friction;                 ///< mu of the elements [-]
  std::span<const double> cx, cy;                   ///< slip without tractions and pressure
  double element_area;                              ///< [m^2]
  std::optional<double> force_x = {}, force_y = {}; ///< over Fn [-]; where given, cx or cy is known but for a constant
};

struct CoupledFrictionSolution {
  FrictionSolution friction;    ///< tractions and slip; its residual, steps, products and status are those of the whole
  std::vector<double> pressure; ///< p_n [Pa]
  double approach = 0;          ///< delta [m]
};

/// Solves for pressure and tractions at once by a semi-smooth Newton method for p_n - max(0, p_n - r e) = 0 and, as
/// FrictionNewton, p - P_g(p - rho s) = 0 with g = mu p_n (Alart & Curnier 1991). The residual is the 2-norm of both
/// over the elements, tractions in units of the mean friction, over that of the pressure. Cost: products with the
/// response, each three transforms there and three back.
class CoupledNewton {
public:
  struct Options {
    double tolerance = 1e-6;
    int most_steps = 200;
    int most_inner = 300;   ///< products in the linear solver of one step
    Progress progress = {}; ///< is told after each step and before each product; false ends the iteration
  };

  /// Pressure and tractions to begin with [Pa]; no tractions: zero.
  struct Start {
    std::span<const double> px, py, pressure;
  };

  CoupledFrictionSolution solve(const CoupledFrictionProblem& problem, const Options& options, const Start& start);

private:
  Gmres<double> gmres_;
};

} // namespace microslip
