#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <stdexcept>
#include <utility>

/// Dense linear algebra for a handful of unknowns.
template <std::size_t N> using Vector = std::array<double, N>;
template <std::size_t N> using Matrix = std::array<Vector<N>, N>;

/// Solves a x = b in place, by elimination with row exchange; throws std::runtime_error for a singular matrix.
template <std::size_t N> void solve_linear(Matrix<N>& a, Vector<N>& b) {
  for (std::size_t k = 0; k < N; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < N; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    if (!(std::abs(a[pivot][k]) > 0)) throw std::runtime_error("singular matrix");
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < N; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < N; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = N; k-- > 0;) {
    for (std::size_t j = k + 1; j < N; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
}

/// Coefficients c of det(s - a) = s^N + c[N-1] s^(N-1) + ... + c[0] (Faddeev & Leverrier).
template <std::size_t N> Vector<N> characteristic_polynomial(const Matrix<N>& a) {
  Vector<N> c = {};
  Matrix<N> m = {}; // M_k = a M_(k-1) + c[N-k+1]
  double last = 1;
  for (std::size_t k = 1; k <= N; ++k) {
    Matrix<N> next = {};
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j < N; ++j) {
        for (std::size_t l = 0; l < N; ++l) next[i][j] += a[i][l] * m[l][j];
        if (i == j) next[i][j] += last;
      }
    m = next;
    double trace = 0;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t l = 0; l < N; ++l) trace += a[i][l] * m[l][i];
    c[N - k] = last = -trace / static_cast<double>(k);
  }
  return c;
}

/// Eigenvalues: the roots of the characteristic polynomial, all at once (Weierstrass' iteration).
template <std::size_t N> std::array<std::complex<double>, N> eigenvalues(const Matrix<N>& a) {
  using Complex = std::complex<double>;
  const Vector<N> c = characteristic_polynomial(a);
  double radius = 1; // Fujiwara's bound of all roots
  for (std::size_t k = 0; k < N; ++k)
    radius = std::max(radius, 2 * std::pow(std::abs(c[k]), 1.0 / static_cast<double>(N - k)));
  std::array<Complex, N> roots;
  for (std::size_t k = 0; k < N; ++k) roots[k] = radius * std::pow(Complex(0.4, 0.9), static_cast<double>(k));
  for (double change = 1; change > 1e-14;) {
    change = 0;
    for (std::size_t k = 0; k < N; ++k) {
      Complex value = 1, others = 1;
      for (std::size_t i = N; i-- > 0;) value = value * roots[k] + c[i];
      for (std::size_t i = 0; i < N; ++i)
        if (i != k) others *= roots[k] - roots[i];
      const Complex step = value / others;
      roots[k] -= step;
      change = std::max(change, std::abs(step) / (std::abs(roots[k]) + 1e-300));
    }
  }
  return roots;
}
