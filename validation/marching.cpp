#include "validation/marching.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::validation {
namespace {

/// Steps in which the contact moves by a quarter of its length: the state changes too slowly to judge it step by step.
int steps_to_judge(const ElementGrid& grid, std::span<const double> bound, double step) {
  int first = grid.mx, last = -1;
  for (std::size_t k = 0; k < bound.size(); ++k) {
    if (!(bound[k] > 0)) continue;
    const int i = static_cast<int>(k % static_cast<std::size_t>(grid.mx));
    first = std::min(first, i);
    last = std::max(last, i);
  }
  return std::max(1, static_cast<int>((last - first + 1) * grid.dx / (4 * step)));
}

/// |p - before|/|g|.
double relative_change(const VectorField& p, const VectorField& before, std::span<const double> bound) {
  double change = 0, size = 0;
  for (std::size_t k = 0; k < bound.size(); ++k) {
    const double dx = p.x[k] - (before.x.empty() ? 0 : before.x[k]);
    const double dy = p.y[k] - (before.y.empty() ? 0 : before.y[k]);
    change += dx * dx + dy * dy;
    size += bound[k] * bound[k];
  }
  return size > 0 ? std::sqrt(change / size) : 0;
}

} // namespace

MarchedSolution march_to_steady(TangentialProblem& problem, const ElementGrid& grid, std::span<const double> bound,
                                TangentialInput input, const MarchingLimits& limits) {
  const int interval = steps_to_judge(grid, bound, input.step > 0 ? input.step : grid.dx);
  input.motion = ContactMotion::transient;
  VectorField state;
  if (input.previous) state = *input.previous;
  input.previous = &state;
  input.start = &state;

  MarchedSolution out;
  VectorField judged = state;
  while (out.steps < limits.most_steps) {
    out.last = problem.solve(bound, input);
    state = out.last.fields.traction;
    ++out.steps;
    if (out.last.report.status != Status::ok) return out;
    if (out.steps % interval != 0) continue;
    out.change = relative_change(state, judged, bound);
    if (out.change <= limits.change) return out;
    judged = state;
  }
  out.last.report.status = Status::not_converged;
  return out;
}

} // namespace microslip::validation
