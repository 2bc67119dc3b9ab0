#include "campaign/sample.hpp"

#include "campaign/distribution.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::campaign {
namespace {

/// Coordinates of the points: for Sobol's indices a second one of each parameter behind the first ones.
std::vector<std::string> coordinates_of(SampleAim aim, std::vector<std::string> names) {
  const std::size_t parameters = names.size();
  for (std::size_t k = 0; aim == SampleAim::sobol_indices && k < parameters; ++k) names.push_back(names[k] + " in B");
  return names;
}

} // namespace

Sample::Sample(SampleAim aim, PointSet set, std::size_t points, std::uint64_t seed, std::vector<std::string> names,
               const std::vector<Correlation>& correlations)
    : aim_(aim), points_(points), parameters_(names.size()),
      at_(set, points, seed, coordinates_of(aim, std::move(names))) {
  if (!correlations.empty()) factorise(correlations);
}

void Sample::factorise(const std::vector<Correlation>& correlations) {
  const std::size_t n = parameters_;
  factor_.assign(n * n, 0);
  for (std::size_t k = 0; k < n; ++k) factor_[k * n + k] = 1;
  for (const auto& [first, second, value] : correlations)
    factor_[std::max(first, second) * n + std::min(first, second)] = value;
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column <= row; ++column) {
      double& value = factor_[row * n + column];
      for (std::size_t k = 0; k < column; ++k) value -= factor_[row * n + k] * factor_[column * n + k];
      if (column < row)
        value /= factor_[column * n + column];
      else if (!(value > 1e-12))
        throw Error("correlations: contradict each other, their matrix is not positive definite");
      else
        value = std::sqrt(value);
    }
}

double Sample::part(std::size_t index, std::size_t k) const {
  const std::size_t point = index / cases_of_point(), place = index % cases_of_point();
  const bool is_of_b = place == 1 || place == k + 2;
  if (factor_.empty()) return at_.at(point, is_of_b ? parameters_ + k : k);
  const double* const row = factor_.data() + k * parameters_;
  if (std::all_of(row, row + k, [](double value) { return value == 0; })) return at_.at(point, k);
  double score = 0;
  for (std::size_t j = 0; j <= k; ++j)
    if (row[j] != 0) score += row[j] * normal_quantile(std::clamp(at_.at(point, j), 0x1p-53, 1 - 0x1p-53));
  return std::min(normal_probability(score), 1 - 0x1p-53);
}

} // namespace microslip::campaign
