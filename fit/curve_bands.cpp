#include "fit/curve_bands.hpp"

#include "fit/student.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <tuple>
#include <utility>

namespace microslip::fit {
namespace {

constexpr int points_of_curve = 81, resamples = 1000;

double norm_by(const std::vector<double>& matrix, const double* row, std::size_t k) {
  double sum = 0;
  for (std::size_t p = 0; p < k; ++p)
    for (std::size_t q = 0; q < k; ++q) sum += row[p] * matrix[p * k + q] * row[q];
  return std::sqrt(std::max(sum, 0.));
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), values.size() - 2);
  return values[below] + (at - static_cast<double>(below)) * (values[below + 1] - values[below]);
}

/// Changes of the working coordinates in wild resamples, by the derivatives: k numbers each.
std::vector<std::vector<double>> resampled(const CurveFit& fit, const io::MeasuredCurves& curves,
                                           const Covariances& covariances) {
  const std::size_t n = fit.weights.size(), k = fit.free.size();
  const auto bread = inverse_of(normal_matrix(fit.jacobian, fit.weights, k), k);
  std::mt19937 random(7);
  std::vector<std::vector<double>> changes;
  for (int sample = 0; sample < resamples; ++sample) {
    std::vector<double> slope(k, 0), change(k, 0);
    for (std::size_t i = 0; i < n; ++i) {
      const double deviation = (curves.points[i].coefficient - fit.coefficients[i]) / (1 - covariances.leverages[i]);
      const double signed_one = (random() & 1U) != 0 ? deviation : -deviation;
      for (std::size_t p = 0; p < k; ++p) slope[p] += fit.weights[i] * signed_one * fit.jacobian[i * k + p];
    }
    for (std::size_t p = 0; p < k; ++p)
      for (std::size_t q = 0; q < k; ++q) change[p] += bread[p * k + q] * slope[q];
    changes.push_back(std::move(change));
  }
  return changes;
}

/// Local standard deviation of the points at a creepage.
double scatter_at(double creepage, const CurveFit& fit, const io::MeasuredCurves& curves,
                  const Covariances& covariances) {
  constexpr double width = 0.3; // of the kernel, in the logarithm of the creepage
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < curves.points.size(); ++i) {
    const double apart = std::log(curves.points[i].creepage / creepage) / width, weight = std::exp(-apart * apart / 2);
    const double deviation = curves.points[i].coefficient - fit.coefficients[i];
    sum += weight * deviation * deviation / (1 - covariances.leverages[i]);
    weights += weight;
  }
  return std::sqrt(sum / weights);
}

/// Standard deviations of a further point that hold 95 % of the points, each left out of the fit by its leverage.
double prediction_factor(const CurveFit& fit, const io::MeasuredCurves& curves, const Covariances& covariances) {
  const std::size_t n = curves.points.size(), k = fit.free.size();
  std::vector<double> sizes;
  for (std::size_t i = 0; i < n; ++i) {
    const double deviation = std::abs(curves.points[i].coefficient - fit.coefficients[i]);
    const double local = std::hypot(scatter_at(curves.points[i].creepage, fit, curves, covariances),
                                    norm_by(covariances.robust, &fit.jacobian[i * k], k));
    sizes.push_back(deviation / (1 - covariances.leverages[i]) / local);
  }
  std::sort(sizes.begin(), sizes.end());
  const auto at = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(n + 1)));
  return sizes[std::min(std::max<std::size_t>(at, 1), n) - 1];
}

/// The curves that points have measured, each at creepages evenly over the logarithm.
io::MeasuredCurves grids_of(const io::MeasuredCurves& curves) {
  const auto conditions = [](const io::MeasuredPoint& point) {
    return std::tuple(point.run, point.speed, point.normal_force);
  };
  struct Range {
    io::MeasuredPoint point;
    double least, largest;
  };
  std::vector<Range> ranges;
  for (const io::MeasuredPoint& point : curves.points) {
    const auto found = std::find_if(ranges.begin(), ranges.end(),
                                    [&](const Range& range) { return conditions(range.point) == conditions(point); });
    if (found == ranges.end())
      ranges.push_back({point, point.creepage, point.creepage});
    else
      found->least = std::min(found->least, point.creepage), found->largest = std::max(found->largest, point.creepage);
  }
  io::MeasuredCurves grids = curves;
  grids.points.clear();
  for (const Range& range : ranges) {
    if (range.largest <= range.least) continue; // one point is no curve
    for (int i = 0; i < points_of_curve; ++i) {
      grids.points.push_back(range.point);
      grids.points.back().creepage =
          range.least * std::pow(range.largest / range.least, static_cast<double>(i) / (points_of_curve - 1));
    }
  }
  return grids;
}

