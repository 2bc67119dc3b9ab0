#include "campaign/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace microslip::campaign {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double within_95_percent = 1.959963984540054; ///< standard deviations of a normal distribution

/// Between ascending values, at a rank from 0 on.
double at_rank(std::span<const double> sorted, double rank) {
  const double inside = std::clamp(rank, 0.0, static_cast<double>(sorted.size() - 1));
  const auto below = static_cast<std::size_t>(inside);
  const double part = inside - static_cast<double>(below);
  return part == 0 ? sorted[below] : (1 - part) * sorted[below] + part * sorted[below + 1];
}

Quantile quantile_of(std::span<const double> sorted, double p) {
  if (sorted.empty()) return {p, nan, nan, nan};
  const auto n = static_cast<double>(sorted.size());
  const double reach = within_95_percent * std::sqrt(n * p * (1 - p));
  return {p, at_rank(sorted, p * (n - 1)), at_rank(sorted, n * p - reach - 0.5), at_rank(sorted, n * p + reach - 0.5)};
}

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double product(std::span<const double> one, std::span<const double> other) {
  return std::inner_product(one.begin(), one.end(), other.begin(), 0.0);
}

/// A share of the variance, with its standard error.
struct Share {
  double value, error;
};

/// The mean of parts over that of variances; by their scatter about the share to first order.
Share share_of(std::vector<double> parts, std::span<const double> variances) {
  const double variance = mean_of(variances), value = variance > 0 ? mean_of(parts) / variance : nan;
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i] -= value * variances[i];
  return {value, std::sqrt(product(parts, parts)) / (variance * static_cast<double>(parts.size()))};
}

/// The mean of two estimates' parts that has the least scatter.
std::vector<double> joined(const std::vector<double>& one, const std::vector<double>& other,
                           std::span<const double> variances) {
  const double variance = mean_of(variances), of_one = mean_of(one) / variance, of_other = mean_of(other) / variance;
  std::vector<double> r = one, difference = one;
  for (std::size_t i = 0; i < one.size(); ++i) {
    r[i] -= of_one * variances[i];
    difference[i] = r[i] - (other[i] - of_other * variances[i]);
  }
  const double scatter = product(difference, difference);
  const double weight = scatter > 0 ? std::clamp(product(r, difference) / scatter, 0.0, 1.0) : 0.0;
  std::vector<double> parts = one;
  for (std::size_t i = 0; i < one.size(); ++i) parts[i] += weight * (other[i] - one[i]);
  return parts;
}

} // namespace

Spread spread_of(std::span<const double> values, std::span<const double> probabilities) {
  std::vector<double> sorted;
  std::copy_if(values.begin(), values.end(), std::back_inserter(sorted), [](double v) { return !std::isnan(v); });
  std::sort(sorted.begin(), sorted.end());
  Spread spread;
  spread.count = sorted.size();
  spread.mean = spread.mean_error = spread.standard_deviation = spread.least = spread.largest = nan;
  for (const double p : probabilities) spread.quantiles.push_back(quantile_of(sorted, p));
  if (sorted.empty()) return spread;
  const auto n = static_cast<double>(sorted.size());
  spread.least = sorted.front(), spread.largest = sorted.back();
  spread.mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / n;
  double squares = 0;
  for (const double value : sorted) squares += (value - spread.mean) * (value - spread.mean);
  spread.standard_deviation = n > 1 ? std::sqrt(squares / (n - 1)) : 0;
  spread.mean_error = spread.standard_deviation / std::sqrt(n);
  return spread;
}

std::vector<SobolIndex> sobol_indices(std::span<const double> values, std::size_t parameters) {
  const std::size_t cases = parameters + 2, points = values.size() / cases;
  std::vector<std::span<const double>> whole;
  double sum = 0;
  for (std::size_t i = 0; i < points; ++i) {
    const auto point = values.subspan(i * cases, cases);
    if (std::any_of(point.begin(), point.end(), [](double v) { return std::isnan(v); })) continue;
    whole.push_back(point);
    sum += point[0] + point[1];
  }
  const double mean = sum / static_cast<double>(2 * whole.size());
  std::vector<double> variances;
  variances.reserve(whole.size());
  for (const auto& point : whole)
    variances.push_back(0.5 * (std::pow(point[0] - mean, 2) + std::pow(point[1] - mean, 2)));
  std::vector<SobolIndex> indices;
  for (std::size_t k = 0; k < parameters; ++k) {
    std::vector<double> of_small, of_large, total;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      const double a = whole[i][0] - mean, b = whole[i][1] - mean, c = whole[i][k + 2] - mean;
      of_small.push_back(b * (c - a));
      of_large.push_back(variances[i] - 0.5 * (b - c) * (b - c));
      total.push_back(0.5 * (a - c) * (a - c));
    }
    const Share first = share_of(joined(of_small, of_large, variances), variances),
                in_all = share_of(std::move(total), variances);
    indices.push_back({first.value, first.error, in_all.value, in_all.error});
  }
  return indices;
}

} // namespace microslip::campaign
