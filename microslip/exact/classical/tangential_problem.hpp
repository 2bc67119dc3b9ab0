#pragma once

#include "microslip/contact/elliptic_contact.hpp"
#include "microslip/contact/motion.hpp"
#include "microslip/contact/surface_fields.hpp"
#include "microslip/contact/vector_field.hpp"
#include "microslip/exact/halfspace/leading_edge.hpp"
#include "microslip/exact/halfspace/rolling_difference.hpp"
#include "microslip/exact/halfspace/surface_operator.hpp"
#include "microslip/exact/newton/friction_newton.hpp"
#include "microslip/simplified/options.hpp"

#include <memory>
#include <optional>

namespace microslip {

/// Tractions that a step starts from: those of the step before, on the same grid in the contact's frame.
struct TangentialState {
  std::vector<double> px, py;        ///< [Pa]; empty: none
  std::vector<double> pressure = {}; ///< p_n [Pa], which matters for dissimilar materials; empty: none
  /// Loss of friction that depends on the slip, static minus present coefficient [-], and the slip velocity
  /// [m/s]; empty: nothing.
  std::vector<double> friction_drop = {}, slip_velocity = {};
  std::vector<double> plastic_deformation = {}; ///< of a layer [m]; empty: none
};

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
  const TangentialState* previous = nullptr; ///< shift and transient rolling: the state before; none: no tractions
  const TangentialState* start = nullptr;    ///< where the iteration begins; none: `previous`, else no tractions
  /// Tolerance of TangentialSolution::residual; for a shift or a step of rolling also of the change that the step
  /// makes, see FrictionNewton::Options::before.
  double tolerance = 1e-6;
  int most_steps = most_newton_steps;
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

struct TangentialSolution {
  TangentialState tractions;
  std::vector<double> bound;          ///< g [Pa]
  std::vector<double> ux, uy;         ///< displacement difference u1 - u2 [m]
  std::vector<double> sx, sy;         ///< relative slip [-], for a shift the slip distance [m]; 0 outside the contact
  std::vector<double> slip_direction; ///< angle of the slip from the x axis [rad], -pi to pi; 0 where nothing slips
  std::vector<CellState> state;
  ContactForces forces;
  Creepage creepage;         ///< as given, or as found where a force is given
  double elastic_energy = 0; ///< of the tangential tractions, sum of p.u dx dy/2 [J]
  /// -V sum of p.s dx dy (E22) [W], not yet (E23a) as in Totals; for a shift the work, without V [J].
  double frictional_power = 0;
  double power_by_creepage =
      0;                    ///< -V (xi fx + eta fy + phi mz) [W], equal to it in steady rolling as the grid is refined
  double peak_traction = 0; ///< [Pa]
  double residual = 0;      ///< as in FrictionSolution
  int newton_steps = 0;
  long products = 0;
};

/// The tangential contact problem of the exact theory (R3), (R6)-(R8), (E2), (E14) on a grid of elements. With the step
/// dq and particles that come from x + dq: steady rolling s = w(x + dq/2) + (u(x) - u(x + dq))/dq, transient rolling
/// the same with the previous u' instead of u(x + dq), a shift s = w + u - u'.
class TangentialProblem {
public:
  /// Throws Error for a grid without elements, or one that needs more memory than the machine has.
  TangentialProblem(const Bodies& bodies, const ElementGrid& grid);

  /// `bound` is g = mu p_n [Pa] at the elements, zero outside the contact. Throws Error for input out of range. Not
  /// converging and a force beyond friction are statuses; input so large that a total overflows gives
  /// Status::invalid_input.
  TangentialSolution solve(std::span<const double> bound, const TangentialInput& input);

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
  void find_displacements(const TangentialState& tractions, Vec2 offset, const Progress& progress, std::span<double> ux,
                          std::span<double> uy);
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
