#pragma once

#include "microslip/rolling/elliptic_contact.hpp"
#include "microslip/rolling/incompatibility.hpp"
#include "microslip/rolling/rolling_problem.hpp"
#include "microslip/rolling/theory.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

class CreepForceTable;

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

/// The same for what EllipticContactSolver is given: options alone, or with a contact and its motion. A contact's
/// dissimilarity must be that of the bodies, if the options have some, or 0.
void require_compatible(const ExactOptions& options);
void require_compatible(const ExactOptions& options, const EllipticContact& contact, const ExactMotion& motion,
                        std::optional<double> accuracy = {});

/// The bodies of a contact that EllipticContactSolver is given: those of the options, else similar or dissimilar
/// elastic ones with the contact's constants.
Bodies bodies_of(const ExactOptions& options, const EllipticContact& contact);

/// Whether the exact theory needs a ContactSequence: for dissimilar or viscoelastic bodies, layers, friction that
/// depends on slip, temperatures.
bool needs_sequence(const RollingProblem& problem);
bool needs_sequence(const ExactOptions& options, const EllipticContact& contact);
/// Returns whether it needs its classical discretisation: for those, shifts and transient rolling.
bool needs_classical(const RollingProblem& problem);

/// Options that follow from the method for this problem.
Discretisation discretisation_of(const RollingProblem& problem, const Method& method);
ElementShape elements_of(const RollingProblem& problem, const Method& method);
SimplifiedOptions simplified_options(const Method& method, RollingDirection direction);
ExactOptions exact_options(const RollingProblem& problem, const Method& method);
/// A step of a ContactSequence with what the options say of it: not the grid, the bodies, the load, the friction law
/// nor the motion.
ContactStep contact_step(const ExactOptions& options);

} // namespace microslip
