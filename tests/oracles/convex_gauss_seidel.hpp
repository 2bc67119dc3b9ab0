#pragma once

#include "microslip/exact/halfspace/offset_kernel.hpp"
#include "microslip/exact/newton/friction_newton.hpp"

#include <optional>
#include <span>

namespace microslip {

/// How much of a step towards an element's solution is taken, above 0 and below 2; 1 is the plain method.
struct Relaxation {
  double adhesion = 1; ///< of the tractions (R10)
  double slip = 1;     ///< of their direction (R11)

  /// min(0.9, 0.7 r^2) with r = D_xx of an element on itself over that of the element ahead on it: 0.9 for shifts and
  /// transient rolling, 0.7 for steady rolling with dq = dx (r = -1), less for a smaller dq, with which the element
  /// ahead weighs more than the element itself. Found by trial.
  static Relaxation of(const TangentialKernel& kernel);
};

struct GaussSeidelOptions {
  double tolerance = 1e-6; ///< of FrictionSolution::residual
  int most_sweeps = 5000;
  std::optional<Relaxation> relaxation = {}; ///< none: Relaxation::of the kernel
  int threads = 1;
};

struct GaussSeidelSolution : FrictionSolution {
  int sweeps = 0;
};

/// ConvexGS, the block Gauss-Seidel method for the tangential problem (Vollebregt 1995; 2009, section 3): for one
/// element after the other the tractions that solve its problem while all others are fixed. In adhesion that is a
/// linear equation, in slip one for the direction, solved by Newton's method. The plain reference beside
/// FrictionNewton: O(N^2) operations for a sweep, a number of sweeps that grows with the grid, O(N) memory.
///
/// (R11) needs a traction on the bound. An element that is to slip but is still inside its bound goes there by (R10).
/// Rows are swept with y ascending, their elements from the trailing to the leading edge. The sums over all other rows
/// are made by `threads` threads, which meet after each row; the result does not depend on how many. More threads than
/// idle cores make it much slower.
///
/// `kernel` is that of problem.slip_operator. `start` is where it begins; empty spans mean zero tractions. Where a
/// force is given, solve_prescribed_force calls this method, and `sweeps` counts all. Throws Error for options out of
/// range.
GaussSeidelSolution solve_convex_gauss_seidel(const FrictionProblem& problem, const TangentialKernel& kernel,
                                              const GaussSeidelOptions& options, std::span<const double> start_px = {},
                                              std::span<const double> start_py = {});

} // namespace microslip
