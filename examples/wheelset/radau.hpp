#pragma once

#include "small_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

/// One step of z' = f(z) by the two-stage Radau IIA method: implicit, of third order, and damping whatever is too fast
/// for the step (Hairer & Wanner, Solving Ordinary Differential Equations II, section IV.5). The stages are found by
/// Newton's method with f's own Jacobian.
template <std::size_t N> class Radau {
public:
  /// `scale`: sizes of the components, which the error of Newton's method is measured in.
  explicit Radau(const Vector<N>& scale) : scale_(scale) {}

  /// Advances z by `step`; `rates(z, rate, jacobian)` is f with its Jacobian. Throws std::runtime_error if Newton's
  /// method does not converge.
  template <class Rates> void advance(Vector<N>& z, double step, Rates&& rates) {
    constexpr int most_iterations = 50;
    for (Vector<N>& increment : increments_) increment = {};
    for (std::size_t i = 0; i < N; ++i) {
      increments_[0][i] = last_[i] * step / 3;
      increments_[1][i] = last_[i] * step;
    }
    for (int iteration = 1;; ++iteration) {
      ++iterations_;
      if (newton_step(z, step, rates) < tolerance) break;
      if (iteration == most_iterations) throw std::runtime_error("Newton's method does not converge");
    }
    for (std::size_t i = 0; i < N; ++i) {
      last_[i] = increments_[1][i] / step;
      z[i] += increments_[1][i];
    }
  }

  long iterations() const { return iterations_; }

private:
  static constexpr double tolerance = 1e-7;
  static constexpr double a_[2][2] = {{5.0 / 12, -1.0 / 12}, {3.0 / 4, 1.0 / 4}};

  /// Returns the largest change over its scale.
  template <class Rates> double newton_step(const Vector<N>& z, double step, Rates&& rates) {
    Vector<N> rate[2];
    Matrix<N> jacobian[2];
    for (int s = 0; s < 2; ++s) {
      Vector<N> at = z;
      for (std::size_t i = 0; i < N; ++i) at[i] += increments_[s][i];
      rates(at, rate[s], jacobian[s]);
    }
    Matrix<2 * N> matrix = {};
    Vector<2 * N> change = {};
    for (int s = 0; s < 2; ++s)
      for (std::size_t i = 0; i < N; ++i) {
        const std::size_t row = s * N + i;
        matrix[row][row] = 1;
        change[row] = -increments_[s][i];
        for (int t = 0; t < 2; ++t) {
          change[row] += step * a_[s][t] * rate[t][i];
          for (std::size_t j = 0; j < N; ++j) matrix[row][t * N + j] -= step * a_[s][t] * jacobian[t][i][j];
        }
      }
    solve_linear(matrix, change);
    double largest = 0;
    for (int s = 0; s < 2; ++s)
      for (std::size_t i = 0; i < N; ++i) {
        increments_[s][i] += change[s * N + i];
        largest = std::max(largest, std::abs(change[s * N + i]) / scale_[i]);
      }
    return largest;
  }

  Vector<N> scale_, last_ = {};
  std::array<Vector<N>, 2> increments_;
  long iterations_ = 0;
};
