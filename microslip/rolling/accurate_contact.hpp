#pragma once

#include "microslip/rolling/layered_rolling.hpp"
#include "microslip/rolling/solver.hpp"

#include <map>

namespace microslip {

/// Steady rolling on two nested grids and its limit.
struct AccurateContact {
  ContactSolution finest;   ///< on the finer grid, of layers the first of several
  ContactForces coarser;    ///< on half the elements, of layers the mean of several grids
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

/// The same for errors (c + s z) h of the classical discretisation, F(h/2) + 0.8 (F(h/2) - F(h)): the factor with the
/// least mean square error is (1 - t)/(1 + 5 t), t = 0.01 to 0.1 of random contacts on 16 to 256 elements.
double limit_of_first_order(double coarse, double fine);

/// Contacts in steady rolling, Hertzian or of bodies with layers by their radii, to an accuracy that is asked for, by
/// limit_of_second_order where the discretisation is of second order, else by limit_of_first_order. Grids of 8 and 16,
/// 16 and 32, ... elements across are tried until the limit's error is estimated below `accuracy`, a fraction of mu Fn
/// for forces and of mu Fn l for the moment, with the contact's length l, sqrt(a b) or the half-width a of a line
/// contact; that of a creepage counts as the force that it is worth in linear theory, without slip.
///
/// Of second order the estimate is the largest change from F(h) to F(h/2), or a quarter of that from F(2 h) to F(h) if
/// that is more: of the 112 reference cases it is never below the true error and mostly some eight times as large. Of
/// first order it is 1.5 times the largest of that change, a half of the one before and a quarter of the one before
/// that: of random contacts of layers it is below the true error in 3 of 100 and mostly six times as large.
///
/// Forces on a grid depend on where the edges of contact, adhesion and slip lie within their elements. In a line
/// contact of layers that is as much as what the elements' length does, and no extrapolation helps. But elements that
/// are moved move all edges within them alike, and the mean over a whole element depends on the length alone. So forces
/// of layers are means: over four grids, each a quarter of an element further on, in a line contact; over two, half an
/// element apart, where rows have their edges at different places.
class AccurateContactSolver {
public:
  /// Throws Error unless the method's accuracy is given, in [1e-5, 0.1]. Its grid is not used.
  explicit AccurateContactSolver(const Method& method);

  /// Steady rolling with creepages or forces given. If not even the finest grid is good enough the status is
  /// not_converged and the result is the one from there: 512 x 512 elements of second order, 256 x 256 classical ones,
  /// 4096 strips. `progress` may end the work: with the same status and the result from the grids before, NaN if there
  /// are none. Throws Error for problems that are refused (incompatibilities), and as LayeredRolling does.
  AccurateContact solve(const RollingProblem& problem, const Progress& progress = {});

private:
  ContactSolution solve_on(int elements, double moved, const RollingProblem& problem, const Progress& progress);
  ContactSolution solve_layered(int elements, double moved, const RollingProblem& problem, const Progress& progress);
  Vec2 layered_stiffness(const RollingProblem& problem, const ContactSolution& found, double length,
                         const Progress& progress);

  Method method_;
  std::map<int, Solver> solvers_; ///< of half-spaces, by elements across
  LayeredRolling layered_;
};

} // namespace microslip
