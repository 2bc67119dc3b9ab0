#include "microslip/exact/newton/coupled_newton.hpp"

#include "microslip/exact/newton/coupled_equations.hpp"
#include "microslip/exact/newton/full_sliding.hpp"
#include "microslip/exact/newton/semismooth_newton.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace microslip {
namespace {

/// Least goal of |F| over the pressure's norm: what rounding leaves of it on fine grids.
constexpr double least_goal = 1e-12;

/// Unknowns and response of the start with the least residual.
void begin(CoupledEquations& equations, std::span<const CoupledFrictionStart> starts, std::vector<double>& x,
           std::vector<double>& response) {
  equations.start(starts.front(), x, response);
  if (starts.size() == 1) return;
  std::vector<double> f(x.size()), other_x(x.size()), other_response(response.size());
  double least = equations.evaluate(x, response, f);
  for (const CoupledFrictionStart& start : starts.subspan(1)) {
    equations.start(start, other_x, other_response);
    const double residual = equations.evaluate(other_x, other_response, f);
    if (!(residual < least)) continue;
    least = residual;
    std::swap(x, other_x);
    std::swap(response, other_response);
  }
}

} // namespace

CoupledFrictionSolution CoupledNewton::solve(const CoupledFrictionProblem& problem, const Options& options,
                                             std::span<const CoupledFrictionStart> starts) {
  const long products_before = problem.coupled_operator.products();
  const std::span<const double> pressure = starts.front().pressure;
  CoupledEquations equations(problem, pressure, options.preconditioned);
  std::vector<double> x(equations.size()), response(equations.responses()), f(equations.size());
  begin(equations, starts, x, response);
  if (auto sliding = full_sliding(problem, pressure)) {
    CoupledFrictionSolution s = equations.solution(x, response); // for the approach
    s.pressure.assign(pressure.begin(), pressure.end());
    s.friction = std::move(*sliding);
    s.friction.report.products = problem.coupled_operator.products() - products_before;
    return s;
  }
  const double wanted = options.tolerance * equations.scale();
  const double goal = std::max(wanted / equations.strictness(), std::min(wanted, least_goal * equations.scale()));
  const NewtonLimits limits{goal, options.most_steps, options.budget, options.progress, options.shortest_step};
  NewtonState state;
  for (bool done = false; !done;) {
    take_newton_steps(equations, gmres_, limits, x, response, state);
    if (!(state.norm <= limits.goal)) break;
    equations.find_response(x, response); // with the rounding errors collected so far
    done = equations.evaluate(x, response, f) <= limits.goal;
  }
  CoupledFrictionSolution s = equations.solution(x, response);
  s.friction.report.residual = equations.scale() > 0 ? equations.strictness() * state.norm / equations.scale() : 0;
  s.friction.report.newton_steps = state.steps;
  s.friction.report.products = problem.coupled_operator.products() - products_before;
  s.friction.report.status = state.norm <= limits.goal ? Status::ok : Status::not_converged;
  return s;
}

} // namespace microslip
