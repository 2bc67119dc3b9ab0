#include "microslip/elasticity/creep_basis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace microslip {
namespace {

struct TimeRange {
  double shortest, longest; // [s]
};

void add_ranges(const PronySeries& series, std::vector<TimeRange>& ranges) {
  std::vector<double> times;
  for (const PronyTerm& term : series) times.push_back(term.time);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  const std::vector<MaterialCreep> creep = creep_of(series);
  for (std::size_t k = 0; k < times.size(); ++k) ranges.push_back({times[k], creep[k].time});
}

void add_ranges(const ViscoelasticMaterial& material, std::vector<TimeRange>& ranges) {
  add_ranges(material.shear_relaxation, ranges);
  if (material.bulk_relaxation) add_ranges(*material.bulk_relaxation, ranges);
}

/// Ranges of all materials, those that overlap joined.
std::vector<TimeRange> creep_ranges(const LayeredBody& body) {
  std::vector<TimeRange> ranges, joined;
  for (const BodyLayer& layer : body.layers) add_ranges(layer.material, ranges);
  add_ranges(body.substrate, ranges);
  std::sort(ranges.begin(), ranges.end(), [](auto a, auto b) { return a.shortest < b.shortest; });
  for (const TimeRange& range : ranges) {
    if (joined.empty() || range.shortest > joined.back().longest)
      joined.push_back(range);
    else
      joined.back().longest = std::max(joined.back().longest, range.longest);
  }
  return joined;
}

void add_chebyshev_times(const TimeRange& range, std::vector<double>& times) {
  constexpr double error = 1e-10;
  const double half = std::log(range.longest / range.shortest) / 2, middle = std::log(range.shortest) + half;
  const double d = std::numbers::pi / 2 / half;
  const auto count = static_cast<int>(std::ceil(-std::log(error) / std::asinh(d))) + 1;
  for (int k = 0; k < count; ++k)
    times.push_back(std::exp(middle - half * std::cos(std::numbers::pi * (k + 0.5) / count)));
}

std::vector<double> sample_frequencies(const std::vector<double>& times) {
  constexpr double beyond = 100, step = 0.3;
  const double low = std::log(1 / (beyond * times.back())), high = std::log(beyond / times.front());
  const auto steps = static_cast<int>((high - low) / step);
  std::vector<double> frequencies = {0};
  for (int k = 0; k <= steps; ++k) frequencies.push_back(std::exp(low + k * step));
  return frequencies;
}

using Column = std::vector<double>;

double dot(const Column& a, const Column& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}
void subtract(double factor, const Column& b, Column& a) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] -= factor * b[k];
}

/// Columns Q and the triangle R, A = Q R, by Gram and Schmidt's method, twice.
struct OrthogonalColumns {
  std::vector<Column> q, r; ///< r[column][row]

  explicit OrthogonalColumns(std::vector<Column> a) : q(std::move(a)), r(q.size(), Column(q.size())) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      for (int pass = 0; pass < 2; ++pass)
        for (std::size_t i = 0; i < j; ++i) {
          const double share = dot(q[i], q[j]);
          r[j][i] += share;
          subtract(share, q[i], q[j]);
        }
      r[j][j] = std::sqrt(dot(q[j], q[j]));
      for (double& value : q[j]) value /= r[j][j];
    }
  }
};

} // namespace

CreepBasis::CreepBasis(const LayeredBody& body) {
  constexpr double regularisation = 1e-9;
  for (const TimeRange& range : creep_ranges(body)) add_chebyshev_times(range, times_);
  if (times_.empty()) return;
  frequencies_ = sample_frequencies(times_);
  const std::size_t n = times_.size(), equations = 2 * frequencies_.size();
  std::vector<Column> columns(n, Column(equations + n));
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = 0; k < frequencies_.size(); ++k) {
      const std::complex<double> value = 1.0 / std::complex<double>(1, frequencies_[k] * times_[j]);
      columns[j][2 * k] = value.real(), columns[j][2 * k + 1] = value.imag();
    }
    columns[j][equations + j] = regularisation;
  }
  const OrthogonalColumns a(std::move(columns));
  for (std::size_t j = 0; j < n; ++j) {
    orthogonal_.insert(orthogonal_.end(), a.q[j].begin(), a.q[j].begin() + static_cast<std::ptrdiff_t>(equations));
    triangle_.insert(triangle_.end(), a.r[j].begin(), a.r[j].end());
  }
}

void CreepBasis::fit(std::span<const std::complex<double>> creep, std::span<double> amounts) const {
  const std::size_t n = times_.size();
  for (std::size_t j = 0; j < n; ++j) {
    const double* q = orthogonal_.data() + j * 2 * frequencies_.size();
    double sum = 0;
    for (std::size_t k = 0; k < creep.size(); ++k) sum += q[2 * k] * creep[k].real() + q[2 * k + 1] * creep[k].imag();
    amounts[j] = sum;
  }
  for (std::size_t i = n; i-- > 0;) { // R amounts = Q^T creep
    for (std::size_t j = i + 1; j < n; ++j) amounts[i] -= triangle_[j * n + i] * amounts[j];
    amounts[i] /= triangle_[i * n + i];
  }
}

} // namespace microslip
