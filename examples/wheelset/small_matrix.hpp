#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <stdexcept>
#include <utility>

/// Dense linear algebra for a handful of unknowns.
template <std::size_t N> using Vector = std::array<double, N>;
template <std::size_t N> using Matrix = std::array<Vector<N>, N>;

/// A matrix factored by elimination with row exchange, to be solved with often.
template <std::size_t N> class Factors {
public:
  Factors() = default;
  /// Throws std::runtime_error for a singular matrix.
  explicit Factors(const Matrix<N>& matrix) : a_(matrix) {
    for (std::size_t k = 0; k < N; ++k) {
      std::size_t& pivot = pivot_[k];
      pivot = k;
      for (std::size_t i = k + 1; i < N; ++i)
        if (std::abs(a_[i][k]) > std::abs(a_[pivot][k])) pivot = i;
      if (!(std::abs(a_[pivot][k]) > 0)) throw std::runtime_error("singular matrix");
      std::swap(a_[k], a_[pivot]);
      for (std::size_t i = k + 1; i < N; ++i) {
        const double factor = a_[i][k] /= a_[k][k];
        for (std::size_t j = k + 1; j < N; ++j) a_[i][j] -= factor * a_[k][j];
      }
    }
  }

  /// Turns b into the solution x of a x = b.
  void solve(Vector<N>& b) const {
    for (std::size_t k = 0; k < N; ++k) std::swap(b[k], b[pivot_[k]]);
    for (std::size_t k = 0; k < N; ++k)
      for (std::size_t j = 0; j < k; ++j) b[k] -= a_[k][j] * b[j];
    for (std::size_t k = N; k-- > 0;) {
      for (std::size_t j = k + 1; j < N; ++j) b[k] -= a_[k][j] * b[j];
      b[k] /= a_[k][k];
    }
  }

private:
  Matrix<N> a_ = {};
  std::array<std::size_t, N> pivot_ = {};
};

/// Eigenvalues, by Francis' QR method with shifts (Golub & Van Loan, Matrix Computations, sections 7.4, 7.5). Throws
/// std::runtime_error if it does not converge.
template <std::size_t N> std::array<std::complex<double>, N> eigenvalues(const Matrix<N>& matrix) {
  using Complex = std::complex<double>;
  std::array<std::array<Complex, N>, N> h;
  for (std::size_t i = 0; i < N; ++i) std::copy(matrix[i].begin(), matrix[i].end(), h[i].begin());
  // Hessenberg form: rows eliminated from below, columns changed so that the matrix stays similar.
  for (std::size_t k = 1; k + 1 < N; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < N; ++i)
      if (std::abs(h[i][k - 1]) > std::abs(h[pivot][k - 1])) pivot = i;
    if (h[pivot][k - 1] == 0.0) continue;
    std::swap(h[k], h[pivot]);
    for (auto& row : h) std::swap(row[k], row[pivot]);
    for (std::size_t i = k + 1; i < N; ++i) {
      const Complex factor = h[i][k - 1] / h[k][k - 1];
      for (std::size_t j = 0; j < N; ++j) h[i][j] -= factor * h[k][j];
      for (auto& row : h) row[k] += factor * row[i];
    }
  }
  std::array<Complex, N> values;
  std::size_t n = N; // rows without an eigenvalue yet
  for (int iteration = 0; n > 0; ++iteration) {
    if (iteration > 100 * static_cast<int>(N)) throw std::runtime_error("eigenvalues do not converge");
    const Complex last = h[n - 1][n - 1];
    if (n == 1 || std::abs(h[n - 1][n - 2]) <= 1e-16 * (std::abs(last) + std::abs(h[n - 2][n - 2]))) {
      values[--n] = last;
      continue;
    }
    // The eigenvalue of the last two rows that is nearer to the last entry; now and then another shift, against cycles.
    const Complex half = (h[n - 2][n - 2] - last) / 2.0, product = h[n - 2][n - 1] * h[n - 1][n - 2];
    const Complex root = std::sqrt(half * half + product),
                  sum = std::abs(half + root) > std::abs(half - root) ? half + root : half - root;
    const Complex shift =
        iteration % 20 == 19 ? last + std::abs(h[n - 1][n - 2]) : last - (sum == 0.0 ? 0.0 : product / sum);
    std::array<Complex, N> cosine, sine;
    for (std::size_t i = 0; i < n; ++i) h[i][i] -= shift;
    for (std::size_t k = 0; k + 1 < n; ++k) {
      const double norm = std::hypot(std::abs(h[k][k]), std::abs(h[k + 1][k]));
      cosine[k] = norm > 0 ? h[k][k] / norm : 1.0, sine[k] = norm > 0 ? h[k + 1][k] / norm : 0.0;
      for (std::size_t j = k; j < n; ++j) {
        const Complex above = h[k][j], below = h[k + 1][j];
        h[k][j] = std::conj(cosine[k]) * above + std::conj(sine[k]) * below;
        h[k + 1][j] = cosine[k] * below - sine[k] * above;
      }
    }
    for (std::size_t k = 0; k + 1 < n; ++k)
      for (std::size_t i = 0; i < std::min(k + 2, n); ++i) {
        const Complex left = h[i][k], right = h[i][k + 1];
        h[i][k] = left * cosine[k] + right * sine[k];
        h[i][k + 1] = right * std::conj(cosine[k]) - left * std::conj(sine[k]);
      }
    for (std::size_t i = 0; i < n; ++i) h[i][i] += shift;
  }
  return values;
}
