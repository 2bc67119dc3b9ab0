#include "microslip/simplified/model_problem.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace microslip {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double sign(ModelState state) {
  if (state == ModelState::adhesion) return 0;
  return state == ModelState::slip_above ? 1 : -1;
}

ModelState slip_towards(double displacement) {
  return displacement > 0 ? ModelState::slip_above : ModelState::slip_below;
}

/// A grid point or an internal boundary, and what the problem prescribes there.
struct Point {
  double x, rigid_slip, bound;
};

/// The solution at a point, from which the next step starts.
struct Front {
  Point at;
  double u, s;
  ModelState state;
};

Point sample(const ModelProblem& problem, double x) {
  const Point point = {x, require_finite("rigid_slip", problem.rigid_slip(x), "-"),
                       require_finite("bound", problem.bound(x), "-")};
  if (point.bound < 0) throw Error("bound", point.bound, "-", "not negative");
  return point;
}

/// u(0) = 0 is on the bound only where the bound is zero; there slip starts immediately if |w| exceeds the bound's
/// slope (F32).
Front leading_edge(const ModelProblem& problem) {
  const Point edge = sample(problem, 0);
  const double slope = problem.bound_slope(0);
  if (std::isnan(slope)) throw Error("bound_slope", slope, "-", "a number");
  if (edge.bound > 0 || !(std::abs(edge.rigid_slip) > slope)) return {edge, 0, 0, ModelState::adhesion};
  const ModelState state = slip_towards(-edge.rigid_slip);
  return {edge, 0, edge.rigid_slip + sign(state) * slope, state};
}

/// (F31) with no slip at the new point.
double trial_displacement(const Front& front, double x, double rigid_slip, double theta) {
  return front.u + (x - front.at.x) * ((1 - theta) * (front.s - front.at.rigid_slip) - theta * rigid_slip);
}

Front adhere(const Point& point, double u) {
  return {point, std::clamp(u, -point.bound, point.bound), 0, ModelState::adhesion};
}

/// Steps 3' and 4' with (F33).
Front plain_step(const Front& front, const Point& point, double theta) {
  const double trial = trial_displacement(front, point.x, point.rigid_slip, theta);
  if (std::abs(trial) <= point.bound) return adhere(point, trial);
  const ModelState state = slip_towards(trial);
  const double u = sign(state) * point.bound;
  return {point, u, (u - trial) / (theta * (point.x - front.at.x)), state};
}

/// Root in (0, 1) of the parabola through (0, low), (1/2, middle), (1, high), low < 0 < high.
double fitted_root(double low, double middle, double high) {
  const double c2 = 2 * (low - 2 * middle + high);
  const double c1 = high - low - c2;
  const double root = std::sqrt(std::max(0.0, c1 * c1 - 4 * c2 * low));
  return c1 >= 0 ? -2 * low / (c1 + root) : (root - c1) / (2 * c2);
}

/// Zero of a rising f, f(low) < 0 < f(high): root of the quadratic fit at both ends and the middle.
template <class Function> double fitted_crossing(const Function& f, double low, double high) {
  return low + fitted_root(f(low), f(0.5 * (low + high)), f(high)) * (high - low);
}

/// The theta method with tracked boundaries.
class BoundaryTracker {
public:
  BoundaryTracker(const ModelProblem& problem, int mx, double theta, std::vector<double>& transitions)
      : problem_(problem), theta_(theta), rounding_(4 * mx * epsilon), shortest_rest_(0.05 / mx),
        transitions_(transitions) {}

  /// Each boundary ends the step there, and its rest is a separate step. So many boundaries in one step mean that the
  /// grid does not resolve them.
  Front step(Front front, const Point& point) const {
    for (int boundaries = 0; boundaries < 8; ++boundaries) {
      const double trial = trial_displacement(front, point.x, point.rigid_slip, theta_);
      if (front.state == ModelState::adhesion) {
        if (std::abs(trial) <= point.bound) return adhere(point, trial);
        const ModelState state = slip_towards(trial);
        const double x = end_of_adhesion(front, point, state);
        if (point.x - x <= rounding_) return adhere(point, trial);
        front = start_slip(x, state);
      } else {
        const double slip = slip_at_bound(front, point, trial);
        if (slip * sign(front.state) <= 0) return {point, sign(front.state) * point.bound, slip, front.state};
        front = start_adhesion(front, point, slip);
      }
      record_transition(front.at.x);
    }
    return plain_step(front, point, theta_);
  }

private:
  /// Two boundaries at one point are none.
  void record_transition(double x) const {
    if (!transitions_.empty() && transitions_.back() == x)
      transitions_.pop_back();
    else
      transitions_.push_back(x);
  }

