#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/contact/motion.hpp"
#include "microslip/exact/halfspace/leading_edge.hpp"
#include "microslip/exact/halfspace/rolling_difference.hpp"
#include "microslip/exact/halfspace/surface_operator.hpp"
#include "microslip/exact/newton/friction_newton.hpp"
#include "microslip/simplified/options.hpp"

#include <memory>
#include <optional>

namespace microslip {

/// Input of the tangential problem.
struct TangentialInput {
  ContactMotion motion = ContactMotion::steady;
  Creepage creepage; ///< xi [-], eta [-], phi [1/m]; where a force is given its creepage is an unknown
  std::optional<double> force_x, force_y; ///< [N], on body 1
  double step = 0;                        ///< dq [m], the distance rolled in a step; 0: the elements' length
  double spin_offset = 1.0 / 6; ///< where in the step the rigid slip is taken, 0 to 1 from the element's centre on
  RollingDirection direction = RollingDirection::forward;
  /// The angle from the direction along x to that of rolling, towards +y with forward [rad].
  double heading = 0;
  std::optional<LeadingEdge> leading_edge; ///< rolling: with its correction (R13); none: without
  double rolling_speed = 1;                ///< V [m/s], for the frictional power
  /// Slip of each element on top of the rigid slip of the creepages; empty: none. In a shift [m], else [-].
  std::span<const double> extra_x = {}, extra_y = {};
  /// Instead of the bound, which then is its largest; of the pressure p_n [Pa].
  SlipDependentBound* slip_dependent = nullptr;
  std::span<const double> pressure = {};
  /// Shift and transient rolling: the tractions before, of the elements in the contact's frame [Pa]; none or empty:
  /// zero.
  const VectorField* previous = nullptr;
  const VectorField* start = nullptr; ///< where the iteration begins; none: `previous`, else no tractions
  /// Tolerance of the residual, as in FrictionSolution; for a shift or a step of rolling also of the change that the
  /// step makes, see FrictionNewton::Options::before.
  double tolerance = 1e-6;
  int most_steps = most_newton_steps;
  double shortest_step = 0;       ///< of Newton's steps, as of NewtonLimits
  NewtonBudget* budget = nullptr; ///< of the whole solve, if this is a part of one
  /// Called after each Newton step; false ends the iteration, with status not_converged. While influence coefficients
  /// are computed false ends with Stopped.
  Progress progress = {};
};

/// Returns true if D has a positive definite symmetric part, so that the problem has one solution, and the solver finds
/// it. This holds for bilinear elements, and for constant ones except for steady rolling with a step below 0.55 dx on
/// elements that are longer than wide (dx > dy): there the differences of displacements over a step miss what changes
/// within an element. Such problems have solutions, possibly several. Of 500 seeded ones with steps of 0.05 to 0.5 dx,
/// a/b of 0.1 to 10 and as many elements along either axis, 98 % converge; the others end with Status::not_converged.
bool has_one_solution(const ElementGrid& grid, const TangentialInput& input);

/// The tangential contact problem of the exact theory (R3), (R6)-(R8), (E2), (E14) on a grid of elements. With the step
/// dq and particles that come from x + dq: steady rolling s = w(x + dq/2) + (u(x) - u(x + dq))/dq, transient rolling
/// the same with the previous u' instead of u(x + dq), a shift s = w + u - u'.
class TangentialProblem {
public:
  /// Throws Error for a grid without elements, or one that needs more memory than the machine has.
  TangentialProblem(const Bodies& bodies, const ElementGrid& grid);

  /// `bound` is g = mu p_n [Pa] at the elements, zero outside the contact. Throws Error for input out of range. Not
  /// converging and a force beyond friction are statuses; input so large that a total overflows gives
  /// Status::invalid_input. The solution has no pressures; its frictional power is the sum over the elements (E22), in
  /// steady rolling not yet (E23a) as in Totals.
  ContactSolution solve(std::span<const double> bound, const TangentialInput& input);

  /// Moves the elements: (x0, y0) becomes the first one's centre [m].
  void move_to(double x0, double y0);

private:
  SlipOperator& displacement(const Progress& progress);
  SlipOperator& difference(const TangentialInput& input, double step);

  /// Start from the solution on coarser elements; no tractions if there is none.
  struct CoarseStart {
    VectorField tractions;
    std::optional<Vec2> constants;
    bool stopped = false; ///< by the progress function
  };
  CoarseStart start_from_coarser(std::span<const double> bound, const TangentialInput& input, double step);

private:
  void find_displacements(const VectorField& tractions, Vec2 offset, const Progress& progress,
                          VectorField& displacement);
  void find_free_slip(const TangentialInput& input, const Creepage& creepage, double step,
                      const std::vector<EnteringElement>& entering, std::vector<double>& cx, std::vector<double>& cy);

  Bodies bodies_;
  ElementGrid grid_;
  std::unique_ptr<SlipOperator> displacement_; ///< made when it is first needed
  /// Either is kept for the next steady problem of the same step.
  std::optional<TangentialOperator> difference_;
  std::optional<RollingDifference> rolling_;   ///< of elastic bodies with steps of whole elements
  Vec2 step_ = {};                             ///< of it
  std::unique_ptr<TangentialProblem> coarser_; ///< on elements twice as long and wide, for steady rolling
  std::optional<TangentialOperator> ahead_;    ///< displacements further on, kept for the next step of the same length
  Vec2 offset_ = {};                           ///< of it
  FrictionNewton newton_;
};

} // namespace microslip
