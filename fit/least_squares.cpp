#include "fit/least_squares.hpp"

#include "microslip/numerics/elimination.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace microslip::fit {
namespace {

double square_sum(std::span<const double> values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.);
}

/// The iteration of `minimise`.
class Descent {
public:
  Descent(const LeastSquares& problem, std::span<const double> start, const std::vector<bool>& held,
          std::vector<double> jacobian, const DescentEnd& end)
      : problem_(problem), held_(held), end_(end), k_(start.size()) {
    if (held_.empty()) held_.assign(k_, false);
    now_.parameters.assign(start.begin(), start.end());
    for (std::size_t j = 0; j < k_; ++j)
      now_.parameters[j] = std::clamp(now_.parameters[j], problem_.lower[j], problem_.upper[j]);
    now_.residuals.resize(problem_.count);
    now_.cost = problem_.residuals(now_.parameters, now_.residuals) ? square_sum(now_.residuals)
                                                                    : std::numeric_limits<double>::infinity();
    now_.jacobian = std::move(jacobian);
    is_fresh_ = false;
    if (now_.jacobian.empty() && std::isfinite(now_.cost)) renew_jacobian();
  }

  LeastSquaresMinimum run() {
    for (int step = 0; step < end_.steps && std::isfinite(now_.cost) && !now_.jacobian.empty(); ++step)
      if (!advance()) break;
    return std::move(now_);
  }

private:
  void renew_jacobian() {
    now_.jacobian = find_jacobian(problem_, now_.parameters, now_.residuals).value_or(std::vector<double>());
    is_fresh_ = true;
    age_ = 0;
  }

  /// Parameters that move: not held, nor at an end of the box and pushed outwards.
  std::vector<std::size_t> moving(std::span<const double> downhill) const {
    std::vector<std::size_t> found;
    for (std::size_t j = 0; j < k_; ++j) {
      const double t = now_.parameters[j];
      const bool is_stopped =
          (t <= problem_.lower[j] && downhill[j] < 0) || (t >= problem_.upper[j] && downhill[j] > 0);
      if (!held_[j] && !is_stopped) found.push_back(j);
    }
    return found;
  }

  /// The damped step of the moving parameters, at most 1 in each, for which the damping grows; `gain`: at least what it
  /// should lower the cost by.
  std::vector<double> find_step(double& gain) const {
    std::vector<double> downhill(k_, 0);
    for (std::size_t i = 0; i < problem_.count; ++i)
      for (std::size_t j = 0; j < k_; ++j) downhill[j] -= now_.jacobian[i * k_ + j] * now_.residuals[i];
    const auto free = moving(downhill);
    const std::vector<double> normal = normal_matrix(now_.jacobian, std::vector<double>(problem_.count, 1), k_);
    std::vector<double> step(k_, 0);
    double longest = 2;
    for (double damping = damping_; longest > 1 && damping < most_damping; damping *= 4) {
      step = damped_step(normal, downhill, free, damping);
      longest = 0;
      for (const double part : step) longest = std::max(longest, std::abs(part));
    }
    if (longest > 1)
      for (double& part : step) part /= longest;
    gain = std::inner_product(step.begin(), step.end(), downhill.begin(), 0.);
    return step;
  }

  /// Solution of (H + damping diag(H)) d = g for the free parameters.
  std::vector<double> damped_step(const std::vector<double>& normal, std::span<const double> downhill,
                                  const std::vector<std::size_t>& free, double damping) const {
    const std::size_t m = free.size();
    std::vector<double> step(k_, 0), rows(m * (m + 1), 0);
    for (std::size_t p = 0; p < m; ++p) {
      for (std::size_t q = 0; q < m; ++q) rows[p * (m + 1) + q] = normal[free[p] * k_ + free[q]];
      rows[p * (m + 1) + p] = rows[p * (m + 1) + p] * (1 + damping) + 1e-12;
      rows[p * (m + 1) + m] = downhill[free[p]];
    }
    if (m > 0 && eliminate(rows, m, 1))
      for (std::size_t p = 0; p < m; ++p) step[free[p]] = rows[p * (m + 1) + m];
    return step;
  }

