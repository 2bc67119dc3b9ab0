#pragma once

#include "microslip/exact/classical/contact_step.hpp"
#include "microslip/exact/classical/coupled_forecast.hpp"
#include "microslip/exact/classical/coupled_operators.hpp"
#include "microslip/exact/classical/force_changes.hpp"
#include "microslip/exact/classical/grid_part.hpp"
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

  /// What a step's equations know of each element.
  struct StepFields {
    Field gap, cx, cy;    ///< as of CoupledFrictionProblem
    Field pressure_alone; ///< without tractions
  };

  CoupledOperators& operators_on(const GridPart& part);
  GridPart part_in_contact(const ContactStep& step, const ElementFriction& friction, const Field& pressure) const;
  void add_previous(const TangentialInput& motion, double step, const TangentialState& previous, Field& cx, Field& cy);
  CoupledFrictionSolution solve_on(const GridPart& part, const ContactStep& step, const ElementFriction& friction,
                                   const StepFields& fields, std::span<const CoupledFrictionStart> starts,
                                   const CoupledNewton::Options& options);
  void take(const CoupledFrictionSolution& s, ContactStepSolution& out);
  static bool overlaps_beyond(const GridPart& part, const Field& gap, const NormalSolution& normal);
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
  CoupledOperators operators_;
  std::optional<CoupledOperators> part_operators_; ///< of a part of the grid, for the next one of its size
  NormalProblem normal_;                           ///< of the bodies as if they were similar and elastic
  std::unique_ptr<TangentialProblem> tangential_;  ///< with the pressure given
  CoupledNewton newton_;
  CoupledForecast forecast_;
};

} // namespace microslip
