#include "microslip/numerics/gmres.hpp"

#include "microslip/numerics/lanes.hpp"
#include "microslip/numerics/precision.hpp"
#include "microslip/numerics/threads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

namespace microslip {
namespace {

using Weights = std::vector<double>;
template <class Real> using Basis = std::vector<std::vector<Real>>;

/// Scalar product in many partial sums, so that none has to wait for the one before it.
template <class Stored, class Real> Real dot(std::span<const Stored> a, std::span<const Real> b) {
  using Vector = WideLanes<Real, 16>;
  Vector sums = 0;
  std::size_t i = 0;
  for (; i + Vector::width <= a.size(); i += Vector::width) sums += Vector::load(&a[i]) * Vector::load(&b[i]);
  Real whole = sum(sums);
  for (; i < a.size(); ++i) whole += Real(a[i]) * b[i];
  return whole;
}
template <class Stored, class Real> void add_scaled(Real factor, std::span<const Stored> a, std::span<Real> to) {
#pragma omp simd
  for (std::size_t i = 0; i < a.size(); ++i) to[i] += factor * Real(a[i]);
}
template <class Real> void scale(double factor, std::span<Real> a) {
  for (Real& value : a) value *= static_cast<Real>(factor);
}

constexpr std::size_t block = 2048;                // numbers of a vector that stay in the cache
constexpr std::size_t smallest_threaded = 1 << 15; // numbers in a vector that are worth several threads

/// A vector in blocks, and the threads that share them.
struct Blocks {
  explicit Blocks(std::size_t vector_size)
      : size(vector_size), count(static_cast<int>((size + block - 1) / block)),
        threads(threads_for(size, smallest_threaded)) {}

  template <class Real> std::span<Real> part(int b, std::span<Real> v) const {
    const std::size_t begin = b * block;
    return v.subspan(begin, std::min(block, size - begin));
  }
  template <class Real> std::span<const Real> part(int b, const std::vector<Real>& v) const {
    return part(b, std::span<const Real>(v));
  }

  std::size_t size;
  int count, threads;
};

template <class Real> double norm(const std::vector<Real>& v) {
  const Blocks blocks(v.size());
  double sum = 0;
  for (int b = 0; b < blocks.count; ++b) sum += dot<Real, Real>(blocks.part(b, v), blocks.part(b, v));
  return std::sqrt(sum);
}

/// Takes the components along the first `count` basis vectors off `v` and adds them to `components`: Gram and Schmidt's
/// classical method, block by block, so that each basis vector is read twice only. The sums are formed in an order that
/// does not depend on the number of threads.
template <class Stored, class Real>
void orthogonalise(const Basis<Stored>& basis, std::size_t count, std::vector<Real>& v, std::span<double> components) {
  const Blocks blocks(v.size());
  Weights sums(blocks.count * count), total(count);
  distribute(blocks.count, blocks.threads, [&](int b, int) {
    for (std::size_t i = 0; i < count; ++i)
      sums[b * count + i] = dot<Stored, Real>(blocks.part(b, basis[i]), blocks.part(b, v));
  });
  for (std::size_t i = 0; i < count; ++i)
    for (int b = 0; b < blocks.count; ++b) total[i] += sums[b * count + i];
  distribute(blocks.count, blocks.threads, [&](int b, int) {
    for (std::size_t i = 0; i < count; ++i)
      add_scaled<Stored, Real>(static_cast<Real>(-total[i]), blocks.part(b, basis[i]), blocks.part(b, std::span(v)));
  });
  for (std::size_t i = 0; i < count; ++i) components[i] += total[i];
}

/// The least squares problem of the Hessenberg matrix, kept triangular by Givens rotations.
class Triangle {
public:
  explicit Triangle(double right_side) : rhs_{right_side} {}