  /// One step; false at the end.
  bool advance() {
    constexpr int oldest = 3; // steps by Broyden's formula
    double gain = 0;
    const std::vector<double> step = find_step(gain);
    if (gain < end_.gain * now_.cost) return confirm();
    LeastSquaresMinimum next{.parameters = now_.parameters, .residuals = std::vector<double>(problem_.count)};
    for (std::size_t j = 0; j < k_; ++j)
      next.parameters[j] = std::clamp(next.parameters[j] + step[j], problem_.lower[j], problem_.upper[j]);
    if (next.parameters == now_.parameters) return false;
    next.cost = problem_.residuals(next.parameters, next.residuals) ? square_sum(next.residuals)
                                                                    : std::numeric_limits<double>::infinity();
    if (!(next.cost < now_.cost)) {
      if (!is_fresh_)
        renew_jacobian();
      else
        damping_ *= 5;
      return damping_ < most_damping && !now_.jacobian.empty();
    }
    const bool is_done = now_.cost - next.cost < end_.gain * now_.cost;
    next.jacobian = updated_jacobian(next);
    now_ = std::move(next);
    damping_ /= 5;
    is_fresh_ = false;
    if (is_done) return confirm();
    if (++age_ >= oldest) renew_jacobian();
    return !now_.jacobian.empty();
  }

  /// Ends the search, or renews the derivatives for a last look; returns whether it goes on.
  bool confirm() {
    if (is_fresh_ || !end_.is_confirmed) return false;
    renew_jacobian();
    return !now_.jacobian.empty();
  }

  /// Broyden's formula: J + (r' - r - J d) d^T/(d^T d).
  std::vector<double> updated_jacobian(const LeastSquaresMinimum& next) const {
    std::vector<double> d(k_), jacobian = now_.jacobian;
    for (std::size_t j = 0; j < k_; ++j) d[j] = next.parameters[j] - now_.parameters[j];
    const double length = square_sum(d);
    for (std::size_t i = 0; i < problem_.count; ++i) {
      double* const row = &jacobian[i * k_];
      const double miss = next.residuals[i] - now_.residuals[i] - std::inner_product(d.begin(), d.end(), row, 0.);
      for (std::size_t j = 0; j < k_; ++j) row[j] += miss * d[j] / length;
    }
    return jacobian;
  }

  static constexpr double most_damping = 1e8;

  const LeastSquares& problem_;
  std::vector<bool> held_;
  DescentEnd end_;
  std::size_t k_;
  LeastSquaresMinimum now_;
  double damping_ = 1e-3;
  bool is_fresh_ = true; ///< whether the derivatives are differences at the present parameters
  int age_ = 0;
};

} // namespace

std::optional<std::vector<double>> find_jacobian(const LeastSquares& problem, std::span<const double> parameters,
                                                 std::span<const double> residuals) {
  const std::size_t k = parameters.size();
  std::vector<double> jacobian(problem.count * k), moved(parameters.begin(), parameters.end()), there(problem.count);
  for (std::size_t j = 0; j < k; ++j) {
    double h = moved[j] + problem.step > problem.upper[j] ? -problem.step : problem.step;
    moved[j] = parameters[j] + h;
    if (!problem.residuals(moved, there)) {
      h = -h;
      moved[j] = parameters[j] + h;
      if (!problem.residuals(moved, there)) return {};
    }
    for (std::size_t i = 0; i < problem.count; ++i) jacobian[i * k + j] = (there[i] - residuals[i]) / h;
    moved[j] = parameters[j];
  }
  return jacobian;
}

LeastSquaresMinimum minimise(const LeastSquares& problem, std::span<const double> start, const std::vector<bool>& held,
                             std::vector<double> jacobian, const DescentEnd& end) {
  return Descent(problem, start, held, std::move(jacobian), end).run();
}

std::vector<double> inverse_of(const std::vector<double>& matrix, std::size_t k) {
  constexpr double little = 1e-10; // of the largest diagonal element, far below what any data identify
  double largest = 0;
  for (std::size_t p = 0; p < k; ++p) largest = std::max(largest, matrix[p * k + p]);
  std::vector<double> rows(k * 2 * k, 0), inverse(k * k);
  for (std::size_t p = 0; p < k; ++p) {
    std::copy_n(&matrix[p * k], k, &rows[p * 2 * k]);
    rows[p * 2 * k + p] += little * largest + std::numeric_limits<double>::min();
    rows[p * 2 * k + k + p] = 1;
  }
  eliminate(rows, k, k);
  for (std::size_t p = 0; p < k; ++p) std::copy_n(&rows[p * 2 * k + k], k, &inverse[p * k]);
  return inverse;
}

std::vector<double> normal_matrix(const std::vector<double>& jacobian, std::span<const double> weights, std::size_t k) {
  std::vector<double> matrix(k * k, 0);
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (std::size_t p = 0; p < k; ++p)
      for (std::size_t q = 0; q < k; ++q) matrix[p * k + q] += weights[i] * jacobian[i * k + p] * jacobian[i * k + q];
  return matrix;
}

} // namespace microslip::fit
