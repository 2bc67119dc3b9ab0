#pragma once

#include "microslip/exact/fitted/fitted_operator.hpp"
#include "microslip/exact/fitted/grid_kernel.hpp"
#include "microslip/exact/fitted/second_order_rolling.hpp"
#include "microslip/exact/newton/friction_newton.hpp"
#include "microslip/numerics/symmetric_toeplitz.hpp"

#include <span>
#include <vector>

namespace microslip {

/// The slip D p = u/dx that tractions of a fitted contact make in a step by an element's length, u being the
/// displacements at the elements' points. Preconditioned by the near inverse of the grid's displacements.
class FittedStepOperator : public SlipOperator {
public:
  /// Throws Stopped if `progress` returns false.
  FittedStepOperator(const CombinedMaterial& material, const FittedContact& contact, const Progress& progress,
                     const TransformPlans& plans);

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override;
  bool precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                    std::span<double> qy) override;
  double diagonal() const override { return diagonal_; }
  double scale() const override { return scale_; }
  long products() const override { return displacement_.products(); }

  /// u/dx where the particles of each element come from, for the tractions of the last apply.
  void find_slip_ahead(std::span<double> sx, std::span<double> sy) const;
  /// u at the elements' points [m].
  std::vector<double> ux() const { return displacement_.ux(); }
  std::vector<double> uy() const { return displacement_.uy(); }

private:
  FittedStepOperator(const CombinedMaterial& material, const FittedContact& contact, const GridKernel& kernel,
                     const Progress& progress, const TransformPlans& plans);

  FittedOperator displacement_;
  SymmetricToeplitz<double> near_inverse_; ///< of the displacements in units of dx/G
  std::vector<std::size_t> cells_;         ///< of the elements in its field
  std::vector<double> px_, py_, qx_, qy_;  ///< on that field
  double compliance_;                      ///< 1/G
  double diagonal_, scale_;
};

/// Transient rolling along +x by steps of an element's length at second order: the edge does not move in the contact's
/// frame, so leading elements are fitted to it as in steady rolling, but displacements are taken at the centres of the
/// grid's elements, through which particles come. Elastically similar bodies.
class TransientRolling {
public:
  /// `contact` is fitted for ContactMotion::transient. Throws Stopped if `progress` returns false.
  TransientRolling(const CombinedMaterial& material, FittedContact contact, const Progress& progress = {},
                   const TransformPlans& plans = {});

  const FittedContact& contact() const { return contact_; }

  /// Goes on from zero tractions.
  void restart();

  /// The next step; `bound` is g [Pa] of each element, `input` without start. Where the iteration does not converge or
  /// a force is beyond friction, which are statuses, the next one goes on from what was found.
  SecondOrderSolution step(std::span<const double> bound, const SecondOrderInput& input);

private:
  Vec2 slip_before(std::size_t element) const;
  void solve_twice(std::span<const double> bound, const SecondOrderInput& input, SecondOrderSolution& out);
  void take_slip(SecondOrderSolution& out);

  FittedContact contact_;
  FittedStepOperator operator_;
  FrictionNewton newton_;
  std::vector<double> area_share_;
  // After the step before; empty: at rest without tractions.
  VectorField tractions_; ///< [Pa]
  VectorField ahead_;     ///< find_slip_ahead
  VectorField slip_;      ///< means over the step
};

} // namespace microslip
