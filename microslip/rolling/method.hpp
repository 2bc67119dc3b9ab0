#pragma once

#include "microslip/exact/classical/contact_step.hpp"
#include "microslip/rolling/incompatibility.hpp"
#include "microslip/rolling/rolling_problem.hpp"
#include "microslip/rolling/simplified_defaults.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

class CreepForceTable;

/// Discretisation of rolling.
enum class Discretisation {
  second_order, ///< SecondOrderRolling, TransientRolling: forces with errors of second order in the elements' size
  classical,    ///< TangentialProblem: Kalker's regular elements, errors of first order
};

/// Method of solution. What is not given takes the best value for the problem.
struct Method {
  Theory theory = Theory::exact;
  int mx = 24; ///< cells or elements across an ellipse along x, 1 to 4,000; on a gap's grid not used
  int my = 24; ///< and along y
  // Of the exact theory:
  std::optional<Discretisation> discretisation = {}; ///< none: second order where it is possible
  std::optional<ElementShape> elements = {};         ///< none: constant, or the gap's grid's
  std::optional<double> accuracy = {};      ///< of the forces in mu Fn, in [1e-5, 0.1], on grids that this picks
  double tolerance = 1e-6;                  ///< of the relative residual, in [1e-14, 0.1]
  std::optional<Coupling> coupling = {};    ///< of the problems of dissimilar bodies; none: Newton's method
  std::optional<SlipStart> slip_start = {}; ///< of friction that depends on the slip; none: below
  // Of the simplified theory:
  std::optional<TractionBound> bound = {};          ///< none: parabolic, elliptic for FaStrip
  std::optional<FlexibilityModel> flexibility = {}; ///< none: three, blended for FaStrip
  CreepageTable coefficients = CreepageTable::kalker;
  SlopeReduction slope_reduction = {};
  Precision precision = Precision::full; ///< of the forces of many contacts
  // Of the theory `table`:
  std::shared_ptr<const CreepForceTable> table = {}; ///< for the direction of rolling

  friend bool operator==(const Method&, const Method&) = default;
};

/// All incompatibilities of a problem and a method, in the order of the table that every interface reads: empty if the
/// problem can be solved so.
std::vector<Incompatibility> incompatibilities(const RollingProblem& problem, const Method& method);

/// Throws Incompatible with the first of them.
void require_compatible(const RollingProblem& problem, const Method& method);

/// Returns true if the exact theory needs a ContactSequence: for dissimilar or viscoelastic bodies, layers, friction
/// that depends on slip, temperatures.
bool needs_sequence(const RollingProblem& problem);
/// Returns whether it needs its classical discretisation: for those, shifts, steps that are given, and transient
/// rolling of a gap on a grid.
bool needs_classical(const RollingProblem& problem);

/// Throws Error for a problem by the exact theory that has no derivatives: they are for steady rolling with creepages
/// given, and for friction that depends neither on slip nor on temperature.
void require_differentiable(const RollingProblem& problem);

/// Options that follow from the method for this problem.
Discretisation discretisation_of(const RollingProblem& problem, const Method& method);
ElementShape elements_of(const RollingProblem& problem, const Method& method);
SimplifiedOptions simplified_options(const Method& method, RollingDirection direction);
/// The motion without forces.
TangentialInput tangential_input(const RollingProblem& problem, const Method& method);
/// A gap on a grid as values at the centres of its elements, which have the method's shape.
GapValues gap_values(const RollingProblem& problem, const Method& method);
/// A step of a ContactSequence: the problem with a gap on a grid and a load instead of those it has. Forces along the
/// surface need one that is a force.
ContactStep contact_step(const RollingProblem& problem, const Method& method, GapValues gap, const NormalLoad& load);

} // namespace microslip
