#pragma once

#include "microslip/exact/normal_problem.hpp"
#include "microslip/exact/tangential_problem.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// What a step of a sequence starts from.
enum class StepStart {
  fresh,    ///< no tractions
  previous, ///< those at the end of the step before
  repeated, ///< those that the step before started from: the same step once more
};

/// A pressure that is given and not solved for.
struct GivenPressure {
  std::vector<double> pressure;          ///< p_n [Pa] of the elements
  double approach = 0;                   ///< delta that belongs to it [m]
  double normal_force = 0;               ///< Fn that belongs to it [N]; the sum over the elements differs by their size
  std::vector<double> displacement = {}; ///< u_n [m]; empty: that of the half-space
};

/// A normal and a tangential problem on a grid, elastically similar bodies.
struct ContactStep {
  ElementGrid grid;
  CombinedMaterial material = {};
  std::vector<double> gap = {};    ///< undeformed distance h of the elements [m]
  std::vector<char> excluded = {}; ///< 1 for elements that cannot come into contact; empty: none
  NormalLoad load = {};
  std::optional<GivenPressure> given = {};          ///< in the place of gap and load
  std::vector<double> friction = {};                ///< mu of each row of the grid; one value: the same for all
  bool frictionless = false;                        ///< the normal problem only; tractions are zero
  StepStart start = StepStart::fresh;               ///< of shifts and transient rolling
  bool warm_start = false;                          ///< the iteration starts from the tractions of the step before
  TangentialInput motion = {};                      ///< but for forces, previous and start
  std::optional<double> force_x = {}, force_y = {}; ///< given, over Fn [-]
};

struct ContactStepSolution {
  NormalSolution normal;
  TangentialSolution tangential;
  double normal_force = 0; ///< Fn [N]
  int contact_elements = 0, adhesion_elements = 0, slip_elements = 0;
  Status status = Status::ok;
};

/// Tractions on another grid: bilinear between the centres of the old elements, zero beyond them. Between grids with
/// the same elements it hands over values as they are.
TangentialState moved_to(const ElementGrid& to, const TangentialState& state, const ElementGrid& from);

/// Steps of contact, each of which may go on from the tractions that the one before has left; Status::invalid_input
/// leaves none. Grids may differ. What does not change from step to step (transforms, the normal problem) is not
/// computed again.
class ContactSequence {
public:
  /// Throws Error for input out of range, as NormalProblem and TangentialProblem do; the sequence then is as it was.
  ContactStepSolution solve(const ContactStep& step);

private:
  struct State {
    ElementGrid grid;
    TangentialState tractions;
  };

  const NormalSolution& solve_normal(const ContactStep& step);
  TangentialProblem& tangential_problem(const ContactStep& step);

  std::unique_ptr<ContactStep> normal_of_; ///< whose normal problem `normal_` solves
  NormalSolution normal_;
  std::unique_ptr<TangentialProblem> tangential_;
  ElementGrid tangential_grid_;
  CombinedMaterial tangential_material_ = {};
  State before_, after_; ///< the last step's
};

} // namespace microslip
