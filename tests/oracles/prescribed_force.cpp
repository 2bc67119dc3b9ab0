#include "tests/oracles/prescribed_force.hpp"

#include "microslip/vec2.hpp"
#include "tests/oracles/friction_residual.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace microslip {
namespace {

constexpr int most_steps = 50, most_halvings = 12;

using Field = std::vector<double>;

double length(Vec2 v) {
  return std::hypot(v.x, v.y);
}

/// The problem with its constants given.
class GivenConstants {
public:
  GivenConstants(const FrictionProblem& problem, double tolerance, const FrictionSolver& solve)
      : problem_(problem), tolerance_(tolerance), solve_(solve), cx_(problem.bound.size()), cy_(cx_) {}

  FrictionSolution solve(Vec2 constants, std::span<const double> start_px, std::span<const double> start_py) {
    for (std::size_t k = 0; k < cx_.size(); ++k) {
      const double share = problem_.constant_share.empty() ? 1 : problem_.constant_share[k];
      cx_[k] = problem_.cx[k] + share * constants.x;
      cy_[k] = problem_.cy[k] + share * constants.y;
    }
    const FrictionProblem given{problem_.slip_operator, problem_.bound, cx_, cy_, problem_.element_area};
    FrictionSolution s = solve_(given, tolerance_, start_px, start_py);
    s.constants.x = constants.x;
    s.constants.y = constants.y;
    find_residual(problem_, s);
    return s;
  }

  /// What the sum of the tractions has too much; 0 where no force is given.
  Vec2 excess(const FrictionSolution& s) const {
    const auto of = [&](const std::optional<double>& force, const Field& p) {
      return force ? std::accumulate(p.begin(), p.end(), 0.0) - *force / problem_.element_area : 0;
    };
    return {of(problem_.force_x, s.traction.x), of(problem_.force_y, s.traction.y)};
  }

  /// The change of the constants that by linear extrapolation makes the excess vanish. Differences are taken over
  /// `small`.
  Vec2 newton_step(const FrictionSolution& s, double small) {
    const Vec2 now = excess(s);
    const auto derivative = [&](Vec2 change) {
      const Vec2 there =
          excess(solve({s.constants.x + change.x, s.constants.y + change.y}, s.traction.x, s.traction.y));
      return Vec2{(there.x - now.x) / small, (there.y - now.y) / small};
    };
    const Vec2 by_x = problem_.force_x ? derivative({small, 0}) : Vec2{1, 0};
    const Vec2 by_y = problem_.force_y ? derivative({0, small}) : Vec2{0, 1};
    const double determinant = by_x.x * by_y.y - by_y.x * by_x.y;
    return {(by_y.x * now.y - by_y.y * now.x) / determinant, (by_x.y * now.x - by_x.x * now.y) / determinant};
  }

private:
  const FrictionProblem& problem_;
  double tolerance_;
  const FrictionSolver& solve_;
  Field cx_, cy_;
};

} // namespace

FrictionSolution solve_prescribed_force(const FrictionProblem& problem, double tolerance, const FrictionSolver& solve,
                                        std::span<const double> start_px, std::span<const double> start_py) {
  if (!problem.force_x && !problem.force_y) return solve(problem, tolerance, start_px, start_py);
  GivenConstants search(problem, tolerance / 10, solve);
  FrictionSolution s = search.solve({0, 0}, start_px, start_py);
  // Small against the slip that the traction of one element makes on itself.
  const double least =
      1e-4 * problem.slip_operator.diagonal() * *std::max_element(problem.bound.begin(), problem.bound.end());
  double small = least;
  for (int k = 0; k < most_steps && s.report.residual > tolerance; ++k) {
    const Vec2 step = search.newton_step(s, small);
    if (!std::isfinite(step.x) || !std::isfinite(step.y)) break;
    const double before = length(search.excess(s));
    FrictionSolution trial;
    double share = 1;
    for (int halving = 0; halving < most_halvings; ++halving, share /= 2) {
      trial =
          search.solve({s.constants.x + share * step.x, s.constants.y + share * step.y}, s.traction.x, s.traction.y);
      if (length(search.excess(trial)) < (1 - 1e-4 * share) * before) break;
    }
    s = std::move(trial);
    small = std::max(1e-2 * share * length(step), least);
  }
  s.report.status = s.report.residual <= tolerance ? Status::ok : Status::not_converged;
  return s;
}

} // namespace microslip
