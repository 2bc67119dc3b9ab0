#include "microslip/exact/newton/full_sliding.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace microslip {
namespace {

/// Tractions as large as the bound along (fx, fy), whose size is `wanted`.
FrictionSolution sliding_along(double fx, double fy, double wanted, double capacity, std::span<const double> bound) {
  FrictionSolution s(bound.size());
  s.report.status = Status::no_solution;
  s.report.residual = wanted / capacity - 1;
  for (std::size_t k = 0; k < bound.size(); ++k) {
    s.traction.x[k] = bound[k] * fx / wanted;
    s.traction.y[k] = bound[k] * fy / wanted;
    s.sliding[k] = bound[k] > 0;
  }
  return s;
}

} // namespace

std::optional<FrictionSolution> full_sliding(const FrictionProblem& problem) {
  const double fx = problem.force_x.value_or(0), fy = problem.force_y.value_or(0), wanted = std::hypot(fx, fy);
  double capacity = 0;
  for (std::size_t k = 0; k < problem.bound.size(); ++k)
    capacity += problem.bound[k] * problem.element_area * (problem.area_share.empty() ? 1 : problem.area_share[k]);
  if (!(wanted >= capacity && wanted > 0)) return {};
  return sliding_along(fx, fy, wanted, capacity, problem.bound);
}

std::optional<FrictionSolution> full_sliding(const CoupledFrictionProblem& problem, std::span<const double> pressure) {
  constexpr double too_small_to_yield = 1e-200; // a pressure under which it is friction that bounds, not a layer
  const double fx = problem.force_x.value_or(0), fy = problem.force_y.value_or(0), wanted = std::hypot(fx, fy);
  const auto bound_of = [&](std::span<const double> p) {
    std::vector<double> bound(p.begin(), p.end());
    if (problem.slip_dependent)
      problem.slip_dependent->largest(p, bound);
    else
      for (std::size_t k = 0; k < bound.size(); ++k) bound[k] *= problem.friction[k];
    return bound;
  };
  const std::vector<double> least = bound_of(std::vector<double>(pressure.size(), too_small_to_yield));
  const double capacity = least.empty() ? 0 : *std::max_element(least.begin(), least.end()) / too_small_to_yield;
  if (!(wanted >= capacity && wanted > 0)) return {};
  return sliding_along(fx, fy, wanted, capacity, bound_of(pressure));
}

} // namespace microslip
