#include "microslip/numerics/gmres.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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

constexpr std::size_t block = 2048;                // numbers of a vector that stay in the cache
constexpr std::size_t smallest_threaded = 1 << 15; // numbers in a vector that are worth several threads

/// Takes the components along the first `count` basis vectors off `v` and adds them to `components`: Gram and Schmidt's
/// classical method, block by block, so that each basis vector is read twice only. The sums are formed in an order that
/// does not depend on the number of threads.
void orthogonalise(const std::vector<Vector>& basis, std::size_t count, std::span<double> v,
                   std::span<double> components) {
  const std::size_t blocks = (v.size() + block - 1) / block;
  Vector sums(blocks * count), total(count);
  const auto part = [&](std::size_t b, std::span<const double> vector) {
    return vector.subspan(b * block, std::min(block, vector.size() - b * block));
  };
#pragma omp parallel if (v.size() >= smallest_threaded)
  {
#pragma omp for
    for (std::size_t b = 0; b < blocks; ++b)
      for (std::size_t i = 0; i < count; ++i) sums[b * count + i] = dot(part(b, basis[i]), part(b, v));
#pragma omp single
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t b = 0; b < blocks; ++b) total[i] += sums[b * count + i];
#pragma omp for
    for (std::size_t b = 0; b < blocks; ++b)
      for (std::size_t i = 0; i < count; ++i)
        add_scaled(-total[i], part(b, basis[i]), v.subspan(b * block, std::min(block, v.size() - b * block)));
  }
  for (std::size_t i = 0; i < count; ++i) components[i] += total[i];
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
  const double size = std::sqrt(dot(b, b));
  if (!(size > 0)) {
    std::fill(x.begin(), x.end(), 0.0);
    return {0, size, {}};
  }
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
    double before = std::sqrt(dot(next, next)), length = before;
    largest = std::max(largest, before);
    const double rounding = 1e-14 * largest;
    Vector column(k + 2);
    // Once more where little is left: it has the rounding errors of what was taken off.
    for (int pass = 0; pass < 2 && (pass == 0 || length < 0.1 * before); ++pass) {
      before = length;
      orthogonalise(basis_, k + 1, next, column);
      length = std::sqrt(dot(next, next));
    }
    const bool closed = !(length > rounding); // the space holds its own image: it has nothing more to give
    column[k + 1] = closed ? 0 : length;
    residual = triangle.add(std::move(column), rounding);
    if (closed) {
      ++k;
      break;
    }
    scale(1 / length, next);
  }
  Vector weights = triangle.solve();
  combine(weights, basis_, x);
  return {k, residual, std::move(weights)};
}

void combine(std::span<const double> weights, const std::vector<Vector>& vectors, std::span<double> sum) {
#pragma omp parallel for if (sum.size() >= smallest_threaded)
  for (std::size_t begin = 0; begin < sum.size(); begin += block) {
    const std::size_t count = std::min(block, sum.size() - begin);
    const std::span<double> part = sum.subspan(begin, count);
    std::fill(part.begin(), part.end(), 0.0);
    for (std::size_t k = 0; k < weights.size(); ++k)
      add_scaled(weights[k], std::span(vectors[k]).subspan(begin, count), part);
  }
}

} // namespace microslip
