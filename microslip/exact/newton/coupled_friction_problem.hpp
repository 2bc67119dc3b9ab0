#pragma once

#include "microslip/contact/normal_load.hpp"
#include "microslip/exact/halfspace/surface_operator.hpp"
#include "microslip/exact/newton/friction_problem.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// The discrete normal and tangential problem as one, (E1) and (E2): find p_n and p = (px, py) with e = h - delta + u_n
/// >= 0, p_n >= 0, p_n e = 0, |p| <= mu p_n and, with the slip s = c + D (p, p_n), p = -mu p_n s/|s| where s is not
/// zero. The normal displacement u_n depends on p_n and p. Where a force is given, delta or the constant part of c is
/// an unknown too.
struct CoupledFrictionProblem {
  CoupledOperator& coupled_operator;
  std::span<const double> gap; ///< h [m]; infinite for elements that cannot come into contact
  NormalLoad load;
  std::span<const double> friction;                 ///< mu of the elements [-]
  std::span<const double> cx, cy;                   ///< slip without tractions and pressure
  double element_area;                              ///< [m^2]
  std::optional<double> force_x = {}, force_y = {}; ///< over Fn [-]; where given, cx or cy is known up to a constant
  SlipDependentBound* slip_dependent = nullptr;     ///< instead of mu p_n; mu then tells the size of tractions only
};

struct CoupledFrictionSolution {
  FrictionSolution friction;    ///< tractions and slip; its residual, steps, products and status are those of the whole
  std::vector<double> pressure; ///< p_n [Pa]
  double approach = 0;          ///< delta [m]
};

/// Pressure and tractions to begin with [Pa]; no tractions: zero.
struct CoupledFrictionStart {
  std::span<const double> px, py, pressure;
};

} // namespace microslip
