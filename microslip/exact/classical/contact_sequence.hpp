#pragma once

#include "microslip/exact/classical/contact_step.hpp"
#include "microslip/exact/classical/coupled_contact.hpp"

#include <memory>
#include <utility>

namespace microslip {

/// Tractions on another grid: bilinear between the centres of the old elements, zero beyond them. Between grids with
/// the same elements it hands over values as they are.
TangentialState moved_to(const ElementGrid& to, TangentialState state, const ElementGrid& from);

/// Steps of contact, each of which may go on from the tractions that the one before has left; Status::invalid_input
/// leaves none. Grids may differ. What does not change from step to step (transforms, the normal problem) is not
/// computed again.
class ContactSequence {
public:
  /// Throws Error for input out of range, as NormalProblem and TangentialProblem do, and Stopped if the
  /// motion's progress function returns false; the sequence then is as it was.
  ContactStepSolution solve(const ContactStep& step);

  /// Derivatives of the forces at a step's solution, as CoupledContact has them, for all bodies. Throws Error for
  /// forces given, other than steady rolling, friction that depends on slip or temperatures, and a layer that yields,
  /// Stopped as solve.
  ForceChanges differentiate(const ContactStep& step, const ContactSolution& solution);

  /// Tractions and the grid that they are on.
  struct State {
    ElementGrid grid;
    TangentialState tractions;
  };

  /// State at the end of the last step, for the next one.
  const State& carried() const { return after_; }
  /// State from which the last step began.
  const State& started_from() const { return before_; }
  /// The next step goes on from this instead of it.
  void carry(State state) { after_ = std::move(state); }

private:
  const NormalSolution& solve_normal_part(const ContactStep& step);
  NormalProblem& normal_problem(const ContactStep& step);
  TangentialProblem& tangential_problem(const ContactStep& step);
  CoupledContact& coupled_contact(const ContactStep& step);
  ContactStepSolution solve_similar(const ContactStep& step, const ElementFriction& friction,
                                    const TangentialState& previous, const TangentialState& start);
  ContactStepSolution solve_frictionless(const ContactStep& step);
  ContactStepSolution solve_coupled(const ContactStep& step, const ElementFriction& friction,
                                    const TangentialState& previous, const TangentialState& start);
  ContactStepSolution solve_with(const ContactStep& step, const ElementFriction& friction,
                                 const TangentialState& previous, const TangentialState& start);
  ContactStepSolution solve_slip_dependent(const ContactStep& step, SlipFriction& law, const TangentialState& previous,
                                           TangentialState start);

  std::unique_ptr<ContactStep> normal_of_; ///< whose normal problem `normal_` solves
  NormalSolution normal_;
  std::unique_ptr<NormalProblem> normal_problem_;
  ElementGrid normal_grid_;
  CombinedMaterial normal_material_ = {};
  std::unique_ptr<TangentialProblem> tangential_;
  ElementGrid tangential_grid_;
  Bodies tangential_bodies_ = {};
  std::unique_ptr<CoupledContact> coupled_;
  ElementGrid coupled_grid_;
  Bodies coupled_bodies_ = {};
  ElementResponse coupled_response_;
  State before_, after_; ///< the last step's
};

} // namespace microslip