/// What follows from a curve, of the fit and of each resample.
DerivedQuantity derive(const std::vector<std::vector<double>>& curves,
                       const std::function<double(const std::vector<double>&)>& quantity) {
  DerivedQuantity found{.value = quantity(curves.front())};
  std::vector<double> values;
  for (std::size_t k = 1; k < curves.size(); ++k) values.push_back(quantity(curves[k]));
  found.lower = quantile(values, 0.025), found.upper = quantile(std::move(values), 0.975);
  return found;
}

/// Where a curve is largest, and how large: the parabola through the three points about its largest.
std::pair<double, double> peak_of(const std::vector<double>& creepage, const std::vector<double>& f) {
  const auto at = static_cast<std::size_t>(std::max_element(f.begin(), f.end()) - f.begin());
  if (at == 0 || at + 1 == f.size()) return {creepage[at], f[at]};
  const double bend = f[at - 1] - 2 * f[at] + f[at + 1], rise = (f[at + 1] - f[at - 1]) / 2;
  if (bend >= 0) return {creepage[at], f[at]};
  const double step = -rise / bend; // in steps of the grid
  return {creepage[at] * std::pow(creepage[at + 1] / creepage[at], step), f[at] - rise * rise / (2 * bend)};
}

void derive_all(CurveBand& band, const std::vector<std::vector<double>>& curves) {
  constexpr std::size_t span = 8; // steps of the grid that a slope is found over
  using Values = std::vector<double>;
  band.peak = derive(curves, [&](const Values& f) { return peak_of(band.creepage, f).second; });
  band.creepage_at_peak = derive(curves, [&](const Values& f) { return peak_of(band.creepage, f).first; });
  band.last = derive(curves, [](const Values& f) { return f.back(); });
  band.slope =
      derive(curves, [&](const Values& f) { return (f[span] - f[0]) / (band.creepage[span] - band.creepage[0]); });
}

} // namespace

std::vector<CurveBand> curve_bands(const CurveFit& fit, const io::MeasuredCurves& curves, int elements) {
  const std::size_t k = fit.free.size();
  const io::MeasuredCurves grids = grids_of(curves);
  const CurveValues values = curve_values(fit, grids, elements);
  const Covariances covariances = covariances_of(fit, curves);
  const auto changes = resampled(fit, curves, covariances);
  const double factor = prediction_factor(fit, curves, covariances);
  const double t = student_quantile(0.95, static_cast<int>(curves.points.size() - k));
  std::vector<CurveBand> bands;
  for (std::size_t first = 0; first < grids.points.size(); first += points_of_curve) {
    CurveBand band{.conditions = grids.points[first]};
    for (std::size_t i = first; i < first + points_of_curve; ++i) {
      const double creepage = grids.points[i].creepage,
                   deviation = norm_by(covariances.robust, &values.jacobian[i * k], k);
      band.creepage.push_back(creepage);
      band.coefficient.push_back(values.coefficients[i]);
      band.half_width.push_back(t * deviation);
      band.scatter.push_back(scatter_at(creepage, fit, curves, covariances));
      const double reach = factor * std::hypot(band.scatter.back(), deviation);
      band.least_point.push_back(band.coefficient.back() - reach);
      band.largest_point.push_back(band.coefficient.back() + reach);
    }
    std::vector<std::vector<double>> all{band.coefficient};
    std::vector<double> largest;
    for (const auto& change : changes) {
      std::vector<double> curve = band.coefficient;
      double most = 0;
      for (std::size_t i = 0; i < curve.size(); ++i) {
        double moved = 0;
        for (std::size_t p = 0; p < k; ++p) moved += values.jacobian[(first + i) * k + p] * change[p];
        curve[i] += moved;
        if (band.half_width[i] > 0) most = std::max(most, std::abs(moved) / band.half_width[i]);
      }
      all.push_back(std::move(curve));
      largest.push_back(most);
    }
    band.simultaneous = quantile(std::move(largest), 0.95);
    derive_all(band, all);
    bands.push_back(std::move(band));
  }
  return bands;
}

} // namespace microslip::fit
