#pragma once

#include "microslip/exact/newton/coupled_friction_problem.hpp"
#include "microslip/exact/newton/linearised_friction.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// The equations F(x) = 0 of a CoupledFrictionProblem as take_newton_steps has them, for all n elements:
/// p - P_g(p - rho s) = 0 with g = mu p_n (B3), p_n - max(0, p_n - r e) = 0 (B2) and those of the prescribed forces,
/// where rho and r are one over the operator's scales, rho more where a slip-dependent bound needs it.
/// Unknowns x are px and py in units of the mean friction, p_n, and then what forces determine, in other units:
/// delta and the constants of cx, cy. The response of x is the slip and the deformed gap: sx, sy, e. A residual in
/// tractions counts in units of the mean friction.
class CoupledEquations {
public:
  using Real = double;

  /// Units are found from a pressure [Pa] near the solution's. Without a preconditioner rho and r are one over the
  /// operator's diagonal entries.
  CoupledEquations(const CoupledFrictionProblem& problem, std::span<const double> pressure, bool preconditioned = true);

  std::size_t size() const { return size_; }
  std::size_t responses() const { return 3 * n_; }
  /// The norm of the pressure, in which |F| counts.
  double scale() const { return scale_; }
  /// Strictness as of FrictionEquations.
  double strictness() const;

  /// Unknowns and response to begin with.
  void start(const CoupledFrictionStart& from, std::span<double> unknowns, std::span<double> response);
  /// The unknowns and the response of a solution. One product.
  void take(const CoupledFrictionSolution& solution, std::span<double> unknowns, std::span<double> response);
  /// Slip and deformed gap. One product.
  void find_response(std::span<const double> unknowns, std::span<double> response);
  /// Their change for a change of the unknowns. One product.
  void respond(std::span<const double> unknowns, std::span<double> response);
  /// The linear systems' right preconditioner: the operator's for the pressure of the elements in contact and for the
  /// part of the tractions that slip can change. Tractions that slide follow the pressure; approach and constants are
  /// such that the equations of the forces hold.
  void precondition(std::span<double> unknowns);
  /// F; returns its norm.
  double evaluate(std::span<const double> v, std::span<const double> response, std::span<double> f);
  /// Fixes contact, adhesion, slip and directions for the derivative at this point.
  void linearise(std::span<const double> v, std::span<const double> response);
  /// Extent to which the constants can move the tractions, about the point of linearise(): 1 where all adheres.
  double mean_alpha() const { return mean_alpha_; }
  /// The derivative of F times a vector v of unknowns whose response is given. `damping` as in FrictionEquations.
  void derivative(std::span<const double> v, std::span<const double> response, double damping, std::span<double> out);

  /// Adds what a change of the load [N] takes off F, where it is given.
  void add_load(double change, std::span<double> f) const;
  /// Tractions and pressure of a change of the unknowns [Pa].
  std::array<std::vector<double>, 3> fields_of(std::span<const double> unknowns) const;

  /// Pressure, tractions and slip of the elements in contact, approach and constants; obeys all bounds to rounding.
  CoupledFrictionSolution solution(std::span<const double> v, std::span<const double> response);

private:
  struct Point;
  Point point(std::span<const double> v, std::span<const double> response, std::size_t k) const;
  void find_sizes(std::span<const double> v, std::span<const double> response);
  void find_bounds(std::span<const double> v, std::span<const double> response);
  void find_bound_changes(std::span<const double> v, std::span<const double> response);
  void choose_constants(std::span<double> unknowns, std::span<double> response) const;
  void find_responses_to_constants();
  void precondition_pressure(std::span<double> pressure);
  void precondition_tractions(std::span<double> tractions);
  void follow_pressure(std::span<double> unknowns);
  void satisfy_load(std::span<double> unknowns) const;
  void satisfy_forces(std::span<double> unknowns) const;

  CoupledFrictionProblem problem_;
  std::size_t n_, size_ = 0;
  bool preconditioned_;
  double rho_, normal_rho_, scale_ = 0;
  double unit_ = 1; ///< of tractions: the mean friction, so that they weigh as much as the pressure
  double delta_unit_ = 1, constant_unit_ = 1, row_unit_ = 1;
  std::optional<std::size_t> delta_;    ///< index of the unknown approach
  std::optional<std::size_t> force_[2]; ///< and of the unknown constants
  LinearisedFriction<double> friction_; ///< in units of the tractions
  std::vector<char> in_contact_, under_pressure_;
  double mean_alpha_ = 1;
  std::vector<double> bound_, bound_change_; ///< at the last point, in units of the tractions
  std::vector<double> pressure_change_;      ///< [Pa]
  /// Response of the preconditioner to a unit of the approach, pressure, and of each constant, tractions.
  std::vector<double> by_delta_;
  std::array<std::vector<double>, 2> by_constant_;
  std::vector<double> change_;                     ///< of the tractions
  std::vector<double> px_, py_;                    ///< [Pa]
  std::vector<double> sizes_, pressure_, q_, own_; ///< |z|, p_n, q [Pa], dq/d|z| of a slip-dependent bound
};

} // namespace microslip
