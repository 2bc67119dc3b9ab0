#include "microslip/numerics/gmres.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace microslip {
namespace {

using Vector = std::vector<double>;

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}
void add_scaled(double factor, std::span<const double> a, std::span<double> to) {
#pragma omp simd
  for (std::size_t i = 0; i < a.size(); ++i) to[i] += factor * a[i];
}
void scale(double factor, std::span<double> a) {
  for (double& value : a) value *= factor;
}

/// The least squares problem of the Hessenberg matrix, kept triangular by Givens rotations.
class Triangle {
public:
  explicit Triangle(double right_side) : rhs_{right_side} {}

  /// Adds a column (its last entry is the new subdiagonal) and returns the new residual. A column that lies in the
  /// span of those before, but for `rounding`, is left out: the matrix is singular and it gains nothing.
  double add(Vector column, double rounding) {
    const std::size_t k = columns_.size();
    for (std::size_t i = 0; i < k; ++i) rotate(i, column);
    const double length = std::hypot(column[k], column[k + 1]);
    if (!(length > rounding)) return std::abs(rhs_[k]);
    cosine_.push_back(column[k] / length);
    sine_.push_back(column[k + 1] / length);
    rotate(k, column);
    rhs_.push_back(-sine_[k] * rhs_[k]);
    rhs_[k] *= cosine_[k];
    columns_.push_back(std::move(column));
    return std::abs(rhs_.back());
  }

  Vector solve() const {
    Vector y(columns_.size());
    for (std::size_t i = y.size(); i-- > 0;) {
      double value = rhs_[i];
      for (std::size_t j = i + 1; j < y.size(); ++j) value -= columns_[j][i] * y[j];
      y[i] = value / columns_[i][i];
    }
    return y;
  }

private:
  void rotate(std::size_t i, Vector& column) const {
    const double first = column[i], second = column[i + 1];
    column[i] = cosine_[i] * first + sine_[i] * second;
    column[i + 1] = -sine_[i] * first + cosine_[i] * second;
  }

  std::vector<Vector> columns_;
  Vector rhs_, cosine_, sine_;
};

} // namespace

Gmres::Result Gmres::solve(const Product& matrix, std::span<const double> b, std::span<double> x, double tolerance,
                           int most) {
  std::fill(x.begin(), x.end(), 0.0);
  const double size = std::sqrt(dot(b, b));
  if (!(size > 0)) return {0, size};
  const auto vector = [&](std::size_t k) -> Vector& {
    if (basis_.size() <= k) basis_.emplace_back();
    basis_[k].resize(b.size());
    return basis_[k];
  };
  std::copy(b.begin(), b.end(), vector(0).begin());
  scale(1 / size, basis_[0]);

  Triangle triangle(size);
  double residual = size, largest = 0; // largest: |A v| so far
  int k = 0;
  for (; k < most && residual > tolerance * size; ++k) {
    Vector& next = vector(k + 1);
    matrix(basis_[k], next);
    largest = std::max(largest, std::sqrt(dot(next, next)));
    const double rounding = 1e-14 * largest;
    Vector column(k + 2);
    for (int i = 0; i <= k; ++i) {
      column[i] = dot(basis_[i], next);
      add_scaled(-column[i], basis_[i], next);
    }
    const double length = std::sqrt(dot(next, next));
    const bool closed = !(length > rounding); // the space holds its own image: it has nothing more to give
    column[k + 1] = closed ? 0 : length;
    residual = triangle.add(std::move(column), rounding);
    if (closed) {
      ++k;
      break;
    }
    scale(1 / length, next);
  }
  const Vector y = triangle.solve();
  for (std::size_t i = 0; i < y.size(); ++i) add_scaled(y[i], basis_[i], x);
  return {k, residual};
}

} // namespace microslip