  /// Step 4''(b): where the trial adhesion solution crosses the bound. A step that starts on the bound starts to slip
  /// there, unless the bound rises faster than the solution: then the crossing lies beyond a first stretch below it.
  double end_of_adhesion(const Front& front, const Point& point, ModelState state) const {
    const auto excess = [&](double x) {
      return sign(state) * trial_displacement(front, x, problem_.rigid_slip(x), theta_) - problem_.bound(x);
    };
    double low = front.at.x, high = point.x;
    if (excess(low) < 0) return fitted_crossing(excess, low, high);
    if (-sign(state) * front.at.rigid_slip >= problem_.bound_slope(low)) return low;
    while (high - low > rounding_) {
      const double middle = 0.5 * (low + high);
      if (excess(middle) < 0) return fitted_crossing(excess, middle, high);
      high = middle;
    }
    return high;
  }

  /// (F34); against the displacement, also where the crossing is only estimated.
  Front start_slip(double x, ModelState state) const {
    const Point point = sample(problem_, x);
    const double slope = require_finite("bound_slope", problem_.bound_slope(x), "-");
    const double slip = sign(state) * std::min(0.0, sign(state) * point.rigid_slip + slope);
    return {point, sign(state) * point.bound, slip, state};
  }

  /// (F33), or (F34) where it would divide rounding errors by a short step.
  double slip_at_bound(const Front& front, const Point& point, double trial) const {
    const double length = point.x - front.at.x;
    if (length < shortest_rest_) {
      const double slip = point.rigid_slip + sign(front.state) * problem_.bound_slope(point.x);
      if (std::isfinite(slip)) return slip;
    }
    return (sign(front.state) * point.bound - trial) / (theta_ * length);
  }

  /// Step 3''(b): slip is linear over the step, from the front's to the trial slip of opposite sign at the point.
  Front start_adhesion(const Front& front, const Point& point, double trial_slip) const {
    const double x = front.at.x + (point.x - front.at.x) * front.s / (front.s - trial_slip);
    const Point boundary = sample(problem_, std::clamp(x, front.at.x, point.x));
    return {boundary, sign(front.state) * boundary.bound, 0, ModelState::adhesion};
  }

  const ModelProblem& problem_;
  double theta_;
  double rounding_;      ///< of positions, from the sum of mx steps
  double shortest_rest_; ///< of a step, that (F31) still gives slip from
  std::vector<double>& transitions_;
};

/// Marches from the leading to the trailing edge; step(front, point) gives the solution at the next point.
template <class Step> ModelSolution march(const ModelProblem& problem, int mx, const Step& step) {
  ModelSolution solution;
  Front front = leading_edge(problem);
  const auto record = [&] {
    solution.x.push_back(front.at.x);
    solution.displacement.push_back(front.u);
    solution.slip.push_back(front.s);
  };
  record();
  for (int i = 1; i <= mx; ++i) {
    front = step(front, sample(problem, double(i) / mx), solution.transitions);
    record();
  }
  return solution;
}

void require_valid(const ModelProblem& problem, int mx, double theta) {
  if (!problem.bound || !problem.bound_slope || !problem.rigid_slip)
    throw Error("model problem: needs the functions bound, bound_slope and rigid_slip");
  require_count("mx", mx, 1, 10'000'000);
  require_between("theta", theta, "-", 0.5, 1);
}

/// Bisection to the last bit; f changes sign between low and high.
template <class Function> double bisect(const Function& f, double low, double high) {
  const bool rising = f(high) > 0;
  for (double x = 0.5 * (low + high); low < x && x < high; x = 0.5 * (low + high))
    ((f(x) > 0) == rising ? high : low) = x;
  return low;
}

double square(double x) {
  return x * x;
}

} // namespace

