#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/progress.hpp"
#include "microslip/rolling/method.hpp"
#include "microslip/rolling/rolling_problem.hpp"

#include <memory>

namespace microslip {

/// A Hertzian problem as the solvers of either theory take it.
EllipticContact elliptic_contact(const RollingProblem& problem, const HertzContact& hertz);

/// Solves any rolling problem by one method: an ellipse by either theory, to an accuracy if one is asked for, or by a
/// creep-force table, which gives forces without fields; a gap on
/// a grid by the exact theory, at second order where that is possible (steady rolling of similar elastic bodies with
/// Coulomb friction), else classically. What does not change from problem to problem (transforms, influence
/// coefficients, pressures) is kept for the next one. Distinct objects may be used from distinct threads.
class Solver {
public:
  /// Throws Error if a number of the method is out of range.
  explicit Solver(const Method& method = {});
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;
  ~Solver();

  const Method& method() const;

  /// Throws Error for a problem that the method cannot honour (incompatibilities), whose geometry makes no sense, or
  /// which needs more memory than the machine has; of a gap on a grid for any input out of range. Other input out of
  /// range, not converging, no contact, an ellipse or a material beyond a table's range and a force beyond friction are
  /// statuses, with their reason. `progress` is told
  /// of the fraction done; false ends the work, with status not_converged. Cost: of an ellipse with N elements
  /// O(N log N), some ms at 24 x 24; of the simplified theory O(N).
  ContactSolution solve(const RollingProblem& problem, const Progress& progress = {});

  /// Steady rolling over an ellipse by the exact theory at second order, creepages given: the solution, and the
  /// derivatives of its forces by the creepages. Throws Error for another method; what no derivatives are known of has
  /// status invalid_input.
  ExactDerivatives differentiate(const RollingProblem& problem, const Progress& progress = {});

  /// Deformed distance of the bodies [m] at the elements of an ellipse's solution by the exact theory, zero in contact.
  /// With an accuracy, those of the problem last solved. Throws Error for another method and for what `solve` refuses,
  /// Stopped if `progress` returns false.
  DeformedGap deformed_gap(const RollingProblem& problem, const Progress& progress = {});

private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

} // namespace microslip
