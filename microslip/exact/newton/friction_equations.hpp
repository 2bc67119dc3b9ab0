#pragma once

#include "microslip/exact/newton/friction_problem.hpp"
#include "microslip/exact/newton/linearised_friction.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// The equations F(x) = 0 of a FrictionProblem as take_newton_steps has them, for its n elements in contact:
/// p - P_g(p - rho s) = 0 (E16), where P_g projects an element's traction on the disk of radius g and rho is one over
/// the operator's scale, or more where a slip-dependent bound needs it, and, where forces are prescribed, an
/// equation (E20) for each. Unknowns x are px of these elements, then py, then the unknown constants of c in units of
/// their own; the response of x is the slip c + D p, sx and then sy. The derivative is that of LinearisedFriction.
class FrictionEquations {
public:
  using Real = double;

  explicit FrictionEquations(const FrictionProblem& problem);

  std::size_t size() const { return 2 * n_ + forces_.size(); }
  std::size_t responses() const { return 2 * n_; }
  /// |g|, in which |F| counts.
  double scale() const { return scale_; }
  /// Factor by which |F| must be smaller for |p - P_g(p - s/D_kk)| to be as small as wanted, with the operator's
  /// diagonal, in which a solution's residual is measured: F grows at most as rho does.
  double strictness() const { return std::max(1.0, 1 / (rho_ * problem_.slip_operator.diagonal())); }

  /// Unknowns and slip to begin with. The derivatives of `from`, if it has them, hold until the next start.
  void start(const FrictionStart& from, std::span<double> unknowns, std::span<double> slip);
  /// The change D dp + constants of the slip for a change of the unknowns. One product.
  void respond(std::span<const double> unknowns, std::span<double> slip_change) {
    respond(unknowns, slip_change, &SlipOperator::apply);
  }
  /// Whether products in single precision pay, which costs another one in double for each Newton step.
  bool is_rough() const { return size() >= rough_unknowns && problem_.slip_operator.has_rough_product(); }
  void respond_roughly(std::span<const double> unknowns, std::span<double> slip_change) {
    respond(unknowns, slip_change, &SlipOperator::apply_roughly);
  }
  /// F; returns its norm.
  double evaluate(std::span<const double> unknowns, std::span<const double> slip, std::span<double> f);
  /// Fixes adhesion, slip and directions for the derivative at this point, and estimates the tractions' derivatives
  /// with respect to unknown constants if they are not given.
  void linearise(std::span<const double> unknowns, std::span<const double> slip);
  /// Extent to which the constants can move the tractions, about the point of linearise(): 1 where all adheres.
  double mean_alpha() const { return friction_.mean_alpha(); }
  /// The derivative of F times a vector v of unknowns whose change of slip is given. `damping` keeps the constants'
  /// steps finite where everything slides: there the forces do not depend on them, and the matrix is singular.
  void derivative(std::span<const double> v, std::span<const double> slip_change, double damping,
                  std::span<double> out);
  /// The linear systems' right preconditioner: turns a vector that GMRES works with into unknowns.
  void precondition(std::span<double> unknowns);

  /// Tractions P_g(p - rho s), which differ from p by F and obey the bound to rounding, slip, states, constants, and
  /// the residual.
  FrictionSolution solution(std::span<const double> unknowns, std::span<const double> slip);

private:
  using Apply = void (SlipOperator::*)(std::span<const double>, std::span<const double>, std::span<double>,
                                       std::span<double>);

  void respond(std::span<const double> unknowns, std::span<double> slip_change, Apply apply);
  double evaluate(double rho, std::span<const double> unknowns, std::span<const double> slip,
                  std::span<double> f) const;
  void find_sizes(std::span<const double> unknowns, std::span<const double> slip);
  void find_bounds(std::span<const double> unknowns, std::span<const double> slip);
  TractionsView spread(std::span<const double> tractions);
  void add_constants(std::span<double> slip) const;
  void choose_constants(std::span<double> unknowns, std::span<double> slip) const;
  void precondition_tractions(std::span<double> unknowns);
  bool apply_preconditioner();
  void satisfy_forces(std::span<double> unknowns) const;
  double mean_force(std::size_t i, std::span<const double> px, std::span<const double> py) const;
  void use_derivatives(const std::array<TractionsView, 2>& by_constants);
  void estimate_derivatives();
  bool find_force_slopes();

  bool is_whole() const { return n_ == problem_.bound.size(); } ///< whether all elements are in contact
  double share(std::size_t k) const {
    return problem_.constant_share.empty() ? 1 : problem_.constant_share[elements_[k]];
  }
  double area(std::size_t k) const { return problem_.area_share.empty() ? 1 : problem_.area_share[elements_[k]]; }

  FrictionProblem problem_;
  double rho_, scale_ = 0;
  std::array<double, 2> unit_ = {}; ///< of the unknown constants
  std::size_t n_ = 0;
  std::vector<std::size_t> elements_; ///< in contact
  std::vector<std::size_t> forces_;   ///< directions in which the force is given
  /// Derivatives of the tractions with respect to the constants of the given forces, px and then py.
  std::array<std::vector<double>, 2> by_constants_ = {};
  bool derivatives_given_ = false, derivatives_known_ = false; ///< all of them
  std::array<std::array<double, 2>, 2> force_slope_ = {};      ///< of each force's equation with each constant
  std::vector<double> g_;                                      ///< if it depends on the slip that of the last point
  LinearisedFriction<double> friction_{0};
  std::vector<double> change_;                                ///< of the tractions
  std::vector<double> size_change_;                           ///< of |z|, for a slip-dependent bound
  std::vector<double> wide_size_, wide_bound_, wide_own_;     ///< |z|, q, dq/d|z| of all elements, for the same
  std::vector<double> wide_px_, wide_py_, wide_sx_, wide_sy_; ///< of all elements; px, py only where some carry nothing
};

} // namespace microslip
