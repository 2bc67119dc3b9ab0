#pragma once

#include "microslip/friction/traction_bound.hpp"

#include <array>
#include <functional>
#include <string_view>
#include <vector>

namespace microslip {

/// The 1-D model problem of the simplified theory (F20), dimensionless. Particles enter at x = 0 and leave at x = 1:
///
///     du/dx - s = -w,  u(0) = 0,  |u| <= u_max;  adhesion: s = 0;  slip: |u| = u_max and s u <= 0.
///
/// u is the displacement difference, s the slip, w the rigid slip, u_max the traction bound times the flexibility.
struct ModelProblem {
  std::function<double(double)> bound;       ///< u_max(x), finite and >= 0
  std::function<double(double)> bound_slope; ///< du_max/dx; may be infinite at x = 0 and x = 1
  std::function<double(double)> rigid_slip;  ///< w(x), finite
};

/// u_max = 4x(1 - x) (parabolic) or its square root (elliptic), and w = rigid_slip_0 + rigid_slip_1 x.
ModelProblem model_problem(TractionBound bound, double rigid_slip_0, double rigid_slip_1);

/// State of a piece of the exact solution: in adhesion, or in slip with u = u_max or u = -u_max.
enum class ModelState { adhesion, slip_above, slip_below };

/// A piece of the exact solution, from the end of the piece before it up to and including its end.
struct ModelPiece {
  ModelState state;
  double end;        ///< x
  double offset = 0; ///< in adhesion: u = offset - integral of w from 0 to x
};

/// A model problem with its exact solution.
class ModelCase {
public:
  std::string_view name() const { return name_; }
  const ModelProblem& problem() const { return problem_; }
  const std::vector<ModelPiece>& pieces() const { return pieces_; }
  /// Ends of all pieces but the last.
  std::vector<double> transitions() const;

  /// u(x) and s(x), x in [0, 1]. Where s jumps it has the value before the jump. At x = 1 under the elliptic bound
  /// slip is infinite.
  double displacement(double x) const;
  double slip(double x) const;

private:
  friend std::array<ModelCase, 3> model_cases();
  ModelCase(std::string_view name, TractionBound bound, double rigid_slip_0, double rigid_slip_1,
            std::vector<ModelPiece> pieces);
  const ModelPiece& piece(double x) const;

  std::string_view name_;
  double rigid_slip_0_, rigid_slip_1_;
  ModelProblem problem_;
  std::vector<ModelPiece> pieces_;
};

/// The three cases of the paper: (F21)-(F22) parabolic bound and small spin, (F23)-(F25) parabolic bound and large
/// spin, (F26)-(F27) elliptic bound. The transition points are good to a few units in the last digit.
std::array<ModelCase, 3> model_cases();

/// A numerical solution at x_i = i/mx, i = 0 ... mx.
struct ModelSolution {
  std::vector<double> x, displacement, slip;
  /// The transitions met, ascending. With tracked boundaries: where they are found to be; else: the first grid point
  /// of the new state.
  std::vector<double> transitions;
};

/// The original FASTSIM: backward Euler with the bound applied at each grid point (F29), (F30). First order.
/// All three: mx is in [1, 10,000,000], theta in [0.5, 1]; other values, and a problem that breaks its conditions
/// at a grid point, throw Error. |u_i| <= u_max(x_i) always. slip[0] is the slip at the leading edge (F32).
/// Cost O(mx).
ModelSolution solve_backward_euler(const ModelProblem& problem, int mx);

/// The theta method (F31)-(F33); theta = 1 is backward Euler, 1/2 the trapezoidal rule, second order in u but with
/// slip that oscillates after each jump.
ModelSolution solve_theta_method(const ModelProblem& problem, int mx, double theta);

/// The theta method with tracked boundaries between adhesion and slip (steps 3'', 4'' and (F34)). With theta = 1/2 a
/// parabolic bound with linear w is solved exactly, up to rounding: of order eps in u, eps mx in s.
///
/// Beyond the paper: what is left of a step after a boundary is a separate step, so that one step may cross several
/// boundaries; a step that starts on a bound that rises faster than u is halved until the quadratic fit of step 4''(b)
/// sees u below the bound (the first cell under the elliptic bound); and in a rest of less than a twentieth of a step,
/// where (F31) would divide rounding errors by it, slip is computed from (F34).
ModelSolution solve_tracked(const ModelProblem& problem, int mx, double theta);

} // namespace microslip
