#pragma once

#include "microslip/numerics/elimination.hpp"
#include "microslip/numerics/norm.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace microslip {

/// Result of find_root.
struct NewtonResult {
  double residual = 0; ///< the largest magnitude at the point accepted last
  int steps = 0;       ///< those that were refused as well
};

/// The largest magnitude; NaN if there is one.
inline double largest_magnitude(std::span<const double> v) {
  double largest = 0;
  for (const double x : v)
    if (std::abs(x) > largest || std::isnan(x)) largest = std::abs(x);
  return largest;
}

/// Broyden's update of a matrix, row by row: the one that differs least from it and has A step = change.
template <std::size_t n>
void update_by_broyden(std::array<double, n * n>& matrix, const std::array<double, n>& step,
                       const std::array<double, n>& change) {
  double square = 0;
  for (const double s : step) square += s * s;
  for (std::size_t i = 0; i < n; ++i) {
    double* const row = matrix.data() + i * n;
    double missing = change[i];
    for (std::size_t j = 0; j < n; ++j) missing -= row[j] * step[j];
    for (std::size_t j = 0; j < n; ++j) row[j] += missing * step[j] / square;
  }
}

/// Newton's method for n equations until no residual exceeds the tolerance. Steps are halved until the norm of the
/// residuals falls; the Jacobian is found anew where Broyden's updates of it no longer reduce that to a tenth. Gives up
/// where neither helps, as at a jump, at a singular Jacobian, and after 25 steps. The unknowns count in units of
/// changes that matter: a step changes none by more than 30. `equations` hold a point and have
/// - `std::array<double, n> residual(const std::array<double, n>& step)`: the residuals at the point moved by a step;
/// - `void accept()`: takes the step of the last residual;
/// - `std::array<double, n * n> jacobian()`: their derivatives at the point, row by row.
/// Cost: an evaluation of the residuals a step and one more, some Jacobians.
template <std::size_t n, class Equations> NewtonResult find_root(Equations&& equations, double tolerance) {
  constexpr int most_steps = 25, most_halvings = 6;
  constexpr double good_reduction = 0.1, longest_step = 30;
  std::array<double, n> value = equations.residual({});
  equations.accept();
  std::array<double, n * n> slope{};
  bool stale = true;
  NewtonResult result;
  while (result.steps < most_steps && largest_magnitude(value) > tolerance) {
    if (stale) slope = equations.jacobian();
    std::array<double, n> tried{}, next{};
    const auto step = solve_linear<n>(slope, value);
    if (!step) break;
    double part = std::min(1.0, longest_step / largest_magnitude(*step));
    for (int halving = 0; halving < most_halvings; ++halving, part /= 2) {
      for (std::size_t i = 0; i < n; ++i) tried[i] = -part * (*step)[i];
      next = equations.residual(tried);
      if (norm(next) < norm(value)) break;
    }
    ++result.steps;
    const double reduction = norm(next) / norm(value);
    if (!(reduction < 1)) {
      if (stale) break;
      stale = true; // the updates have led astray
      continue;
    }
    std::array<double, n> change{};
    for (std::size_t i = 0; i < n; ++i) change[i] = next[i] - value[i];
    update_by_broyden<n>(slope, tried, change);
    stale = reduction > good_reduction;
    equations.accept();
    value = next;
  }
  result.residual = largest_magnitude(value);
  return result;
}

} // namespace microslip
