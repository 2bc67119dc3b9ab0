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
  return {p, at_rank(sorted, p * (n - 1)), at_rank(sorted, n * p - reach - 0.5),
          at_rank(sorted, n * p + reach - 0.5)};
}

/// The mean of numerators over that of denominators, with its standard error to first order in their scatter.
class RatioOfMeans {
public:
  void add(double numerator, double denominator) {
    sum_ += numerator, below_ += denominator;
    square_ += numerator * numerator, mixed_ += numerator * denominator, below_square_ += denominator * denominator;
  }
  double value() const { return below_ > 0 ? sum_ / below_ : nan; }
  double error() const {
    const double r = value();
    return std::sqrt(std::max(0.0, square_ - 2 * r * mixed_ + r * r * below_square_)) / below_;
  }

private:
  double sum_ = 0, below_ = 0, square_ = 0, mixed_ = 0, below_square_ = 0;
};

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
  std::vector<SobolIndex> indices;
  for (std::size_t k = 0; k < parameters; ++k) {
    RatioOfMeans first, total;
    for (const auto& point : whole) {
      const double a = point[0] - mean, b = point[1] - mean, c = point[k + 2] - mean;
      const double variance = 0.5 * (a * a + b * b);
      first.add(b * (c - a), variance);
      total.add(0.5 * (a - c) * (a - c), variance);
    }
    indices.push_back({first.value(), first.error(), total.value(), total.error()});
  }
  return indices;
}

} // namespace microslip::campaign
