#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace microslip::fit {

/// Sum of squares of n residuals over k parameters in a box. Residuals are smooth functions, or nearly so.
struct LeastSquares {
  /// Writes the n residuals at parameters; false where there are none, which counts as infinitely bad.
  std::function<bool(std::span<const double> parameters, std::span<double> residuals)> residuals;
  std::size_t count = 0;                      ///< n
  std::vector<double> lower = {}, upper = {}; ///< ends of the box, k of each
  double step = 3e-3;                         ///< of the differences that derivatives are found by
};

/// Minimum of a sum of squares.
struct LeastSquaresMinimum {
  std::vector<double> parameters = {};
  std::vector<double> residuals = {};
  /// Derivatives of the residuals, n rows of k numbers, at parameters at most a few steps back.
  std::vector<double> jacobian = {};
  double cost = 0; ///< sum of squared residuals; infinite if there are none at the start
};

/// When a search ends.
struct DescentEnd {
  int steps = 60;
  double gain = 1e-8;       ///< of a step, over the cost
  bool is_confirmed = true; ///< by derivatives that are differences at the minimum
};

/// Finds a local minimum from `start` by Levenberg's and Marquardt's method. Parameters that `held` marks stay (empty:
/// none). The derivatives are forward differences, kept up to date by Broyden's formula between these; of a start that
/// has `jacobian` they are those.
/// Cost: some k + 1 evaluations for every three steps, and one for each.
LeastSquaresMinimum minimise(const LeastSquares& problem, std::span<const double> start,
                             const std::vector<bool>& held = {}, std::vector<double> jacobian = {},
                             const DescentEnd& end = {});

/// Derivatives of the residuals at parameters by forward differences, n rows of k numbers; by backward ones at the
/// upper end of the box and where there are no residuals before it; nothing where there are none on either side.
std::optional<std::vector<double>> find_jacobian(const LeastSquares& problem, std::span<const double> parameters,
                                                 std::span<const double> residuals);

/// Inverse of a symmetric matrix of k rows; a parameter without any effect counts as one with very little.
std::vector<double> inverse_of(const std::vector<double>& matrix, std::size_t k);

/// J^T diag(w) J of n rows of k numbers.
std::vector<double> normal_matrix(const std::vector<double>& jacobian, std::span<const double> weights, std::size_t k);

} // namespace microslip::fit
