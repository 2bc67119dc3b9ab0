#pragma once

#include "small_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

/// Steps of z' = f(z) by the two-stage Radau IIA method: implicit, of third order, and damping whatever is too fast for
/// the step (Hairer & Wanner, Solving Ordinary Differential Equations II, section IV.5). The stages are found by
/// Newton's method with a Jacobian of f that is kept as long as it serves (section IV.8).
template <std::size_t N> class Radau {
public:
  /// `scale`: sizes of the components, by which the error of Newton's method is measured; below `tolerance` of them.
  explicit Radau(const Vector<N>& scale, double tolerance = 1e-7) : scale_(scale), tolerance_(tolerance) {}

  /// Advances z by `step`; `rates(z, rate)` is f, `rates(z, rate, jacobian)` f with its Jacobian. Where Newton's method
  /// does not converge, as across a jump of f, the step is halved, at most 5 times. If f jumps so that the motion can
  /// neither stay before the jump nor leave it behind, there are no stages: Newton's method is then damped until it
  /// stops on the jump. Throws std::runtime_error for rates that are not finite and jumps of more than `scale`.
  template <class Rates> void advance(Vector<N>& z, double step, Rates&& rates) {
    constexpr int most_halvings = 5;
    advance(z, step, rates, most_halvings);
  }

  long iterations() const { return iterations_; }
  long jacobians() const { return jacobians_; }
  long halvings() const { return halvings_; }
  /// Steps, shortened ones, that ended on a jump.
  long jumps() const { return jumps_; }

private:
  static constexpr double a_[2][2] = {{5.0 / 12, -1.0 / 12}, {3.0 / 4, 1.0 / 4}};

  template <class Rates> void advance(Vector<N>& z, double step, Rates&& rates, int halvings) {
    if (find_stages(z, step, rates, halvings == 0)) {
      for (std::size_t i = 0; i < N; ++i) {
        last_[i] = increments_[1][i] / step;
        z[i] += increments_[1][i];
      }
      return;
    }
    if (halvings == 0) throw std::runtime_error("Newton's method does not converge");
    ++halvings_;
    advance(z, step / 2, rates, halvings - 1);
    advance(z, step / 2, rates, halvings - 1);
  }

  template <class Rates> bool find_stages(const Vector<N>& z, double step, Rates&& rates, bool is_shortest) {
    constexpr int most_iterations = 25, undamped = 8;
    constexpr double damping = 0.6;
    constexpr double good = 0.2; // reduction of the change by one iteration
    for (std::size_t i = 0; i < N; ++i) {
      increments_[0][i] = last_[i] * step / 3;
      increments_[1][i] = last_[i] * step;
    }
    if (step != factored_step_) stale_ = true;
    double before = 0;
    for (int iteration = 1; iteration <= most_iterations; ++iteration) {
      ++iterations_;
      if (stale_) factor(z, step, rates);
      const double part = is_shortest ? std::pow(damping, std::max(0, iteration - undamped)) : 1;
      const double change = newton_step(z, step, rates, part);
      if (!std::isfinite(change)) break;
      // What is still missing is the last change times q/(1 - q), were all reductions q.
      const double reduction = iteration > 1 ? change / before : 0;
      if (change < tolerance_ || (reduction > 0 && reduction < 1 && change * reduction / (1 - reduction) < tolerance_))
        return true;
      stale_ = reduction > good && part == 1;
      before = change;
    }
    stale_ = true;
    if (!is_shortest || !(before < 1)) return false;
    ++jumps_;
    return true;
  }

  /// I - h A x J, with the Jacobian J in the last stage.
  template <class Rates> void factor(const Vector<N>& z, double step, Rates&& rates) {
    Vector<N> at = z, rate;
    for (std::size_t i = 0; i < N; ++i) at[i] += increments_[1][i];
    Matrix<N> jacobian;
    rates(at, rate, jacobian);
    Matrix<2 * N> matrix = {};
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t i = 0; i < N; ++i) {
        matrix[s * N + i][s * N + i] = 1;
        for (std::size_t t = 0; t < 2; ++t)
          for (std::size_t j = 0; j < N; ++j) matrix[s * N + i][t * N + j] -= step * a_[s][t] * jacobian[i][j];
      }
    factors_ = Factors<2 * N>(matrix);
    factored_step_ = step, stale_ = false;
    ++jacobians_;
  }

  /// Takes a part of Newton's step. Returns the largest change over its scale, were it the whole.
  template <class Rates> double newton_step(const Vector<N>& z, double step, Rates&& rates, double part) {
    Vector<N> rate[2];
    for (std::size_t s = 0; s < 2; ++s) {
      Vector<N> at = z;
      for (std::size_t i = 0; i < N; ++i) at[i] += increments_[s][i];
      rates(at, rate[s]);
    }
    Vector<2 * N> change;
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t i = 0; i < N; ++i)
        change[s * N + i] = step * (a_[s][0] * rate[0][i] + a_[s][1] * rate[1][i]) - increments_[s][i];
    factors_.solve(change);
    double largest = 0;
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t i = 0; i < N; ++i) {
        increments_[s][i] += part * change[s * N + i];
        largest = std::max(largest, std::abs(change[s * N + i]) / scale_[i]);
      }
    return largest;
  }

  Vector<N> scale_, last_ = {};
  double tolerance_;
  std::array<Vector<N>, 2> increments_;
  Factors<2 * N> factors_;
  double factored_step_ = 0;
  bool stale_ = true;
  long iterations_ = 0, jacobians_ = 0, halvings_ = 0, jumps_ = 0;
};
