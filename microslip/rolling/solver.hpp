#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/progress.hpp"
#include "microslip/rolling/frequency_response.hpp"
#include "microslip/rolling/method.hpp"
#include "microslip/rolling/rolling_problem.hpp"

#include <memory>
#include <span>

namespace microslip {

/// Forces in steady rolling and their derivatives: row k belongs to fx, fy, mz, columns to xi [-], eta [-], phi [1/m].
struct ExactDerivatives {
  ContactSolution solution;
  double jacobian[3][3] = {};
  double by_load[3] = {}; ///< of the same by the normal force [N] or the approach [m], whichever is given
  long products = 0;      ///< that the derivatives took
};

/// Solves any rolling problem by one method: an ellipse by either theory, to an accuracy if one is asked for, or by a
/// creep-force table, which gives forces without fields; a gap on
/// a grid by the exact theory, at second order where that is possible (steady rolling of similar elastic bodies with
/// Coulomb friction), else classically. What does not change from problem to problem (transforms, influence
/// coefficients, pressures) is kept for the next one. Distinct objects may be used from distinct threads.
class Solver {
public:
  /// Throws Error if a number of the method is out of range, or if the exact theory's grid across an ellipse needs more
  /// memory than the machine has.
  explicit Solver(const Method& method = {});
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;
  ~Solver();

  const Method& method() const;

  /// Throws Error for a problem that the method cannot honour (incompatibilities), whose geometry is invalid, or
  /// which needs more memory than the machine has; of a gap on a grid for any input out of range. Other input out of
  /// range, not converging, no contact, an ellipse or a material beyond a table's range and a force beyond friction are
  /// statuses, with their reason. `progress` is called with
  /// the fraction done; false ends the work, with status not_converged. Cost: of an ellipse with N elements
  /// O(N log N), some ms at 24 x 24; of the simplified theory O(N).
  ContactSolution solve(const RollingProblem& problem, const Progress& progress = {});

  /// Steady rolling by the exact theory, with creepages given and Coulomb friction: forces and the derivatives of these
  /// very numbers, from the converged equations by the implicit function theorem. Those by the load are for bodies
  /// whose distance without load stays as it is. They hold away from the kinks where an element passes from adhesion to
  /// slip, and are accurate to 1e-5 of a column's size with the default tolerance. `progress` is called in the Newton
  /// steps and linear solves; false ends them, with status not_converged and NaN. Of an ellipse other problems are
  /// Status::invalid_input, else they throw Error, and so do other methods and a gap on a grid at second order.
  ExactDerivatives differentiate(const RollingProblem& problem, const Progress& progress = {});

  /// Complex responses of the forces to oscillations of creepages, spin, normal force and, where it is asked for,
  /// roughness, with those of frictional work, about steady rolling, at wavenumbers k = omega/V >= 0 [1/m]: the
  /// equations of `differentiate` with D/Dt = i omega - V d/dx. For ellipses and gaps on a grid, of elastically similar
  /// bodies with Coulomb friction, by the exact theory at second order, with creepages or forces given; the steady
  /// state's adhesion and slip are kept. At k = 0 they are the derivatives. Waves need some eight elements: 24 elements
  /// across resolve waves of half the contact's length to 1 % (tests). Throws Error as `differentiate`; false of
  /// `progress` ends with status not_converged. Cost: four linear solves for each wavenumber, some 5 ms at 24 x 24;
  /// with roughness some 15 ms.
  FrequencyResponse respond(const RollingProblem& problem, std::span<const double> wavenumbers,
                            const Progress& progress = {}, ResponseTo causes = ResponseTo::motion_and_load);

  /// Deformed distance of the bodies h - delta + u_n [m] by the exact theory at the elements of the solution, zero in
  /// contact. Throws Error for what `solve` refuses and for the simplified theory, and Stopped if `progress` returns
  /// false. With an accuracy, on the grid of the problem last solved.
  GapValues deformed_gap(const RollingProblem& problem, const Progress& progress = {});

private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

} // namespace microslip
