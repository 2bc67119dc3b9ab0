#include "microslip/table/uniform_spline.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace microslip {
namespace {

/// The jump of the second derivative of a quadratic spline between two nodes, from the coefficient before them on.
constexpr std::initializer_list<double> jump = {-1, 3, -3, 1};
constexpr std::initializer_list<double> value = {1.0 / 8, 3.0 / 4, 1.0 / 8};

} // namespace

/// Conditions on coefficients, written row by row into a band about the diagonal.
class SplineFilter::Conditions {
public:
  static constexpr int width = 2 * reach + 1;

  /// A row with these weights from coefficient `first` on.
  void add(int first, std::initializer_list<double> weights) {
    std::array<double, width> row = {};
    int index = first - static_cast<int>(rows_.size()) + reach;
    for (const double w : weights) row[static_cast<std::size_t>(index++)] = w;
    rows_.push_back(row);
  }
  const std::vector<std::array<double, width>>& rows() const { return rows_; }

private:
  std::vector<std::array<double, width>> rows_;
};

/// Conditions are such that no pivot vanishes where there are as many nodes as check(CreepTableAxes) asks for.
SplineFilter::SplineFilter(const Conditions& conditions, std::size_t first_value, std::size_t values)
    : first_value_(first_value), values_(values) {
  auto band = conditions.rows();
  const int n = static_cast<int>(band.size());
  const auto at = [&](int i, int j) -> double& { return band[std::size_t(i)][j - i + reach]; };
  for (int i = 0; i < n; ++i) {
    Row row;
    for (int j = std::max(0, i - reach); j < i; ++j) {
      const double factor = at(i, j) * rows_[std::size_t(j)].per_pivot;
      row.lower[std::size_t(i - j - 1)] = factor;
      for (int k = j + 1; k <= std::min(n - 1, j + reach); ++k) at(i, k) -= factor * at(j, k);
    }
    for (int k = i + 1; k <= std::min(n - 1, i + reach); ++k) row.upper[std::size_t(k - i - 1)] = at(i, k);
    if (!(std::abs(at(i, i)) > 1e-6)) throw Error("a spline needs more nodes");
    row.per_pivot = 1 / at(i, i);
    rows_.push_back(row);
  }
}

SplineFilter SplineFilter::not_a_knot(int n) {
  Conditions conditions; // coefficient k in equation k + 1
  conditions.add(0, jump);
  for (int i = 0; i < n; ++i) conditions.add(i, value);
  conditions.add(n - 2, jump);
  return {conditions, 1, std::size_t(n)};
}

SplineFilter SplineFilter::without_first(int n) {
  Conditions conditions;
  for (const int before : {0, 1}) conditions.add(before, jump);
  for (int i = 1; i <= n; ++i) conditions.add(i, value);
  conditions.add(n - 1, jump);
  return {conditions, 2, std::size_t(n)};
}

SplineFilter SplineFilter::clamped(int n, bool even) {
  Conditions conditions; // coefficient k in equation k
  if (even)
    conditions.add(0, {3.0 / 4, 1.0 / 4});
  else
    conditions.add(0, {1});
  for (int i = 1; i < n; ++i) conditions.add(i - 1, value);
  conditions.add(n - 2, {-0.5, 0, 0.5});
  return {conditions, 0, std::size_t(n) + 1};
}

SplineFilter SplineFilter::mirrored(int n, bool even, double outer) {
  Conditions conditions;
  if (even)
    conditions.add(0, {1 - 2 * outer, 2 * outer});
  else
    conditions.add(0, {1});
  for (int i = 1; i < n - 1; ++i) conditions.add(i - 1, {outer, 1 - 2 * outer, outer});
  if (even)
    conditions.add(n - 2, {2 * outer, 1 - 2 * outer});
  else
    conditions.add(n - 1, {1});
  return {conditions, 0, std::size_t(n)};
}

void SplineFilter::apply(double* rows, std::size_t stride, const SplineColumns& columns) const {
  // Calls `work` with the index where each group of a row begins.
  const auto for_groups = [&](std::size_t row, const auto& work) {
    for (std::size_t g = 0; g < columns.groups; ++g) work(rows + row * stride + g * columns.distance);
  };
  const auto subtract = [&](std::size_t row, std::ptrdiff_t to_other, double factor) {
    if (factor == 0) return;
    for_groups(row, [&](double* to) {
      const double* const from = to + to_other * static_cast<std::ptrdiff_t>(stride);
      for (std::size_t k = 0; k < columns.width; ++k) to[k] -= factor * from[k];
    });
  };
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const bool has_value = i >= first_value_ && i < first_value_ + values_;
    if (!has_value) for_groups(i, [&](double* to) { std::fill_n(to, columns.width, 0.0); });
    for (std::size_t d = 1; d <= reach && d <= i; ++d)
      subtract(i, -static_cast<std::ptrdiff_t>(d), rows_[i].lower[d - 1]);
  }
  for (std::size_t i = rows_.size(); i-- > 0;) {
    const Row& row = rows_[i];
    for (std::size_t d = 1; d <= reach && i + d < rows_.size(); ++d)
      subtract(i, static_cast<std::ptrdiff_t>(d), row.upper[d - 1]);
    for_groups(i, [&](double* to) {
      for (std::size_t k = 0; k < columns.width; ++k) to[k] *= row.per_pivot;
    });
  }
}

} // namespace microslip
