#pragma once

#include "microslip/exact/classical/contact_step.hpp"
#include "microslip/exact/classical/force_changes.hpp"
#include "microslip/exact/newton/coupled_newton.hpp"

#include <memory>
#include <optional>
#include <span>

namespace microslip {

/// The contact problem of bodies whose normal and tangential problems are coupled, or whose deformation is partly
/// retarded: tractions displace the surfaces normally, and pressure along each other, in proportion to K (B1). Shifts,
/// transient and steady rolling; viscoelastic bodies in steady rolling only.
class CoupledContact {
public:
  /// Throws Error for a grid without elements, or one that needs more memory than the machine has, and Stopped if
  /// `progress` returns false. With another `response` than two half-spaces' the problems are solved at once, with
  /// these for a start.
  CoupledContact(const Bodies& bodies, const ElementGrid& grid, const ElementResponse& response = {},
                 const Progress& progress = {});

  /// `friction` is that of the elements, `previous` what a shift or a step of rolling starts from, `start` where the
  /// iteration begins; of the step, whose bodies and grid are those of this object, `friction` and what the sequence
  /// does are not used. A pressure that is given goes into the tangential problem, without response. Throws Error for
  /// input out of range, and Stopped if the motion's progress function returns false.
  ContactStepSolution solve(const ContactStep& step, const ElementFriction& friction, const TangentialState& previous,
                            const TangentialState& start);

  /// Derivatives of the forces of such a step in steady rolling, whose creepages are given and whose friction depends
  /// neither on slip nor on temperature, at its solution, by CoupledDerivative. The bodies' distance without load
  /// stays. Throws Stopped if the motion's progress function returns false.
  ForceChanges differentiate(const ContactStep& step, std::span<const double> friction,
                             const ContactSolution& solution);

private:
  using Field = std::vector<double>;

  CoupledOperator& displacement_at(Vec2 offset, const Progress& progress);
  CoupledOperator& coupled_operator(const TangentialInput& motion, double step);
  void add_previous(const TangentialInput& motion, double step, const TangentialState& previous, Field& cx, Field& cy);
  ContactStepSolution solve_newton(const ContactStep& step, const ElementFriction& friction,
                                   const TangentialState& previous, const TangentialState& start);
  ContactStepSolution solve_alternating(const ContactStep& step, const ElementFriction& friction,
                                        const TangentialState& previous, const TangentialState& start);
  void find_tangential(const ContactStep& step, const ElementFriction& friction, const Field& pressure,
                       const TangentialState& previous, const TangentialState& start, ContactStepSolution& out);
  NormalSolution solve_alone(const ContactStep& step);
  std::optional<ContactStepSolution> slide_fully(const ContactStep& step, const ElementFriction& friction,
                                                 const TangentialState& previous);
  void find_displacements(ContactStepSolution& out);

  Bodies bodies_;
  ElementGrid grid_;
  ElementResponse response_;
  CoupledOperator displacement_;
  NormalProblem normal_;                              ///< of the bodies as if they were similar and elastic
  std::unique_ptr<TangentialProblem> tangential_;     ///< with the pressure given
  std::unique_ptr<CoupledOperator> coupled_operator_; ///< kept for the next problem of the same motion and step
  ContactMotion motion_ = ContactMotion::shift;
  Vec2 step_ = {};
  std::unique_ptr<CoupledOperator> ahead_; ///< displacements further on, kept for the next step of the same length
  Vec2 offset_ = {};                       ///< of it
  CoupledNewton newton_;
};

} // namespace microslip
