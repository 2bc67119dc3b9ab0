#include "microslip/exact/newton/friction_newton.hpp"

#include "microslip/exact/newton/friction_equations.hpp"
#include "microslip/exact/newton/full_sliding.hpp"
#include "microslip/exact/newton/semismooth_newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

using Field = std::vector<double>;

/// Least goal of |F| over |g|: what rounding leaves of it on fine grids.
constexpr double least_goal = 1e-12;

/// Returns whether a start is nothing but these tractions.
bool is(const FrictionStart& start, const TractionsView& tractions) {
  return start.px.data() == tractions.px.data() && start.px.size() == tractions.px.size() && !start.constants &&
         start.by_constants[0].px.empty() && start.by_constants[1].px.empty();
}

} // namespace

FrictionSolution FrictionNewton::solve(const FrictionProblem& problem, const Options& options,
                                       const FrictionStart& start) {
  if (auto sliding = full_sliding(problem)) return std::move(*sliding);
  const long products_before = problem.slip_operator.products();
  FrictionEquations equations(problem);
  Field x(equations.size()), slip(equations.responses());
  double goal = options.tolerance * equations.scale();
  if (options.before) {
    equations.start({.px = options.before->px, .py = options.before->py}, x, slip);
    Field f(equations.size());
    const double change = equations.evaluate(x, slip, f);
    goal = std::min(goal, std::max(options.tolerance * change, least_goal * equations.scale()));
  }
  goal = std::max(goal / equations.strictness(), std::min(goal, least_goal * equations.scale()));
  if (!options.before || !is(start, *options.before)) equations.start(start, x, slip);
  const NewtonLimits limits{goal, options.most_steps, options.budget, options.progress, options.shortest_step};
  NewtonState state;
  take_newton_steps(equations, gmres_, limits, x, slip, state);
  int steps = state.steps;
  const bool may_restart = !problem.slip_dependent && !start.px.empty() && !state.stopped;
  if (!(state.norm <= goal) && may_restart) { // a start may be worse than none
    Field other_x(x.size()), other_slip(slip.size());
    NewtonState other;
    equations.start({}, other_x, other_slip);
    take_newton_steps(equations, gmres_, limits, other_x, other_slip, other);
    steps += other.steps;
    if (other.norm < state.norm || std::isnan(state.norm))
      state.norm = other.norm, x = std::move(other_x), slip = std::move(other_slip);
  }
  FrictionSolution s = equations.solution(x, slip);
  s.report.newton_steps = steps;
  s.report.products = problem.slip_operator.products() - products_before;
  s.report.status = state.norm <= goal ? Status::ok : Status::not_converged;
  return s;
}

} // namespace microslip
