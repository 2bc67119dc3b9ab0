#pragma once

#include "microslip/rolling/solver.hpp"

#include <map>

namespace microslip {

/// Steady rolling on two nested grids and its limit.
struct AccurateContact {
  ContactSolution finest;   ///< on the finer grid
  ContactForces coarser;    ///< on half the elements
  double coarser_power = 0; ///< the frictional power there [W]
  ContactForces forces;     ///< the limit, extrapolated; areas and status of the finer grid
  Creepage creepage;        ///< the limit, where a force is given
  double error = 0;         ///< estimated error of the limit, see AccurateContactSolver
  int elements = 0;         ///< across the ellipse, of the finer grid
  long products = 0;        ///< on all grids
};

/// The limit of a force or creepage, F(h/2) + (F(h/2) - F(h))/4, from its values on a grid and on one with twice as
/// many elements in each direction. Were errors c h^2 alone, the factor would be 1/3. But they scatter, by where the
/// edges of contact and of slip lie within their elements, like (c + s z) h^2 with independent z of variance 1; the
/// factor with the least mean square error is (6 - 2 t)/(18 + 34 t), t = s^2/c^2, t = 0.1 to 0.3 on 8 to 48 elements.
double limit_of_second_order(double coarse, double fine);

/// Hertzian contacts in steady rolling to an accuracy that is asked for, by limit_of_second_order. Grids of 8 and 16,
/// 16 and 32, ... elements across are tried until the limit's error is estimated below `accuracy`, a fraction of mu Fn
/// for forces and of mu Fn sqrt(a b) for the moment; that of a creepage counts as the force that it is worth in linear
/// theory. The estimate is the largest change from F(h) to F(h/2), or a quarter of that from F(2 h) to F(h) if that is
/// more: of the 112 reference cases it is never below the true error and mostly some eight times as large.
class AccurateContactSolver {
public:
  /// Throws Error unless the method's accuracy is given, in [1e-5, 0.1]. Its grid is not used.
  explicit AccurateContactSolver(const Method& method);

  /// Steady rolling with creepages or forces given. If not even the finest grid of 512 x 512 elements is good enough
  /// the status is not_converged and the result is the one from there. `progress` may end the work: with the same
  /// status and the result from the grids before, NaN if there are none. Throws Error for what is solved classically,
  /// whose errors are of first order.
  AccurateContact solve(const RollingProblem& problem, const Progress& progress = {});

private:
  ContactSolution solve_on(int elements, const RollingProblem& problem, const Progress& progress);

  Method method_;
  std::map<int, Solver> solvers_; ///< by elements across
};

} // namespace microslip
