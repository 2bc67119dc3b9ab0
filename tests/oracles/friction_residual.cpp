#include "tests/oracles/friction_residual.hpp"

#include <cmath>

namespace microslip {

double bound_norm(const FrictionProblem& problem) {
  double sum = 0;
  for (const double g : problem.bound) sum += g * g;
  return std::sqrt(sum);
}

void find_residual(const FrictionProblem& problem, FrictionSolution& s) {
  const std::size_t count = problem.bound.size();
  s.slip.x.assign(count, 0.0);
  s.slip.y.assign(count, 0.0);
  s.sliding.assign(count, 0);
  problem.slip_operator.apply(s.traction.x, s.traction.y, s.slip.x, s.slip.y);
  const double rho = 1 / problem.slip_operator.diagonal();
  double sum = 0, total_x = 0, total_y = 0;
  std::size_t elements = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double g = problem.bound[k];
    if (!(g > 0)) {
      s.slip.x[k] = s.slip.y[k] = 0;
      continue;
    }
    const double share = problem.constant_share.empty() ? 1 : problem.constant_share[k];
    s.slip.x[k] += problem.cx[k] + share * s.constants.x;
    s.slip.y[k] += problem.cy[k] + share * s.constants.y;
    const double zx = s.traction.x[k] - rho * s.slip.x[k], zy = s.traction.y[k] - rho * s.slip.y[k];
    const double size = std::hypot(zx, zy), factor = size > g ? g / size : 1;
    s.sliding[k] = size > g && on_bound(s.traction.x[k], s.traction.y[k], g);
    sum += std::pow(s.traction.x[k] - factor * zx, 2) + std::pow(s.traction.y[k] - factor * zy, 2);
    total_x += s.traction.x[k];
    total_y += s.traction.y[k];
    ++elements;
  }
  const double n = static_cast<double>(elements);
  if (problem.force_x) sum += std::pow(total_x - *problem.force_x / problem.element_area, 2) / n;
  if (problem.force_y) sum += std::pow(total_y - *problem.force_y / problem.element_area, 2) / n;
  s.report.residual = elements > 0 ? std::sqrt(sum) / bound_norm(problem) : 0;
}

} // namespace microslip