  /// Adds a column (its last entry is the new subdiagonal) and returns the new residual. A column that lies in the
  /// span of those before, up to `rounding`, is left out: the matrix is singular and it gains nothing.
  double add(Weights column, double rounding) {
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

  Weights solve() const {
    Weights y(columns_.size());
    for (std::size_t i = y.size(); i-- > 0;) {
      double value = rhs_[i];
      for (std::size_t j = i + 1; j < y.size(); ++j) value -= columns_[j][i] * y[j];
      y[i] = value / columns_[i][i];
    }
    return y;
  }

private:
  void rotate(std::size_t i, Weights& column) const {
    const double first = column[i], second = column[i + 1];
    column[i] = cosine_[i] * first + sine_[i] * second;
    column[i + 1] = -sine_[i] * first + cosine_[i] * second;
  }

  std::vector<Weights> columns_;
  Weights rhs_, cosine_, sine_;
};

} // namespace

template <class Real>
typename Gmres<Real>::Result Gmres<Real>::solve(const Product& matrix, std::span<const Real> b, std::span<Real> x,
                                                double tolerance, int most, Precision basis) {
  return b.size() < many_unknowns && basis == Precision::full ? solve_in(basis_, matrix, b, x, tolerance, most)
                                                              : solve_in(narrow_, matrix, b, x, tolerance, most);
}

template <class Real>
template <class Stored>
typename Gmres<Real>::Result Gmres<Real>::solve_in(Basis<Stored>& basis, const Product& matrix, std::span<const Real> b,
                                                   std::span<Real> x, double tolerance, int most) {
  constexpr bool narrow = !std::is_same_v<Stored, Real>;
  const auto room = [&b](auto& vector) -> auto& {
    vector.resize(b.size());
    return vector;
  };
  const auto stored = [&](std::size_t k) -> std::vector<Stored>& {
    if (basis.size() <= k) basis.emplace_back();
    return room(basis[k]);
  };
  // Where a vector of the basis is made, and where one is for a product.
  const auto made = [&](std::size_t k) -> std::vector<Real>& {
    if constexpr (narrow)
      return room(next_);
    else
      return stored(k);
  };
  const auto keep = [&]([[maybe_unused]] std::size_t k) {
    if constexpr (narrow) convert(next_, 1, stored(k));
  };
  const auto known = [&](std::size_t k) -> const std::vector<Real>& {
    if constexpr (narrow) {
      convert(basis[k], 1, room(in_));
      return in_;
    } else {
      return basis[k];
    }
  };
  std::vector<Real>& first = made(0);
  std::copy(b.begin(), b.end(), first.begin());
  const double size = norm(first);
  if (!(size > 0)) {
    std::fill(x.begin(), x.end(), Real(0));
    return {0, size, {}};
  }
  scale(1 / size, std::span(first));
  keep(0);

  Triangle triangle(size);
  double residual = size, largest = 0; // largest: |A v| so far
  int k = 0;
  for (; k < most && residual > tolerance * size; ++k) {
    std::vector<Real>& next = made(k + 1);
    matrix(known(k), next);
    Weights column(k + 2);
    orthogonalise(basis, k + 1, next, column);
    double length = norm(next);
    const double image = std::sqrt(std::inner_product(column.begin(), column.end(), column.begin(), length * length));
    if (length < 0.1 * image) { // once more where little is left: it has the rounding errors of what was taken off
      orthogonalise(basis, k + 1, next, column);
      length = norm(next);
    }
    largest = std::max(largest, image);
    const double rounding = 50 * std::numeric_limits<Stored>::epsilon() * largest;
    const bool closed = !(length > rounding); // the space contains its image: it has nothing more to give
    column[k + 1] = closed ? 0 : length;
    residual = triangle.add(std::move(column), rounding);
    if (closed) {
      ++k;
      break;
    }
    scale(1 / length, std::span(next));
    keep(k + 1);
  }
  Weights weights = triangle.solve();
  combine(weights, basis, x);
  return {k, residual, std::move(weights)};
}

template <class Stored, class Real>
void combine(std::span<const double> weights, const Basis<Stored>& vectors, std::span<Real> sum) {
  const Blocks blocks(sum.size());
  distribute(blocks.count, blocks.threads, [&](int b, int) {
    const std::span<Real> part = blocks.part(b, sum);
    std::fill(part.begin(), part.end(), Real(0));
    for (std::size_t k = 0; k < weights.size(); ++k)
      add_scaled<Stored, Real>(static_cast<Real>(weights[k]), blocks.part(b, vectors[k]), part);
  });
}

template class Gmres<double>;
template class Gmres<float>;
template void combine(std::span<const double>, const Basis<double>&, std::span<double>);
template void combine(std::span<const double>, const Basis<float>&, std::span<float>);
template void combine(std::span<const double>, const Basis<float>&, std::span<double>);

} // namespace microslip
