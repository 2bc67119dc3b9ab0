#include "microslip/table/uniform_spline.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/elimination.hpp"

#include <cmath>

namespace microslip {
namespace {

/// Conditions on coefficients, written row by row into a square matrix.
class Conditions {
public:
  explicit Conditions(int size) : size_(std::size_t(size)), matrix_(size_ * size_) {}

  /// A row with these weights from coefficient `first` on.
  void add(int first, std::initializer_list<double> weights) {
    double* to = &matrix_[row_ * size_ + std::size_t(first)];
    for (const double w : weights) *to++ = w;
    ++row_;
  }
  std::vector<double> matrix() && { return std::move(matrix_); }

private:
  std::size_t size_, row_ = 0;
  std::vector<double> matrix_;
};

/// The jump of the second derivative of a quadratic spline between two nodes, from the coefficient before them on.
constexpr std::initializer_list<double> jump = {-1, 3, -3, 1};
constexpr std::initializer_list<double> value = {1.0 / 8, 3.0 / 4, 1.0 / 8};

} // namespace

SplineFilter::SplineFilter(std::vector<double> conditions, int size, int values)
    : rows_(size), columns_(values), matrix_(std::size_t(size) * std::size_t(values)) {
  const auto order = static_cast<std::size_t>(size);
  for (int column = 0; column < values; ++column) {
    std::vector<double> matrix = conditions, side(order);
    side[std::size_t(column)] = 1;
    if (!eliminate(matrix, {side})) throw Error("a spline needs more nodes");
    for (std::size_t row = 0; row < order; ++row) matrix_[row * std::size_t(values) + std::size_t(column)] = side[row];
  }
}

SplineFilter SplineFilter::not_a_knot(int n) {
  Conditions conditions(n + 2); // coefficient k at place k + 1
  for (int i = 0; i < n; ++i) conditions.add(i, value);
  for (const int before : {0, n - 2}) conditions.add(before, jump);
  return {std::move(conditions).matrix(), n + 2, n};
}

SplineFilter SplineFilter::without_first(int n) {
  Conditions conditions(n + 3);
  for (int i = 1; i <= n; ++i) conditions.add(i, value);
  for (const int before : {0, 1, n - 1}) conditions.add(before, jump);
  return {std::move(conditions).matrix(), n + 3, n};
}

SplineFilter SplineFilter::clamped(int n, bool even) {
  Conditions conditions(n + 1); // coefficient k at place k
  if (even)
    conditions.add(0, {3.0 / 4, 1.0 / 4});
  else
    conditions.add(0, {1});
  for (int i = 1; i < n; ++i) conditions.add(i - 1, value);
  conditions.add(n - 2, {-0.5, 0, 0.5});
  return {std::move(conditions).matrix(), n + 1, n + 1};
}

SplineFilter SplineFilter::mirrored(int n, bool even, double outer) {
  Conditions conditions(n);
  if (even)
    conditions.add(0, {1 - 2 * outer, 2 * outer});
  else
    conditions.add(0, {1});
  for (int i = 1; i < n - 1; ++i) conditions.add(i - 1, {outer, 1 - 2 * outer, outer});
  if (even)
    conditions.add(n - 2, {2 * outer, 1 - 2 * outer});
  else
    conditions.add(n - 1, {1});
  return {std::move(conditions).matrix(), n, n};
}

void SplineFilter::apply(const double* values, std::size_t value_stride, double* coefficients,
                         std::size_t coefficient_stride) const {
  const double* weights = matrix_.data();
  for (int row = 0; row < rows_; ++row, coefficients += coefficient_stride) {
    double sum = 0;
    for (int k = 0; k < columns_; ++k) sum += *weights++ * values[std::size_t(k) * value_stride];
    *coefficients = sum;
  }
}

} // namespace microslip
