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
  s.sx.assign(count, 0.0);
  s.sy.assign(count, 0.0);
  s.sliding.assign(count, 0);
  problem.slip_operator.apply(s.px, s.py, s.sx, s.sy);
  const double rho = 1 / problem.slip_operator.diagonal();
  double sum = 0, total_x = 0, total_y = 0;
  std::size_t elements = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double g = problem.bound[k];
    if (!(g > 0)) {
      s.sx[k] = s.sy[k] = 0;
      continue;
    }
    const double share = problem.constant_share.empty() ? 1 : problem.constant_share[k];
    s.sx[k] += problem.cx[k] + share * s.constant_x;
    s.sy[k] += problem.cy[k] + share * s.constant_y;
    const double zx = s.px[k] - rho * s.sx[k], zy = s.py[k] - rho * s.sy[k];
    const double size = std::hypot(zx, zy), factor = size > g ? g / size : 1;
    s.sliding[k] = size > g && on_bound(s.px[k], s.py[k], g);
    sum += std::pow(s.px[k] - factor * zx, 2) + std::pow(s.py[k] - factor * zy, 2);
    total_x += s.px[k];
    total_y += s.py[k];
    ++elements;
  }
  const double n = static_cast<double>(elements);
  if (problem.force_x) sum += std::pow(total_x - *problem.force_x / problem.element_area, 2) / n;
  if (problem.force_y) sum += std::pow(total_y - *problem.force_y / problem.element_area, 2) / n;
  s.residual = elements > 0 ? std::sqrt(sum) / bound_norm(problem) : 0;
}

} // namespace microslip
