#include "fit/further_measurements.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace microslip::fit {
namespace {

struct Plan {
  double least, largest, speed;
};

/// Points of one curve at the conditions of the first point.
io::MeasuredCurves points_of(const io::MeasuredCurves& curves, const Plan& plan, std::size_t count) {
  io::MeasuredCurves points = curves;
  points.points.assign(count, curves.points.front());
  for (std::size_t i = 0; i < count; ++i) {
    points.points[i].speed = plan.speed;
    points.points[i].creepage =
        plan.least * std::pow(plan.largest / plan.least, static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return points;
}

std::pair<double, double> range_of(const io::MeasuredCurves& curves) {
  const auto [least, largest] = std::minmax_element(curves.points.begin(), curves.points.end(),
                                                    [](auto& a, auto& b) { return a.creepage < b.creepage; });
  return {least->creepage, largest->creepage};
}

} // namespace

std::optional<FurtherMeasurement> further_measurement(const CurveFitter& fitter, const CurveFit& fit,
                                                      const std::vector<std::size_t>& counted,
                                                      const io::MeasuredCurves& curves, int elements) {
  constexpr double worthwhile = 0.7;
  const CurveFit free = fitter.freed(fit, counted);
  const std::size_t k = counted.size(), n = curves.points.size();
  const auto now = normal_matrix(free.jacobian, free.weights, k);
  const auto variances = inverse_of(now, k);
  const auto [least, largest] = range_of(curves);
  const double speed = curves.points.front().speed;
  const std::size_t count = std::max<std::size_t>(10, n / 5);
  const std::vector<double> weights(count, std::accumulate(free.weights.begin(), free.weights.end(), 0.) /
                                               static_cast<double>(n));
  std::optional<FurtherMeasurement> best;
  for (const Plan& plan : {Plan{least / 10, least, speed}, Plan{largest, 2 * largest, speed},
                           Plan{least, largest, speed / 2}, Plan{least, largest, speed * 2}}) {
    std::vector<double> with = now;
    try {
      const auto more =
          normal_matrix(curve_values(free, points_of(curves, plan, count), elements).jacobian, weights, k);
      for (std::size_t i = 0; i < with.size(); ++i) with[i] += more[i];
    } catch (const Error&) { // a creepage that is not solved
      continue;
    }
    const auto narrowed = inverse_of(with, k);
    for (std::size_t j = 0; j < k; ++j) {
      const double width = std::sqrt(narrowed[j * k + j] / variances[j * k + j]);
      if (width > worthwhile || (best && width >= best->width)) continue;
      best = {.parameter = counted[j],
              .points = count,
              .least_creepage = plan.least,
              .largest_creepage = plan.largest,
              .speed = plan.speed,
              .width = width};
    }
  }
  return best;
}

LargestDifference largest_difference(const CurveFit& first, const CurveFit& second, const io::MeasuredCurves& curves,
                                     int elements) {
  constexpr std::size_t count = 41;
  const auto [least, largest] = range_of(curves);
  const auto points = points_of(curves, {least / 10, 2 * largest, curves.points.front().speed}, count);
  const auto a = curve_values(first, points, elements).coefficients,
             b = curve_values(second, points, elements).coefficients;
  LargestDifference found;
  for (std::size_t i = 0; i < count; ++i)
    if (std::abs(a[i] - b[i]) > std::abs(found.first - found.second))
      found = {.creepage = points.points[i].creepage, .first = a[i], .second = b[i]};
  return found;
}

} // namespace microslip::fit