ModelProblem model_problem(TractionBound bound, double rigid_slip_0, double rigid_slip_1) {
  ModelProblem problem;
  problem.rigid_slip = [=](double x) { return rigid_slip_0 + rigid_slip_1 * x; };
  if (bound == TractionBound::parabolic) {
    problem.bound = [](double x) { return 4 * x * (1 - x); };
    problem.bound_slope = [](double x) { return 4 - 8 * x; };
  } else {
    problem.bound = [](double x) { return 2 * std::sqrt(x * (1 - x)); };
    problem.bound_slope = [](double x) { return (1 - 2 * x) / std::sqrt(x * (1 - x)); };
  }
  return problem;
}

ModelCase::ModelCase(std::string_view name, TractionBound bound, double rigid_slip_0, double rigid_slip_1,
                     std::vector<ModelPiece> pieces)
    : name_(name), rigid_slip_0_(rigid_slip_0), rigid_slip_1_(rigid_slip_1),
      problem_(model_problem(bound, rigid_slip_0, rigid_slip_1)), pieces_(std::move(pieces)) {}

std::vector<double> ModelCase::transitions() const {
  std::vector<double> ends;
  for (const ModelPiece& piece : pieces_) ends.push_back(piece.end);
  ends.pop_back();
  return ends;
}

const ModelPiece& ModelCase::piece(double x) const {
  return *std::find_if(pieces_.begin(), pieces_.end() - 1, [x](const ModelPiece& piece) { return x <= piece.end; });
}

double ModelCase::displacement(double x) const {
  const ModelPiece& here = piece(x);
  if (here.state != ModelState::adhesion) return sign(here.state) * problem_.bound(x);
  return here.offset - x * (rigid_slip_0_ + 0.5 * rigid_slip_1_ * x);
}

double ModelCase::slip(double x) const {
  const ModelPiece& here = piece(x);
  if (here.state == ModelState::adhesion) return 0;
  return problem_.rigid_slip(x) + sign(here.state) * problem_.bound_slope(x);
}

std::array<ModelCase, 3> model_cases() {
  using enum ModelState;
  using enum TractionBound;

  const double end_1 = (4 - 0.1) / (4 + 6);

  // From -w = u_max', and from 11 x^2 - 10 x + 1/3 = 0.
  const double start_2 = 1.0 / 3, end_2 = (5 + std::sqrt(25 - 11.0 / 3)) / 11;

  // The squares of 6x - 7x^2 = u_max (divided by its root x = 0), of -w = u_max' and of offset + 6x - 7x^2 = -u_max.
  const double slip_3 = bisect([](double x) { return x * square(6 - 7 * x) - 4 * (1 - x); }, 0.1, 0.2);
  const double start_3 =
      bisect([](double x) { return square(6 - 14 * x) * x * (1 - x) - square(1 - 2 * x); }, 0.3, 0.42);
  const double offset_3 = 2 * std::sqrt(start_3 * (1 - start_3)) - start_3 * (6 - 7 * start_3);
  const double end_3 = bisect([=](double x) { return square(offset_3 + x * (6 - 7 * x)) - 4 * x * (1 - x); }, 0.8, 1);

  return {ModelCase("parabolic bound, small spin", parabolic, -0.1, -12, {{adhesion, end_1}, {slip_above, 1}}),
          ModelCase("parabolic bound, large spin", parabolic, -6, 14,
                    {{slip_above, start_2}, {adhesion, end_2, -1.0 / 3}, {slip_below, 1}}),
          ModelCase("elliptic bound", elliptic, -6, 14,
                    {{adhesion, slip_3}, {slip_above, start_3}, {adhesion, end_3, offset_3}, {slip_below, 1}})};
}

ModelSolution solve_backward_euler(const ModelProblem& problem, int mx) {
  return solve_theta_method(problem, mx, 1);
}

ModelSolution solve_theta_method(const ModelProblem& problem, int mx, double theta) {
  require_valid(problem, mx, theta);
  return march(problem, mx, [theta](const Front& front, const Point& point, std::vector<double>& transitions) {
    const Front next = plain_step(front, point, theta);
    if (next.state != front.state) transitions.push_back(point.x);
    return next;
  });
}

ModelSolution solve_tracked(const ModelProblem& problem, int mx, double theta) {
  require_valid(problem, mx, theta);
  return march(problem, mx, [&](const Front& front, const Point& point, std::vector<double>& transitions) {
    return BoundaryTracker(problem, mx, theta, transitions).step(front, point);
  });
}

} // namespace microslip
